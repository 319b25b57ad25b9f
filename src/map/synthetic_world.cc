// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/synthetic_world.h"

#include <cmath>
#include <limits>

namespace yorb {
namespace {

Rig TestRig() {
  Rig rig;
  rig.camera.fx = rig.camera.fy = 500;
  rig.camera.cx = 320;
  rig.camera.cy = 240;
  rig.camera.width = 640;
  rig.camera.height = 480;
  rig.name = "synthetic";
  return rig;
}

/// A point on the back wall, a side wall, the floor or the ceiling.
Eigen::Vector3d PointOnWall(Random& random) {
  const double x = random.Uniform(-3, 3), y = random.Uniform(-1.5, 1.5), z = random.Uniform(-4, 2);
  switch (random.Below(6)) {
    case 0:
      return {-3, y, z};
    case 1:
      return {3, y, z};
    case 2:
      return {x, 1.5, z};
    case 3:
      return {x, -1.5, z};
    default:
      return {x, y, 2 - random.Uniform(0, 0.5)};
  }
}

Descriptor Flip(Descriptor descriptor, double bits, Random& random) {
  for (int k = 0; k < 256; ++k) {
    if (random.Uniform() * 256 < bits) descriptor[static_cast<size_t>(k / 64)] ^= uint64_t{1} << (k % 64);
  }
  return descriptor;
}

}  // namespace

SyntheticWorld::SyntheticWorld(uint64_t seed, const SyntheticWorldOptions& options)
    : options_(options),
      seed_(seed),
      rig_(std::make_shared<const Rig>(TestRig())),
      scales_(std::make_shared<const ScaleTable>(8, 1.2)) {
  Random random(seed);
  for (int i = 0; i < options.num_points; ++i) {
    Point point;
    point.x_in_world = PointOnWall(random);
    for (uint64_t& word : point.descriptor) word = random.Next();
    point.size = random.Uniform(2, 8);
    points_.push_back(point);
  }
}

SyntheticWorld::View SyntheticWorld::Look(const Rigid3& cam_from_world, FrameId id, Timestamp time) const {
  auto frame = std::make_shared<Frame>();
  frame->id = id;
  frame->timestamp = time;
  frame->rig = rig_;
  frame->scales = scales_;
  frame->bounds = rig_->Bounds();
  View view;
  Random random(seed_, id.value() + 1);
  for (uint32_t i = 0; i < points_.size(); ++i) {
    const Eigen::Vector3d x_in_cam = cam_from_world * points_[i].x_in_world;
    if (x_in_cam.z() < 0.3) continue;
    const double octave = std::ceil(std::log(points_[i].size / x_in_cam.norm()) / std::log(scales_->factor));
    if (octave < 0 || octave >= scales_->levels()) continue;
    const double noise_px = options_.pixel_noise * scales_->scale[static_cast<size_t>(octave)];
    Eigen::Vector2d px = rig_->camera.Project(x_in_cam);
    px += noise_px * Eigen::Vector2d(random.Gaussian(), random.Gaussian());
    if (!frame->bounds.Contains(static_cast<float>(px.x()), static_cast<float>(px.y()))) continue;
    const double disparity_px = rig_->VirtualBaselinePx() / x_in_cam.z() + options_.depth_noise * random.Gaussian();
    const bool has_depth = disparity_px > 0 && random.Uniform() < options_.depth_share;
    Keypoint keypoint;
    keypoint.x = static_cast<float>(px.x());
    keypoint.y = static_cast<float>(px.y());
    keypoint.octave = static_cast<int>(octave);
    frame->keypoints.push_back(keypoint);
    frame->points_px.emplace_back(keypoint.x, keypoint.y);
    frame->depth.push_back(has_depth ? static_cast<float>(rig_->VirtualBaselinePx() / disparity_px) : 0.f);
    frame->right_px.push_back(has_depth ? static_cast<float>(px.x() - disparity_px)
                                        : std::numeric_limits<float>::quiet_NaN());
    frame->descriptors.push_back(Flip(points_[i].descriptor, options_.flipped_bits, random));
    view.points.push_back(i);
  }
  frame->grid = Grid(frame->bounds, frame->points_px);
  view.frame = frame;
  return view;
}

}  // namespace yorb
