// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace yorb {

/// A closed smooth way over the floor, walked by length.
class Route {
 public:
  struct Point {
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    double heading = 0;  ///< direction of walking, radians from x towards y
  };

  /// Through at least three points in turn and back to the first (Catmull-Rom).
  explicit Route(const std::vector<Eigen::Vector2d>& through);

  /// After `distance` metres; any number, rounds repeat.
  Point At(double distance) const;

  double length() const { return lengths_.back(); }

 private:
  std::vector<Eigen::Vector2d> points_;  // closely spaced; the last is the first again
  std::vector<double> lengths_;          // way to each point
};

}  // namespace yorb
