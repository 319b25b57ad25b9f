// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/leave_out.h"

namespace yorb {

std::vector<bool> PointsOnMovers(const Frame& frame, const MovingCells& moving) {
  if (moving.empty()) return {};
  std::vector<bool> is_on(frame.size(), false);
  bool any = false;
  for (size_t i = 0; i < frame.size(); ++i) {
    is_on[i] = moving.Has(frame.points_px[i].x(), frame.points_px[i].y(), frame.depth[i]);
    any |= is_on[i];
  }
  return any ? is_on : std::vector<bool>();
}

FramePtr WithoutRows(const FramePtr& frame, const std::vector<bool>& is_marked) {
  auto rest = std::make_shared<Frame>(*frame);
  rest->keypoints = WithoutRows(std::move(rest->keypoints), is_marked);
  rest->points_px = WithoutRows(std::move(rest->points_px), is_marked);
  rest->depth = WithoutRows(std::move(rest->depth), is_marked);
  rest->right_px = WithoutRows(std::move(rest->right_px), is_marked);
  rest->descriptors = WithoutRows(std::move(rest->descriptors), is_marked);
  rest->grid = Grid(rest->bounds, rest->points_px);
  return rest;
}

}  // namespace yorb
