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

}  // namespace yorb
