// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// What the tracker does with depth pictures: surfaces that hold an unsure pose; things that geometry finds to move,
// once the pose is known.
#include <utility>

#include "tracking/leave_out.h"
#include "tracking/tracker.h"

namespace yorb {

/// Surfaces of before, where the points alone leave a pose unsure: few, or all in one corner.
Planes Tracker::SurfacesFor(const Frame& frame, const Map& map, const Fix& fix) const {
  constexpr double kUnsureM = 0.01;
  if (depth_.empty() || fix.sigma_m < kUnsureM) return {};
  return surfaces_.Pair(depth_, *frame.rig, fix.cam_from_world, map);
}

/// Landmarks that the camera sees through are not there any more.
void Tracker::CountGone(const Frame& frame, const Map& map, const Located& located) {
  if (depth_.empty()) return;
  for (const LandmarkId id : located.visible) {
    const Landmark* landmark = id.IsValid() ? map.Find(id) : nullptr;
    if (landmark && IsSeenThrough(depth_, *frame.rig, located.fix.cam_from_world * landmark->position)) {
      ++counts_[id].gone;
    }
  }
}

/// Takes the points on what moves out of a frame and what was found of it; gives those points. Landmarks that move with
/// them, if only few keyframes know them, are as good as gone.
std::vector<Keypoint> Tracker::LeaveOutMovers(FramePtr& frame, const Map& map, Fix& fix) {
  constexpr size_t kEnoughMatches = 20;  // to find the pose anew without what moves
  if (depth_.empty()) return {};
  PosedFrame posed{frame, std::vector<bool>(frame->size()), {last_.reference, last_.cam_from_reference}};
  for (size_t i = 0; i < frame->size(); ++i) posed.is_known[i] = fix.matches[i].IsValid();
  const auto is_moving = PointsOnMovers(*frame, movers_.Find(std::move(posed), depth_, map));
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
  if (fix.num_inliers + fix.num_inliers_by_depth >= kEnoughMatches) fix = Refit(*frame, map, fix);
  return moving;
}

}  // namespace yorb
