// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/result.h"

namespace yorb {

/// A box of the truth, in parts of the picture's width and height.
struct LabelBox {
  float cx = 0, cy = 0, width = 0, height = 0;
  int16_t class_index = 0;  ///< in the set's own list of classes
  int16_t is_doubtful = 0;  ///< 1: may or may not be there; neither rewarded nor punished
};

/// Reads YOLO text: `class cx cy width height` a line, more numbers being a polygon around the thing. A missing file is
/// a picture with nothing in it.
Result<std::vector<LabelBox>> ReadYoloLabels(const std::string& path, int num_classes);

/// Boxes of a teacher, `class cx cy width height confidence` a line, that are neither sure nor absurd: confidence in
/// [low, high). They come back as doubtful.
Result<std::vector<LabelBox>> ReadDoubtfulBoxes(const std::string& path, int num_classes, double low, double high);

/// The area that two boxes share, over the area that they cover together.
double IoU(const LabelBox& a, const LabelBox& b);

}  // namespace yorb
