// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace yorb {

/// Points of the world, perhaps with colours.
struct PointCloud {
  std::vector<Eigen::Vector3d> points;          ///< finite, metres
  std::vector<std::array<uint8_t, 3>> colours;  ///< red, green, blue of each point; or empty
};

/// The bytes of a PLY file: binary, little-endian, x y z as floats, red green blue as bytes.
std::string PlyBytes(const PointCloud& cloud);

/// The bytes of a PCD file, version 0.7: binary, x y z as floats, rgb packed as PCL packs it.
std::string PcdBytes(const PointCloud& cloud);

}  // namespace yorb
