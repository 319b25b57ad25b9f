// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// What the tracker does with the pixels themselves: it follows points that descriptors do not find again.
#include <algorithm>
#include <numeric>

#include "tracking/shutter.h"
#include "tracking/tracker.h"

namespace yorb {
namespace {

/// The rows of the strongest corners, in their order.
std::vector<size_t> Strongest(const Frame& frame, size_t num_wanted) {
  std::vector<size_t> rows(frame.size());
  std::iota(rows.begin(), rows.end(), size_t{0});
  if (rows.size() <= num_wanted) return rows;
  const auto is_stronger = [&](size_t a, size_t b) {
    const float first = frame.keypoints[a].response, second = frame.keypoints[b].response;
    return first != second ? first > second : a < b;
  };
  std::nth_element(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(num_wanted), rows.end(), is_stronger);
  rows.resize(num_wanted);
  std::sort(rows.begin(), rows.end());
  return rows;
}

}  // namespace

/// Known points of the frame before, strong corners only, and where they are expected in this picture.
Tracker::Followed Tracker::PointsToFollow(const Frame& frame, const Map& map) const {
  constexpr size_t kMost = 300;
  const Frame& last = *last_.frame;
  const Pinhole& camera = frame.rig->camera;
  const cv::Rect2f picture(0, 0, static_cast<float>(sight_.grey.cols), static_cast<float>(sight_.grey.rows));
  const Rigid3 world_from_last = LastPose(map).Inverse(), predicted = PredictedPose(frame, map);
  Followed followed;
  for (const size_t i : Strongest(last, kMost)) {
    const Landmark* landmark = map.Find(map.Resolve(last_.matches[i]));
    if (!landmark && !last.HasDepth(i)) continue;
    PoseObservation point;
    point.x_in_world = landmark ? landmark->position : world_from_last * last.PointInCam(i);
    point.weight = landmark ? TrustIn(*landmark, map) : kTrustInNew;
    const Eigen::Vector3d x_in_cam = predicted * point.x_in_world;
    if (!(x_in_cam.z() > 0)) continue;
    const Eigen::Vector2f to_px = camera.Distort(camera.Project(x_in_cam)).cast<float>();
    if (!picture.contains(cv::Point2f(to_px.x(), to_px.y()))) continue;
    followed.guesses.push_back({{last.keypoints[i].x, last.keypoints[i].y}, to_px});
    followed.points.push_back(point);
  }
  return followed;
}

/// Where optical flow sees known points of the frame before; this one need not have corners there.
std::vector<PoseObservation> Tracker::FollowPointsOfLast(const Frame& frame, const Map& map) const {
  constexpr double kSigmaPx = 1.5;
  const Rig& rig = *frame.rig;
  auto [guesses, points] = PointsToFollow(frame, map);
  const auto found = FollowByFlow(last_.grey, sight_.grey, guesses);
  std::vector<Eigen::Vector2f> real_px;
  for (const auto& px : found) real_px.push_back(px.value_or(Eigen::Vector2f::Zero()));
  const std::vector<Eigen::Vector2f> ideal_px = rig.camera.Undistort(real_px);
  const Rigid3 predicted = PredictedPose(frame, map);
  const auto rate = motion_.RateWhileReading(rig.readout_s);
  std::vector<PoseObservation> seen;
  for (size_t i = 0; i < points.size(); ++i) {
    if (!found[i]) continue;
    Eigen::Vector2d px = ideal_px[i].cast<double>();
    if (rig.readout_s > 0 && rate) {
      const Rigid3 to_row = MotionToRow(rig, *rate, static_cast<double>(real_px[i].y()));
      const double depth = (predicted * points[i].x_in_world).z();
      px = rig.camera.Project(to_row.Inverse() * rig.camera.Unproject(px.x(), px.y(), depth));
    }
    points[i].seen.x_px = px.x();
    points[i].seen.y_px = px.y();
    points[i].seen.inverse_variance = 1 / (kSigmaPx * kSigmaPx);
    seen.push_back(points[i]);
  }
  return seen;
}

/// Optical flow says where to look for the points, if the camera goes on as it did. Corners are more exact; where too
/// few of them are left, the flow itself holds the pose.
std::optional<Fix> Tracker::TrackFromLastByFlow(const Frame& frame, const Map& map) const {
  constexpr size_t kFewFollowed = 10, kEnoughCorners = 50;
  constexpr float kRadiusPx = 3;
  if (sight_.grey.empty() || last_.grey.size() != sight_.grey.size()) return std::nullopt;
  Support support;
  support.followed = FollowPointsOfLast(frame, map);
  const std::vector<int> no_rows(frame.size(), -1);
  Fix fix = FixFromPoints(frame, PredictedPose(frame, map), {}, no_rows, support);
  if (fix.followed.size() < kFewFollowed || !IsConvincing(fix) || !GoesOn(frame, map, fix)) return std::nullopt;
  std::vector<KnownPoint> points = LandmarksOfLast(map);
  AddDepthPointsOfLast(map, points);
  const auto rows = MatchKnownPoints(frame, fix.cam_from_world, LastPose(map), points, kRadiusPx);
  Support beside = SupportFor(frame, map, fix);
  fix = FixFromPoints(frame, fix.cam_from_world, points, rows, beside);
  if (fix.num_in_all() >= kEnoughCorners && IsConvincing(fix)) return fix;
  beside.followed = std::move(support.followed);
  fix = FixFromPoints(frame, fix.cam_from_world, points, rows, beside);
  if (fix.num_in_all() < kFewMatches) return std::nullopt;
  return fix;
}

}  // namespace yorb
