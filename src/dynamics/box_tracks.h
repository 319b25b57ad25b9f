// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/time.h"
#include "detection/detector.h"
#include "dynamics/body.h"
#include "dynamics/removal_rules.h"

namespace yorb {

/// What a detector said, and of which picture.
struct SeenAt {
  Detections seen;
  Timestamp at;  ///< not later than the picture that is judged
};

/// Something that moves, followed from picture to picture.
struct BoxTrack {
  SortedBox at;                     ///< where it is now: seen there, or expected there
  int num_seen = 0;                 ///< in how many pictures that the detector looked at
  int num_sure = 0;                 ///< in how many of them surely
  Timestamp last_sure;              ///< the newest of these
  Timestamp last_seen;              ///< the picture for which the detector last had news of it
  Box seen_box;                     ///< where the detector saw it then,
  Timestamp seen_at;                ///< and in which picture, which may be an older one
  bool is_faint = false;            ///< hardly seen: alone, the box would say nothing
  std::optional<BodyMemory> body;   ///< where it was last found; for whoever looks for bodies
  Timestamp body_seen;              ///< and when
  double x_per_s = 0, y_per_s = 0;  ///< motion of the box's middle, px/s

  bool IsBridged(Timestamp now) const { return last_seen < now; }
};

/// Bridges what a detector misses, and the pictures that it does not look at, where for a moment what it saw last is as
/// good as seen. A box that was seen in two pictures stays, moving on at constant velocity, for a while after the
/// detector lost it, and for longer while its body is found there. Static things are not followed: depth tells what is
/// a body. What a detector hardly sees continues for a while what it saw surely, and more than once, but begins
/// nothing. Where a box file says that nobody is there, nothing is bridged. Of a picture's boxes of what moves the
/// thousand surest are followed.
class BoxTracks {
 public:
  /// `sure_confidence`: boxes of people below it begin nothing; those of pets need more.
  explicit BoxTracks(double sure_confidence = 0) : sure_confidence_(sure_confidence) {}

  /// Takes what was seen for the picture at `now` (later than the time before); boxes of an older picture move on to
  /// now with what they belong to. Afterwards `tracks` holds all that must be assumed to be there. `width`, `height`:
  /// of the picture, px.
  void Update(Timestamp now, const SeenAt& looked, const MotionTable& table, int width, int height);

  std::vector<BoxTrack>& tracks() { return tracks_; }

 private:
  bool IsSure(const SortedBox& seen) const;
  void MoveTo(Timestamp now, int width, int height);
  /// `seen`: of what moves.
  void Match(Timestamp now, Timestamp at, const std::vector<SortedBox>& seen);

  double sure_confidence_;
  std::vector<BoxTrack> tracks_;
  std::optional<Timestamp> last_;
  Timestamp last_look_;     ///< when there was news last,
  Timestamp last_look_of_;  ///< and of which picture
};

}  // namespace yorb
