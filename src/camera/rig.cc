// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "camera/rig.h"

#include <algorithm>
#include <opencv2/calib3d.hpp>

#include "core/text.h"

namespace yorb {
namespace {

cv::Matx33d Intrinsics(const Pinhole& camera) { return {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1}; }

/// Whether the pixels about the picture's border come back from the ideal picture to where they were.
bool IsDistortionSound(const Pinhole& camera) {
  constexpr double kMostPx = 2;
  const auto right = static_cast<float>(camera.width - 1), bottom = static_cast<float>(camera.height - 1);
  std::vector<Eigen::Vector2f> border;
  for (const float share : {0.f, 0.25f, 0.5f, 0.75f, 1.f}) {
    border.insert(border.end(),
                  {{share * right, 0}, {share * right, bottom}, {0, share * bottom}, {right, share * bottom}});
  }
  const auto ideal = camera.Undistort(border);
  for (size_t i = 0; i < border.size(); ++i) {
    const double off_px = (camera.Distort(ideal[i].cast<double>()) - border[i].cast<double>()).norm();
    if (!(off_px < kMostPx)) return false;
  }
  return true;
}

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

bool Rig::ProjectsLike(const Rig& other) const {
  const Pinhole &a = camera, &b = other.camera;
  return a.fx == b.fx && a.fy == b.fy && a.cx == b.cx && a.cy == b.cy && baseline_px == other.baseline_px;
}

PixelBounds Rig::Bounds() const {
  const float right = static_cast<float>(camera.width), bottom = static_cast<float>(camera.height);
  if (!camera.HasDistortion()) return {0, right, 0, bottom};
  const auto corner = camera.Undistort({{0, 0}, {right, 0}, {0, bottom}, {right, bottom}});
  return {std::min(corner[0].x(), corner[2].x()), std::max(corner[1].x(), corner[3].x()),
          std::min(corner[0].y(), corner[1].y()), std::max(corner[2].y(), corner[3].y())};
}

std::string Rig::Oddity() const {
  constexpr double kLeast = 0.02, kMost = 20;  // picture widths in a focal length: views of 1 and of 170 degrees
  constexpr double kUnlike = 3, kShortest = 1e-3, kLongest = 3;
  const double across = camera.width / camera.fx, down = camera.height / camera.fy;
  if (std::max(across, down) < kLeast || std::min(across, down) > kMost) {
    return "fx " + FormatShortest(camera.fx) + " and fy " + FormatShortest(camera.fy) + " do not go with pictures of " +
           std::to_string(camera.width) + "x" + std::to_string(camera.height);
  }
  if (std::max(camera.fx, camera.fy) > kUnlike * std::min(camera.fx, camera.fy)) return "fx and fy are very unlike";
  if (!IsDistortionSound(camera)) return "its distortion cannot be undone at the border of the picture";
  const double baseline = baseline_px / camera.fx;
  if (baseline < kShortest || baseline > kLongest) {
    return "its baseline comes out as " + FormatShortest(baseline) + " m (bf is fx times the baseline)";
  }
  return "";
}

}  // namespace yorb
