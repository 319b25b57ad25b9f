// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "runs/point_cloud.h"

namespace yorb {

/// Thins a cloud: of all points in one small cube of the world their mean stays, and the mean of their colours.
class VoxelGrid {
 public:
  explicit VoxelGrid(double side_m) : side_m_(side_m) {}

  void Add(const Eigen::Vector3d& point, const std::array<uint8_t, 3>& colour) {
    const auto [at, is_new] = index_of_.emplace(KeyOf(point), cubes_.size());
    if (is_new) cubes_.emplace_back();
    Cube& cube = cubes_[at->second];
    cube.sum += point;
    cube.colour_sum += Eigen::Vector3d(colour[0], colour[1], colour[2]);
    ++cube.count;
  }

  /// The means, in the order in which the cubes were first met.
  PointCloud Cloud() const {
    PointCloud cloud;
    for (const Cube& cube : cubes_) {
      cloud.points.push_back(cube.sum / cube.count);
      const Eigen::Vector3d colour = cube.colour_sum / cube.count;
      const auto byte = [](double value) { return static_cast<uint8_t>(std::lround(value)); };
      cloud.colours.push_back({byte(colour.x()), byte(colour.y()), byte(colour.z())});
    }
    return cloud;
  }

  size_t size() const { return cubes_.size(); }

 private:
  struct Cube {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero(), colour_sum = Eigen::Vector3d::Zero();
    double count = 0;
  };

  /// 21 bits an axis: with cubes of a centimetre, ten kilometres each way.
  uint64_t KeyOf(const Eigen::Vector3d& point) const {
    uint64_t key = 0;
    for (const double value : point) {
      const auto cell = static_cast<int64_t>(std::floor(value / side_m_));
      key = key << 21 | (static_cast<uint64_t>(cell) & 0x1fffff);
    }
    return key;
  }

  double side_m_;
  std::unordered_map<uint64_t, size_t> index_of_;
  std::vector<Cube> cubes_;
};

}  // namespace yorb
