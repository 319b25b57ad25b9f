// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "camera/rig.h"

#include <algorithm>
#include <opencv2/calib3d.hpp>

namespace yorb {
namespace {

cv::Matx33d Intrinsics(const Pinhole& camera) { return {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1}; }

}  // namespace

bool Pinhole::HasDistortion() const {
  return std::any_of(distortion.begin(), distortion.end(), [](double k) { return k != 0; });
}

std::vector<Eigen::Vector2f> Pinhole::Undistort(const std::vector<Eigen::Vector2f>& distorted_px) const {
  if (!HasDistortion() || distorted_px.empty()) return distorted_px;
  std::vector<Eigen::Vector2f> ideal(distorted_px.size());
  const cv::Mat in(static_cast<int>(distorted_px.size()), 1, CV_32FC2,
                   const_cast<Eigen::Vector2f*>(distorted_px.data()));
  cv::Mat out(in.rows, 1, CV_32FC2, ideal.data());
  // More rounds than OpenCV's five: strong rational lenses have not settled by then.
  const cv::TermCriteria until(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 20, 1e-4);
  cv::undistortPoints(in, out, Intrinsics(*this), distortion, cv::noArray(), Intrinsics(*this), until);
  return ideal;
}

Eigen::Vector2d Pinhole::Distort(const Eigen::Vector2d& ideal_px) const {
  const auto& k = distortion;
  const double x = (ideal_px.x() - cx) / fx, y = (ideal_px.y() - cy) / fy;
  const double r2 = x * x + y * y, r4 = r2 * r2, r6 = r4 * r2;
  const double radial = (1 + k[0] * r2 + k[1] * r4 + k[4] * r6) / (1 + k[5] * r2 + k[6] * r4 + k[7] * r6);
  const double x_d = x * radial + 2 * k[2] * x * y + k[3] * (r2 + 2 * x * x);
  const double y_d = y * radial + k[2] * (r2 + 2 * y * y) + 2 * k[3] * x * y;
  return {fx * x_d + cx, fy * y_d + cy};
}

PixelBounds Rig::Bounds() const {
  const float right = static_cast<float>(camera.width), bottom = static_cast<float>(camera.height);
  if (!camera.HasDistortion()) return {0, right, 0, bottom};
  const auto corner = camera.Undistort({{0, 0}, {right, 0}, {0, bottom}, {right, bottom}});
  return {std::min(corner[0].x(), corner[2].x()), std::max(corner[1].x(), corner[3].x()),
          std::min(corner[0].y(), corner[1].y()), std::max(corner[2].y(), corner[3].y())};
}

}  // namespace yorb
