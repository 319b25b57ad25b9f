// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// What makes the tracker believe a pose, and one rather than another.
#include "tracking/tracker.h"

namespace yorb {

bool Tracker::IsConvincing(const Fix& fix) {
  constexpr double kShare = 0.6;
  return static_cast<double>(fix.num_in_all()) >= kShare * static_cast<double>(fix.num_matched);
}

bool Tracker::IsConfirmed(const Frame& frame, const Map& map, const Fix& fix) const {
  constexpr double kWarySeconds = 1.0;
  const bool is_wary = was_lost_ && SecondsBetween(lost_since_, frame.timestamp) < kWarySeconds;
  int needed = is_wary ? options_.min_inliers_after_loss : options_.min_inliers;
  // Where people hide the view, a few points say enough, if they agree and the camera goes on as it did; as it was last
  // seen to, for of what was only expected that proves nothing.
  const bool was_sighted = last_.num_blind == 0;
  if (was_sighted && IsConvincing(fix) && GoesOn(frame, map, fix)) needed = options_.min_inliers_going_on;
  // Without a mapper that takes in what is new, points of the frame before lead away from the map unnoticed.
  const size_t num_inliers = task_.only_locates ? fix.num_inliers : fix.num_in_all();
  return num_inliers >= static_cast<size_t>(needed) && fix.cam_from_world.IsFinite();
}

/// Whether the camera can have come there from the frame before. Where much speaks for the pose, that does not count.
bool Tracker::IsPlausible(const Frame& frame, const Map& map, const Fix& fix) const {
  constexpr size_t kMany = 150;
  constexpr double kMost = 0.6;
  const auto num_inliers = fix.num_in_all();
  const bool is_sure =
      num_inliers >= kMany && static_cast<double>(num_inliers) >= kMost * static_cast<double>(fix.num_matched);
  if (is_sure || !last_.frame || state_ == TrackingState::kLost) return true;
  return motion_.CanReach(last_.frame->timestamp, frame.timestamp, fix.cam_from_world * LastPose(map).Inverse());
}

/// Whether the camera moves on about as it did in the frame before.
bool Tracker::GoesOn(const Frame& frame, const Map& map, const Fix& fix) const {
  if (state_ != TrackingState::kTracking || !motion_.rate()) return false;
  const Rigid3 step = fix.cam_from_world * LastPose(map).Inverse();
  return motion_.CanReach(last_.frame->timestamp, frame.timestamp, step, kEase);
}

/// How much speaks for a pose, in matches: twice as much where the camera only goes on as it did.
size_t Tracker::Speaking(const Frame& frame, const Map& map, const Fix& fix) const {
  return fix.num_in_all() * (GoesOn(frame, map, fix) ? 2 : 1);
}

}  // namespace yorb
