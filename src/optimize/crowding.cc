// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/crowding.h"

#include <algorithm>
#include <cmath>

namespace yorb {

std::vector<double> SharesOfPlaces(const std::vector<Eigen::Vector2f>& points_px, const Rig& rig) {
  constexpr double kFew = 3;           // points for which a place counts at most
  constexpr int kColumns = 20;         // places side by side
  const Pinhole& camera = rig.camera;  // a size that is not stated is about twice the centre
  const double width = camera.width > 0 ? camera.width : 2 * camera.cx;
  const double height = camera.height > 0 ? camera.height : 2 * camera.cy;
  const double side_px = width / kColumns;
  const int rows = std::max(1, static_cast<int>(std::ceil(height / side_px)));
  const auto place_of = [side_px](float px, int count) {
    return static_cast<int>(std::clamp(px / side_px, 0.0, count - 1.0));
  };
  std::vector<int> counts(static_cast<size_t>(rows * kColumns), 0);
  std::vector<size_t> places(points_px.size());
  for (size_t i = 0; i < points_px.size(); ++i) {
    places[i] = static_cast<size_t>(place_of(points_px[i].y(), rows) * kColumns + place_of(points_px[i].x(), kColumns));
    ++counts[places[i]];
  }
  std::vector<double> shares(points_px.size());
  for (size_t i = 0; i < points_px.size(); ++i) shares[i] = std::min(1.0, kFew / counts[places[i]]);
  return shares;
}

}  // namespace yorb
