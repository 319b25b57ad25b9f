// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "core/random.h"
#include "geometry/align.h"
#include "geometry/trajectory.h"

namespace yorb {

inline Timestamp AtMs(int64_t ms) { return Timestamp{1300000000000000000 + ms * 1000000}; }

inline Eigen::Vector3d RandomVector(Random& random) {
  const double x = random.Gaussian(), y = random.Gaussian(), z = random.Gaussian();
  return {x, y, z};
}

/// A smooth walk of so many poses, one every `step_ms`.
inline Trajectory SmoothWalk(size_t count, int64_t step_ms, int64_t start_ms = 0) {
  Trajectory walk;
  for (size_t i = 0; i < count; ++i) {
    const int64_t ms = start_ms + static_cast<int64_t>(i) * step_ms;
    const double s = 1e-3 * static_cast<double>(ms);
    const Eigen::Vector3d position(std::sin(0.9 * s), 0.7 * std::cos(0.5 * s), 0.2 * std::sin(1.7 * s) + 0.05 * s);
    const Eigen::Vector3d turn(0.3 * std::sin(s), 0.4 * std::cos(0.7 * s), 0.2 * s);
    walk.push_back({AtMs(ms), Rigid3(RotationFromVector(turn), position)});
  }
  return walk;
}

/// The walk with noise, seen from another world of another scale.
inline Trajectory Disturbed(const Trajectory& walk, double noise, const Alignment& motion, uint64_t seed) {
  Random random(seed);
  Trajectory disturbed;
  for (StampedPose pose : walk) {
    pose.world_from_cam.translation += noise * RandomVector(random);
    pose.world_from_cam.rotation = pose.world_from_cam.rotation * RotationFromVector(noise * RandomVector(random));
    disturbed.push_back({pose.timestamp, motion * pose.world_from_cam});
  }
  return disturbed;
}

/// A motion that is far from the identity.
inline Alignment SomeMotion(double scale) {
  Alignment motion;
  motion.rotation = RotationFromVector({0.3, -1.2, 0.8});
  motion.translation = {2, -1, 0.5};
  motion.scale = scale;
  return motion;
}

/// A file with this text; its name tells which test made it.
inline std::string TestFile(const std::string& name, const std::string& text) {
  const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::string path = ::testing::TempDir() + test->test_suite_name() + "_" + test->name() + "_" + name;
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

}  // namespace yorb
