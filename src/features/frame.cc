// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/frame.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

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

FramePtr WithoutRows(const FramePtr& frame, const std::vector<bool>& is_marked) {
  auto rest = std::make_shared<Frame>(*frame);
  rest->keypoints = WithoutRows(std::move(rest->keypoints), is_marked);
  rest->points_px = WithoutRows(std::move(rest->points_px), is_marked);
  rest->depth = WithoutRows(std::move(rest->depth), is_marked);
  rest->right_px = WithoutRows(std::move(rest->right_px), is_marked);
  rest->descriptors = WithoutRows(std::move(rest->descriptors), is_marked);
  rest->grid = Grid(rest->bounds, rest->points_px);
  rest->num_suspects = 0;
  return rest;
}

}  // namespace yorb
