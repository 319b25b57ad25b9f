// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Room: camera. What a camera is, and what it delivers.
// Takes: camera files (camera_io). Gives: Rig, ImageSet. Owns: nothing.
// Runs on: whichever thread calls. May not: know features or maps.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

namespace yorb {

/// A pinhole camera with Brown-Conrady or rational distortion. The picture's pixel (0, 0) is the centre of its upper
/// left pixel. Camera frame: x right, y down, z forward; metres.
struct Pinhole {
  double fx = 0, fy = 0, cx = 0, cy = 0;  ///< pixels
  int width = 0, height = 0;              ///< pixels; 0: not stated by the file
  /// k1 k2 p1 p2 k3 k4 k5 k6 in OpenCV's order; zeros where the file has fewer.
  std::array<double, 8> distortion{};

  bool HasDistortion() const;

  /// Where a point in front of the camera falls in the ideal (undistorted) picture.
  Eigen::Vector2d Project(const Eigen::Vector3d& x_in_cam) const {
    return {fx * x_in_cam.x() / x_in_cam.z() + cx, fy * x_in_cam.y() / x_in_cam.z() + cy};
  }

  /// The point at `depth` metres (along z) that falls on an ideal pixel.
  Eigen::Vector3d Unproject(double x_px, double y_px, double depth) const {
    return {(x_px - cx) / fx * depth, (y_px - cy) / fy * depth, depth};
  }

  /// Real (distorted) pixels to ideal ones.
  std::vector<Eigen::Vector2f> Undistort(const std::vector<Eigen::Vector2f>& distorted_px) const;

  /// An ideal pixel to the real one, the inverse of Undistort.
  Eigen::Vector2d Distort(const Eigen::Vector2d& ideal_px) const;
};

/// A range of ideal pixels; the undistorted picture is not a rectangle that starts at zero.
struct PixelBounds {
  float min_x = 0, max_x = 0, min_y = 0, max_y = 0;
  bool Contains(float x, float y) const { return x >= min_x && x < max_x && y >= min_y && y < max_y; }
};

/// One camera with its depth: an RGB-D sensor, seen as a stereo pair with a virtual right camera.
struct Rig {
  Pinhole camera;
  double baseline_px = 40.0;   ///< fx times the baseline in metres between the sensor's projector and its camera
  double close_factor = 40.0;  ///< points nearer than close_factor baselines are "close": their depth is trusted
  double depth_factor =
      5000;              ///< units of a 16-bit depth picture in one metre; 0: not stated, fine for float depth only
  double readout_s = 0;  ///< rolling shutter: from the first row of a picture to its last; 0: all rows at once
  double fps = 30;       ///< nominal rate of the colour pictures; 0: not stated (a Dataset fills it in)
  std::string name;      ///< of the file or the built-in camera, for messages

  /// Whether ideal pixels and disparities mean the same in both.
  bool ProjectsLike(const Rig& other) const;

  /// The disparity of a depth sensor is surer than the place of a corner: .5 pixels (Khoshelham and Oude Elberink,
  /// "Accuracy and Resolution of Kinect Depth Data for Indoor Mapping Applications", 2012) to 1. So the virtual right
  /// camera stands at twice the baseline: there one pixel is one standard deviation of both.
  static constexpr double kDisparitySigmaPx = 0.5;
  double VirtualBaselinePx() const { return baseline_px / kDisparitySigmaPx; }

  double CloseDepth() const { return close_factor * baseline_px / camera.fx; }

  /// The ideal pixels that the picture's border encloses.
  PixelBounds Bounds() const;

  /// What no such sensor has, in words: most likely a slip in the camera file. Empty where nothing is odd.
  std::string Oddity() const;
};

}  // namespace yorb
