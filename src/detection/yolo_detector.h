// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "detection/decode.h"
#include "detection/detector.h"
#include "detection/engine.h"
#include "detection/network.h"

namespace yorb {

/// A network of the YOLO family: our own, or any export whose layout is recognised.
class YoloDetector : public Detector {
 public:
  /// Opens the network, chooses an engine, recognises the layout, and says all of it in one log line. Bad input names
  /// the file and what is wrong with it.
  static Result<std::unique_ptr<YoloDetector>> Open(const DetectionOptions& options);

  Result<Detections> Detect(const ImageSet& images) override;

  /// The class names in the network's order.
  const std::vector<std::string>& names() const { return names_; }

  /// "XNNPACK", "OpenCV DNN": which engine runs it.
  std::string engine_name() const { return engine_->name(); }

  /// Of the network's input, px.
  cv::Size input_size() const { return {input_.width, input_.height}; }

  /// Every class of a box that reaches the confidence makes a box of its own, as evaluations of many classes want it.
  void TakeAllClasses() { decode_.takes_all_classes = true; }

 private:
  YoloDetector() = default;

  std::string NameOf(int label) const;

  EngineInput input_;
  std::unique_ptr<Engine> engine_;
  HeadLayout layout_;
  DecodeOptions decode_;
  double most_overlap_ = 0;
  std::vector<std::string> names_;
};

/// The network that comes with the program: models/yolo_mo.onnx. Bad input where it is not there.
Result<std::string> DefaultNetwork();

}  // namespace yorb
