// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic/route.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace yorb {

Route::Route(const std::vector<Eigen::Vector2d>& through) {
  YORB_CHECK(through.size() >= 3, "a route needs three points");
  constexpr int kSteps = 64;
  const size_t n = through.size();
  for (size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d &p0 = through[(i + n - 1) % n], &p1 = through[i], &p2 = through[(i + 1) % n],
                          &p3 = through[(i + 2) % n];
    for (int k = 0; k < kSteps; ++k) {
      const double t = static_cast<double>(k) / kSteps;
      points_.push_back(0.5 * (2 * p1 + (p2 - p0) * t + (2 * p0 - 5 * p1 + 4 * p2 - p3) * t * t +
                               (3 * p1 - p0 - 3 * p2 + p3) * t * t * t));
    }
  }
  points_.push_back(points_.front());
  lengths_.push_back(0);
  for (size_t i = 1; i < points_.size(); ++i)
    lengths_.push_back(lengths_.back() + (points_[i] - points_[i - 1]).norm());
}

Route::Point Route::At(double distance) const {
  const auto on_round = [&](double d) -> Eigen::Vector2d {
    d -= length() * std::floor(d / length());
    const size_t after = std::clamp<size_t>(std::upper_bound(lengths_.begin(), lengths_.end(), d) - lengths_.begin(), 1,
                                            points_.size() - 1);
    const double t = (d - lengths_[after - 1]) / std::max(lengths_[after] - lengths_[after - 1], 1e-12);
    return points_[after - 1] + t * (points_[after] - points_[after - 1]);
  };
  constexpr double kLook = 0.12;  // metres ahead and behind: a body turns smoothly
  const Eigen::Vector2d along = on_round(distance + kLook) - on_round(distance - kLook);
  return {on_round(distance), std::atan2(along.y(), along.x())};
}

}  // namespace yorb
