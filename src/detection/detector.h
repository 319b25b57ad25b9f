// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Room: detection. From a picture to boxes with class names.
// Takes: ImageSet, networks (ONNX), box files. Gives: Detections. Owns: the engine of a network.
// Runs on: whichever thread calls Detect, one at a time. May not: know features, poses or what is done with the boxes.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "camera/image_set.h"
#include "core/options.h"
#include "core/result.h"
#include "detection/box.h"

namespace yorb {

/// What a detector has to say of one picture.
struct Detections {
  bool has_looked = true;    ///< false: nobody looked at this picture (a box file without a line for it)
  std::vector<Box> boxes;    ///< by falling confidence; none: nothing is there
  bool says_nobody = false;  ///< a box file that lists none: what was seen before is gone, and not missed
  /// How likely each part of the picture shows somebody: CV_8UC1, a pixel a cell of an even grid over all of it; 255 is
  /// a person beyond doubt. Empty where the detector says boxes alone.
  cv::Mat people;
};

/// Finds things in pictures.
class Detector {
 public:
  virtual ~Detector() = default;

  /// The boxes in one picture. An error means that the detector cannot go on.
  virtual Result<Detections> Detect(const ImageSet& images) = 0;
};

/// Sees nothing in any picture.
class NullDetector : public Detector {
 public:
  Result<Detections> Detect(const ImageSet&) override { return Detections{}; }
};

/// The network, and what counts as seen.
struct DetectionOptions {
  std::string model;              ///< an ONNX file; empty: models/yolo_mo.onnx of this installation
  double confidence = 0.25;       ///< boxes below it are not reported
  double faint_confidence = 0.1;  ///< dynamics full: weaker boxes down to this one follow what was seen before
  double interval_s = 0;          ///< dynamics full: least time between two pictures that the network looks at
  double most_overlap = 0.45;     ///< of two boxes of one class (IoU); beyond it the weaker one is a double
  int width = 0;                  ///< of the network's input, px; 0: as its file says
  int height = 0;                 ///< the same
  std::string engine = "auto";    ///< auto: the fastest that knows all operators of the network
  int threads = 1;                ///< of the engine; more of them pay on idle machines only

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("model", self.model, AnyValue());
    visit("confidence", self.confidence, Range(0.001, 1));
    visit("faint_confidence", self.faint_confidence, Range(0.001, 1));
    visit("interval_s", self.interval_s, Range(0, 10));
    visit("most_overlap", self.most_overlap, Range(0.01, 1));
    visit("width", self.width, Range(0, 4096));
    visit("height", self.height, Range(0, 4096));
    visit("engine", self.engine, OneOf({"auto", "xnnpack", "opencv", "onnxruntime"}));
    visit("threads", self.threads, Range(1, 64));
  }
};

/// A picture without a moment, as a detector takes it. `bgr`: CV_8UC3, or CV_8UC1 where it is grey.
ImageSet ImageSetOf(const cv::Mat& bgr);

}  // namespace yorb
