// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/frame.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace yorb {

ScaleTable::ScaleTable(int levels, double scale_factor) : factor(scale_factor) {
  for (int level = 0; level < levels; ++level) {
    const double s = std::pow(scale_factor, level);
    scale.push_back(static_cast<float>(s));
    inverse_variance.push_back(static_cast<float>(1.0 / (s * s)));
  }
}

float Frame::MedianDepth() const {
  std::vector<float> measured;
  std::copy_if(depth.begin(), depth.end(), std::back_inserter(measured), [](float d) { return d > 0; });
  if (measured.empty()) return 0;
  const auto middle = measured.begin() + static_cast<std::ptrdiff_t>(measured.size() / 2);
  std::nth_element(measured.begin(), middle, measured.end());
  return *middle;
}

FramePtr WithoutSuspects(const FramePtr& frame, const std::function<bool(size_t)>& is_cleared) {
  if (frame->num_suspects == 0) return frame;
  auto rest = std::make_shared<Frame>(*frame);
  size_t kept = frame->size() - frame->num_suspects;
  for (size_t i = kept; i < frame->size(); ++i) {
    if (!is_cleared(i)) continue;
    rest->keypoints[kept] = frame->keypoints[i];
    rest->points_px[kept] = frame->points_px[i];
    rest->depth[kept] = frame->depth[i];
    rest->right_px[kept] = frame->right_px[i];
    rest->descriptors[kept] = frame->descriptors[i];
    ++kept;
  }
  rest->keypoints.resize(kept);
  rest->points_px.resize(kept);
  rest->depth.resize(kept);
  rest->right_px.resize(kept);
  rest->descriptors.resize(kept);
  rest->grid = Grid(rest->bounds, rest->points_px);
  rest->num_suspects = 0;
  return rest;
}

}  // namespace yorb
