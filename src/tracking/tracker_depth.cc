// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// What the tracker does with depth: points of the frame before that are no landmarks; surfaces that hold an unsure
// pose, and carry on where there is no point; things that geometry finds to move, once the pose is known.
#include <utility>

#include "tracking/leave_out.h"
#include "tracking/tracker.h"

namespace yorb {

void Tracker::AddDepthPointsOfLast(const Map& map, std::vector<KnownPoint>& points) const {
  const Frame& frame = *last_.frame;
  const Rigid3 world_from_cam = LastPose(map).Inverse();
  for (size_t i = 0; i < frame.size(); ++i) {
    if (!frame.HasDepth(i) || map.Find(map.Resolve(last_.matches[i]))) continue;
    const Keypoint& keypoint = frame.keypoints[i];
    points.push_back(
        {world_from_cam * frame.PointInCam(i), frame.descriptors[i], keypoint.octave, keypoint.angle_rad, {}});
  }
}

/// Surfaces of before and the camera's motion, where the points alone leave a pose unsure: few, or all in one corner.
Support Tracker::SupportFor(const Frame& frame, const Map& map, const Fix& fix) const {
  constexpr double kUnsureM = 0.01;
  if (fix.sigma_m < kUnsureM) return {};
  Support support;
  if (!sight_.depth.empty()) support.planes = surfaces_.Pair(sight_.depth, *frame.rig, fix.cam_from_world, map);
  if (state_ != TrackingState::kTracking) return support;
  if (const auto likely = motion_.Expect(last_.frame->timestamp, frame.timestamp)) {
    support.expected = ExpectedPose{likely->step * LastPose(map), likely->information};
  }
  return support;
}

/// Where the depth picture lies best on the surfaces of before, not far from where the camera should be by now. Nothing
/// where too little of them is in view.
std::optional<Rigid3> Tracker::PoseOnSurfaces(const Frame& frame, const Map& map) const {
  constexpr size_t kEnoughPairs = 50, kFewPairs = 20;  // at the end, and on the way there
  constexpr int kRounds = 6;
  constexpr double kTurnSigma = 0.1, kShiftSigmaM = 0.03;  // of the prediction
  if (sight_.depth.empty()) return std::nullopt;
  ExpectedPose expected{PredictedPose(frame, map), Matrix6d::Zero()};
  expected.information.diagonal().head<3>().setConstant(1 / (kTurnSigma * kTurnSigma));
  expected.information.diagonal().tail<3>().setConstant(1 / (kShiftSigmaM * kShiftSigmaM));
  Rigid3 pose = expected.cam_from_world;
  size_t num_pairs = 0;
  for (int k = 0; k < kRounds; ++k) {
    const Planes planes = surfaces_.Pair(sight_.depth, *frame.rig, pose, map);
    num_pairs = planes.size();
    if (num_pairs < kFewPairs) return std::nullopt;
    pose = AlignToPlanes(pose, planes, expected);
  }
  return num_pairs >= kEnoughPairs ? std::optional<Rigid3>(pose) : std::nullopt;
}

/// Surfaces say where to look for the points.
std::optional<Fix> Tracker::TrackFromSurfaces(const Frame& frame, const Map& map) const {
  const auto guess = PoseOnSurfaces(frame, map);
  if (!guess) return std::nullopt;
  std::vector<KnownPoint> points = LandmarksOfLast(map);
  AddDepthPointsOfLast(map, points);
  const auto radius_px = static_cast<float>(options_.search_radius_px);
  const std::vector<int> rows = MatchKnownPoints(frame, *guess, LastPose(map), points, radius_px);
  Fix fix = FixFromPoints(frame, *guess, points, rows, {surfaces_.Pair(sight_.depth, *frame.rig, *guess, map), {}, {}});
  if (fix.num_in_all() < kFewMatches) return std::nullopt;
  return fix;
}

/// Where hardly a point is left, walls and floors may carry on alone for some frames, if the camera goes on as it did.
/// Where they say nothing, and moving things hide much of the picture, its motion alone may, for a few steps as long as
/// those that it was seen in, if it was steady: a step unlike the one before may have been that of someone who filled
/// the picture.
std::optional<Fix> Tracker::TrackBlindly(const Frame& frame, const Map& map) const {
  constexpr int kMostOnSurfaces = 5, kMostByMotion = 3;  // frames in a row
  constexpr double kMuchHidden = 0.3;
  if (task_.only_locates || last_.num_blind >= kMostOnSurfaces) return std::nullopt;
  Fix fix;
  fix.matches.resize(frame.size());
  if (const auto pose = PoseOnSurfaces(frame, map)) {
    fix.cam_from_world = *pose;
    if (GoesOn(frame, map, fix)) return fix;
  }
  if (last_.num_blind >= kMostByMotion || sight_.hidden < kMuchHidden || !motion_.IsSteady(kEase)) return std::nullopt;
  fix.cam_from_world = PredictedPose(frame, map);
  return fix;
}

/// Landmarks that the camera sees through are not there any more.
void Tracker::CountGone(const Frame& frame, const Map& map, const Located& located) {
  if (sight_.depth.empty() || !task_.finds_movers) return;
  for (const LandmarkId id : located.visible) {
    const Landmark* landmark = id.IsValid() ? map.Find(id) : nullptr;
    if (landmark && IsSeenThrough(sight_.depth, *frame.rig, located.fix.cam_from_world * landmark->position)) {
      ++counts_[id].gone;
    }
  }
}

MovingCells Tracker::FindMovers(const FramePtr& frame, const Map& map, const Located& located) {
  if (sight_.depth.empty() || !task_.finds_movers) return {};
  PosedFrame posed{frame, std::vector<bool>(frame->size()), PlaceOf(located, map)};
  for (size_t i = 0; i < frame->size(); ++i) posed.is_known[i] = located.fix.matches[i].IsValid();
  return movers_.Find(std::move(posed), sight_.depth, map);
}

/// Takes the points on what moves out of a frame and what was found of it; gives those points. Landmarks that move with
/// them, if only few keyframes know them, are as good as gone.
std::vector<Keypoint> Tracker::LeaveOut(const MovingCells& movers, FramePtr& frame, const Map& map, Fix& fix,
                                        const Support& support) {
  constexpr size_t kEnoughMatches = 20;  // to find the pose anew without what moves
  const auto is_moving = PointsOnMovers(*frame, movers);
  std::vector<Keypoint> moving;
  for (size_t i = 0; i < is_moving.size(); ++i) {
    if (!is_moving[i]) continue;
    moving.push_back(frame->keypoints[i]);
    const Landmark* landmark = fix.matches[i].IsValid() ? map.Find(fix.matches[i]) : nullptr;
    if (!landmark) continue;
    --fix.num_inliers;
    if (landmark->IsGrownUp()) continue;
    --counts_[landmark->id].found;
    ++counts_[landmark->id].gone;
  }
  if (moving.empty()) return moving;
  frame = WithoutRows(frame, is_moving);
  fix.matches = WithoutRows(std::move(fix.matches), is_moving);
  fix.by_depth = WithoutRows(fix.by_depth, is_moving);
  if (fix.num_in_all() >= kEnoughMatches) fix = Refit(*frame, map, fix, support);
  return moving;
}

}  // namespace yorb
