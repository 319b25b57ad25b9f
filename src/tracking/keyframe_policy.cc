// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/keyframe_policy.h"

namespace yorb {
namespace {

/// Landmarks of the reference keyframe that enough keyframes agree on.
int CountFirmLandmarks(const Map& map, const Keyframe& reference) {
  const size_t min_views = map.num_keyframes() <= 2 ? 2 : 3;
  int count = 0;
  for (const LandmarkId id : reference.landmarks) {
    const Landmark* landmark = id.IsValid() ? map.Find(id) : nullptr;
    count += landmark && landmark->views.size() >= min_views;
  }
  return count;
}

/// Whether many close points are in view that the map does not know: the camera looks at something new.
bool NeedsClosePoints(const Frame& frame, const Fix& fix) {
  constexpr int kFewTracked = 100, kManyNew = 70;
  int num_tracked = 0, num_new = 0;
  for (size_t i = 0; i < frame.size(); ++i) {
    if (!frame.HasDepth(i) || frame.depth[i] > frame.rig->CloseDepth()) continue;
    ++(fix.matches[i].IsValid() ? num_tracked : num_new);
  }
  return num_tracked < kFewTracked && num_new > kManyNew;
}

/// Whether little of the picture is known while more of it could be: the next frames may find nothing to hold on to.
bool IsThin(const Frame& frame, const Fix& fix) {
  constexpr size_t kComfortable = 150;
  if (fix.num_inliers >= kComfortable) return false;
  size_t num_new = 0;
  for (size_t i = 0; i < frame.size(); ++i) num_new += frame.HasDepth(i) && !fix.matches[i].IsValid();
  return num_new > fix.num_inliers;
}

/// Whether the camera has gone far from the reference keyframe, compared with how far away the scene is.
bool IsFarFrom(const Keyframe& reference, const KeyframeQuestion& question, const TrackingOptions& options) {
  constexpr double kRadPerDeg = 0.017453292519943295;
  const Rigid3 step = question.fix.cam_from_world * reference.cam_from_world.Inverse();
  const double depth = question.frame.MedianDepth();
  return step.RotationAngle() > options.keyframe_turn_deg * kRadPerDeg ||
         (depth > 0 && step.translation.norm() > options.keyframe_shift * depth);
}

}  // namespace

bool IsKeyframeDue(const KeyframeQuestion& question, const TrackingOptions& options) {
  constexpr double kFewKeyframesRatio = 0.4, kWeakRatio = 0.25;
  constexpr size_t kMinInliers = 15;
  constexpr size_t kMaxBacklog = 3;
  const Keyframe* reference = question.map.Find(question.reference);
  if (!reference || question.frames_since_last < 1 || question.backlog >= kMaxBacklog) return false;

  const int num_firm = CountFirmLandmarks(question.map, *reference);
  const auto num_inliers = static_cast<double>(question.fix.num_inliers);
  const double ratio = question.map.num_keyframes() < 2 ? kFewKeyframesRatio : options.keyframe_ratio;
  const bool needs_close = NeedsClosePoints(question.frame, question.fix);

  const bool is_overdue = question.seconds_since_last >= options.keyframe_interval_s;
  const bool is_weak = num_inliers < kWeakRatio * num_firm || needs_close;
  const bool is_idle = question.backlog == 0;
  const bool has_changed = num_inliers < ratio * num_firm || needs_close || IsThin(question.frame, question.fix) ||
                           IsFarFrom(*reference, question, options);
  return (is_overdue || is_weak || is_idle) && has_changed && question.fix.num_in_all() > kMinInliers;
}

}  // namespace yorb
