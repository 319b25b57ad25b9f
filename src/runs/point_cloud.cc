// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/point_cloud.h"

#include <algorithm>
#include <limits>

#include "map/bytes.h"
#include "runs/version.h"

namespace yorb {
namespace {

bool HasColours(const PointCloud& cloud) { return !cloud.colours.empty(); }

void PutPoint(const Eigen::Vector3d& point, ByteWriter& bytes) {
  constexpr double kMost = std::numeric_limits<float>::max();
  for (const double value : point) bytes.Put(static_cast<float>(std::clamp(value, -kMost, kMost)));
}

}  // namespace

std::string PlyBytes(const PointCloud& cloud) {
  std::string head = "ply\nformat binary_little_endian 1.0\ncomment yorb " + std::string(Version()) +
                     ", metres\nelement vertex " + std::to_string(cloud.points.size()) +
                     "\nproperty float x\nproperty float y\nproperty float z\n";
  if (HasColours(cloud)) head += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  ByteWriter bytes;
  for (size_t i = 0; i < cloud.points.size(); ++i) {
    PutPoint(cloud.points[i], bytes);
    if (HasColours(cloud)) bytes.PutRow(cloud.colours[i].data(), 3);
  }
  return head + "end_header\n" + bytes.bytes();
}

std::string PcdBytes(const PointCloud& cloud) {
  const std::string count = std::to_string(cloud.points.size());
  const bool has_colours = HasColours(cloud);
  const std::string head = std::string("# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n") +
                           (has_colours ? "FIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\n"
                                        : "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n") +
                           "WIDTH " + count + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count +
                           "\nDATA binary\n";
  ByteWriter bytes;
  for (size_t i = 0; i < cloud.points.size(); ++i) {
    PutPoint(cloud.points[i], bytes);
    if (!has_colours) continue;
    const auto& [red, green, blue] = cloud.colours[i];
    bytes.Put(static_cast<uint32_t>(red << 16 | green << 8 | blue));
  }
  return head + bytes.bytes();
}

}  // namespace yorb
