// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "detection/decode.h"
#include "detection/detector.h"
#include "detection/engine.h"
#include "detection/network.h"
#include "detection/shaped_engine.h"

namespace yorb {

/// A network of the YOLO family: our own, or any export whose layout is recognised.
class YoloDetector : public Detector {
 public:
  /// Opens the network, chooses an engine, recognises the layout, and says all of it in one log line. Bad input names
  /// the file and what is wrong with it.
  static Result<std::unique_ptr<YoloDetector>> Open(const DetectionOptions& wanted);

  Result<Detections> Detect(const ImageSet& images) override;

  /// The class names in the network's order.
  const std::vector<std::string>& names() const { return names_; }

  /// "XNNPACK", "OpenCV DNN": which engine runs it.
  std::string engine_name() const { return own_.engine->name(); }

  /// Of the network's input, px, as it was opened.
  cv::Size input_size() const { return own_.size(); }

  /// From now on each picture is looked at in its own shape, scaled so that its longer side has `long_sides_px` (none:
  /// as many as the file names under `stills`; where it names none, nothing changes). Where there are several, it is
  /// looked at with each, every second time mirrored, and what was seen is put together (`FuseLooks`): slower, and
  /// surer. For stills: each shape costs an engine. Bad input where the network runs at its own size alone.
  Status FitToPictures(std::vector<int> long_sides_px);

  /// Every class of a box that reaches the confidence makes a box of its own, as evaluations of many classes want it.
  void TakeAllClasses() { decode_.takes_all_classes = true; }

 private:
  YoloDetector() = default;

  std::string NameOf(int label) const;

  /// Tells an engine what of its outputs is decoded: where objectness is too low, nothing else.
  void ReadOnlyWhatCounts(ShapedEngine& shaped) const;

  /// The boxes of outputs, once it is sure that they are in pixels.
  Result<std::vector<RawBox>> Decode(const std::vector<TensorView>& outputs, const HeadLayout& layout);

  /// The engine for a picture of this size, scaled to a longer side. It stays for kMostLooks further calls at least.
  Result<ShapedEngine*> EngineFor(const cv::Size& picture, int long_side_px);

  /// What the network sees in a picture, doubles suppressed; where people are goes into `people`, if it says that.
  Result<std::vector<Box>> Look(const ImageSet& images, ShapedEngine& shaped, cv::Mat* people = nullptr);

  /// What it sees in the looks of FitToPictures, on as many threads as the machine has.
  Result<std::vector<Box>> LookAtStill(const ImageSet& images);

  DetectionOptions options_;
  ShapedEngine own_;                                   // of the size that the network was opened with
  std::optional<Network> stills_;                      // what engines of other sizes are made of
  std::vector<int> long_sides_px_;                     // of a picture that is looked at in its own shape, a look each
  std::vector<std::unique_ptr<ShapedEngine>> others_;  // of other sizes, the one asked for last behind
  DecodeOptions decode_;
  bool has_people_ = false;    // the last output is a map of people
  bool is_in_pixels_ = false;  // a box has shown it: from then on a tiny one in the corner is nothing odd
  std::vector<std::string> names_;
};

/// The network that comes with the program: models/yolo_mo.onnx. Bad input where it is not there.
Result<std::string> DefaultNetwork();

}  // namespace yorb
