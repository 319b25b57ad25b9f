// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "core/random.h"
#include "map/map.h"
#include "motion/depth_grid.h"

namespace yorb {

/// A box with sides along the axes; metres in the world (x right, y down, z ahead).
struct TestBox {
  Eigen::Vector3d least, most;
};

/// Where a ray enters a box, in units of the ray; nothing where it misses.
inline std::optional<double> EntersAt(const Eigen::Vector3d& origin, const Eigen::Vector3d& ray, const TestBox& box) {
  double enter = 0, leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (box.least[axis] - origin[axis]) / ray[axis], b = (box.most[axis] - origin[axis]) / ray[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (enter <= 0 || enter > leave) return std::nullopt;
  return enter;
}

/// An RGB-D sensor of small pictures.
inline Rig DepthTestRig() {
  Rig rig;
  rig.camera.fx = rig.camera.fy = 260;
  rig.camera.cx = 159.5;
  rig.camera.cy = 119.5;
  rig.camera.width = 320;
  rig.camera.height = 240;
  rig.baseline_px = 40;
  return rig;
}

/// A depth picture of boxes, ray by ray, with the sensor's noise, and for each pixel which box it shows.
struct TestView {
  DepthImage depth;
  cv::Mat box;  ///< CV_8UC1: index of the box and one; 0: nothing
};

inline TestView LookAtBoxes(const Rig& rig, const Rigid3& cam_from_world, const std::vector<TestBox>& boxes,
                            Random& random) {
  const Pinhole& camera = rig.camera;
  constexpr double kNoisePx = 0.1;  // of disparity, between neighbouring pixels
  TestView view{{cv::Mat::zeros(camera.height, camera.width, CV_32FC1), 1},
                cv::Mat::zeros(camera.height, camera.width, CV_8UC1)};
  const Rigid3 world_from_cam = cam_from_world.Inverse();
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const Eigen::Vector3d ray = world_from_cam.rotation * camera.Unproject(x, y, 1);
      double nearest = std::numeric_limits<double>::infinity();
      for (size_t i = 0; i < boxes.size(); ++i) {
        const auto metres = EntersAt(world_from_cam.translation, ray, boxes[i]);
        if (!metres || *metres >= nearest) continue;
        nearest = *metres;
        view.box.at<uint8_t>(y, x) = static_cast<uint8_t>(i + 1);
      }
      if (!std::isfinite(nearest)) continue;
      const double disparity_px = rig.baseline_px / nearest + kNoisePx * random.Gaussian();
      view.depth.pixels.at<float>(y, x) = static_cast<float>(rig.baseline_px / disparity_px);
    }
  }
  return view;
}

/// A map with one keyframe at the origin of the world, for cameras to be relative to.
inline Map MapWithOneKeyframe() {
  Map map;
  map.AddKeyframe(std::make_shared<Frame>(), Rigid3::Identity(), KeyframeId());
  return map;
}

}  // namespace yorb
