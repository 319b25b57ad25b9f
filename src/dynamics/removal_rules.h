// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "detection/box.h"
#include "detection/motion_category.h"
#include "features/keypoint.h"

namespace yorb {

/// What is decided about a point before the pose is known.
enum class Verdict : uint8_t {
  kStatic,     ///< nothing says that it moves
  kDynamic,    ///< on something that moves: not for the tracker
  kGivenBack,  ///< in the box of something that moves and yet not on it: for the tracker
};

/// The words of points.csv: static, dynamic, given_back.
const char* ToString(Verdict verdict);

/// A box, and how the kind of thing in it moves.
struct SortedBox {
  Box box;
  Motion motion = Motion::kStatic;
};

std::vector<SortedBox> SortByMotion(const std::vector<Box>& boxes, const MotionTable& table);

/// Whether two boxes share any area.
bool Touch(const Box& a, const Box& b);

/// The paper's rules, box by box: a point in the box of a high-dynamic thing and in no static thing's is dynamic; so is
/// one in the box of a low-dynamic thing that overlaps a high-dynamic one's. Never gives points back.
class BoxRules {
 public:
  explicit BoxRules(const std::vector<SortedBox>& boxes);

  Verdict Judge(const Keypoint& point) const;

  /// The same for cells of depth (CV_8UC1, all 0): marks the dynamic ones; a box has the cells that it touches.
  void Mark(cv::Mat& cells) const;

 private:
  std::vector<Box> high_, still_;
  std::vector<Box> carried_;  ///< low-dynamic boxes that overlap a high-dynamic one
};

}  // namespace yorb
