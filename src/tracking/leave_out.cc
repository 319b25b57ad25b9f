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

std::vector<bool> DoubtfulSuspects(const Frame& frame, const std::vector<LandmarkId>& matches) {
  std::vector<bool> is_doubtful(frame.size(), false);
  for (size_t i = frame.size() - frame.num_suspects; i < frame.size(); ++i) is_doubtful[i] = !matches[i].IsValid();
  return is_doubtful;
}

std::vector<DepthPoint> WithoutRows(const std::vector<DepthPoint>& points, const std::vector<bool>& is_marked) {
  std::vector<uint32_t> new_row(is_marked.size());
  uint32_t num_kept = 0;
  for (size_t i = 0; i < is_marked.size(); ++i) new_row[i] = is_marked[i] ? num_kept : num_kept++;
  std::vector<DepthPoint> kept;
  for (const DepthPoint& point : points) {
    if (!is_marked[point.row]) kept.push_back({new_row[point.row], point.x_in_world});
  }
  return kept;
}

}  // namespace yorb
