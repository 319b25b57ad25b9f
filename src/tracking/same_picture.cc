// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/same_picture.h"

#include <algorithm>

namespace yorb {
namespace {

bool HaveSamePoints(const Frame& a, const Frame& b) {
  const auto is_same_place = [](const Keypoint& p, const Keypoint& q) { return p.x == q.x && p.y == q.y; };
  return a.descriptors == b.descriptors &&
         std::equal(a.keypoints.begin(), a.keypoints.end(), b.keypoints.begin(), b.keypoints.end(), is_same_place);
}

bool HaveSamePixels(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size()) return false;
  for (int y = 0; y < a.rows; ++y) {
    if (!std::equal(a.ptr(y), a.ptr(y) + a.cols, b.ptr(y))) return false;
  }
  return true;
}

}  // namespace

bool IsSamePicture(const PictureOfFrame& a, const PictureOfFrame& b) {
  if (a.frame.size() == 0 || b.frame.size() == 0) return false;
  const bool has_pixels = !a.grey.empty() && !b.grey.empty();
  return has_pixels ? HaveSamePixels(a.grey, b.grey) : HaveSamePoints(a.frame, b.frame);
}

}  // namespace yorb
