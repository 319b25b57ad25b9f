// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "features/frame.h"
#include "geometry/line_sight.h"
#include "geometry/rigid3.h"

namespace yorb {

struct Keyframe;
struct Landmark;
using KeyframeId = Id<Keyframe>;
using LandmarkId = Id<Landmark>;

/// What complaints call them.
inline std::string NameOf(KeyframeId id) { return "keyframe " + std::to_string(id.value()); }
inline std::string NameOf(LandmarkId id) { return "landmark " + std::to_string(id.value()); }

/// Where the tracker stands.
enum class TrackingState {
  kNotInitialized,  ///< nothing has been seen yet that a map could begin with
  kTracking,        ///< this frame's pose is confirmed by matches
  kRecentlyLost,    ///< not confirmed, for a moment only so far
  kLost,            ///< sought among the keyframes
};

/// The words of frames.csv: not_initialized, tracking, recently_lost, lost.
const char* ToString(TrackingState state);

/// What became of one picture. The pose is relative to a keyframe: only the map knows where keyframes are, so that a
/// correction of the map moves the past trajectory with it.
struct FrameRecord {
  FrameId id;
  Timestamp timestamp;
  TrackingState state = TrackingState::kNotInitialized;
  KeyframeId reference;  ///< valid where the pose is confirmed (state kTracking)
  Rigid3 cam_from_reference;
  Matrix6d information = Matrix6d::Zero();  ///< of the pose by the points of the picture, as in PoseEstimate
  bool is_repeated = false;  ///< the very picture that the last confirmed frame shows, with that frame's pose
  int num_extracted = 0;
  int num_static = 0;      ///< left to the tracker
  int num_removed = 0;     ///< as dynamic
  int num_given_back = 0;  ///< inside a box and yet static
  int num_boxes = 0;       ///< of moving things
  int num_bridged = 0;     ///< of these: not detected in this picture
  int num_matched = 0;
  int num_inliers = 0;
  bool is_keyframe = false;
  double extract_ms = 0, detect_ms = 0, remove_ms = 0, track_ms = 0;
  double frame_total_ms = 0;  ///< from taking the picture up to its pose, boxes waited for, without waiting in queues
};

/// How often the tracker expected and found a landmark since it last said so, and how often it was seen to have gone.
struct LandmarkCount {
  LandmarkId id;
  int visible = 0, found = 0, gone = 0;
};

/// What is known of how a keyframe lies to another one beside the landmarks that both see.
struct Tie {
  KeyframeId other;
  Rigid3 cam_from_other;
  /// Of the step by which the pose may be off: `cam_from_world = Rigid3::FromStep(step) * cam_from_other *
  /// other_from_world`. Zero: nothing is known.
  Matrix6d information = Matrix6d::Zero();
};

/// What the tracker asks of the map: this frame should be a keyframe. The tracker itself writes nothing.
struct Proposal {
  FramePtr frame;
  KeyframeId reference;  ///< not valid: the map begins with this frame
  Rigid3 cam_from_reference;
  std::vector<LandmarkId> matches;  ///< a row a keypoint; inliers only
  std::vector<LandmarkCount> counts;
  Matrix6d information = Matrix6d::Zero();  ///< of cam_from_reference beside the landmarks, as in Tie
  LineSightsPtr lines;                      ///< the straight edges of the picture
};

}  // namespace yorb
