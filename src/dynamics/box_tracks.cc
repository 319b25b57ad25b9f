// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/box_tracks.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/iou.h"
#include "core/log.h"

namespace yorb {
namespace {

constexpr double kLeastOverlap = 0.25;  // IoU of a box and where it was expected
constexpr int kSeenToBridge = 2;        // looks; one false box is gone with the next look
constexpr double kBridgeS = 0.5;        // how long a detector may miss what it saw
constexpr double kBodyS = 1.5;          // the same while depth shows the body where it must be
constexpr double kUnlookedS = 1.0;      // the same while nobody looks: boxes of a slow detector
constexpr double kSeenForS = 0.25;      // how long what the last look saw is there as if it were seen
constexpr int kSureToFade = 2;          // looks that saw it surely, before it may be hardly seen
constexpr double kFadeS = 1.5;          // how long it may be so
constexpr double kSmoothing = 0.5;      // of velocities
constexpr size_t kMostBoxes = 1000;     // of one picture: all are compared with all that are followed

/// `box` after `seconds` of the track's motion.
Box Moved(Box box, const BoxTrack& track, double seconds) {
  box.left += track.x_per_s * seconds, box.right += track.x_per_s * seconds;
  box.top += track.y_per_s * seconds, box.bottom += track.y_per_s * seconds;
  return box;
}

/// `track` seen at `box` in the picture of `at`, told to the one of `now`.
void See(BoxTrack& track, const SortedBox& seen, bool is_sure, Timestamp at, Timestamp now) {
  const double seconds = SecondsBetween(track.seen_at, at);
  if (track.num_seen > 0 && seconds > 0) {
    const Box &from = track.seen_box, &to = seen.box;
    const double x_per_s = (to.left + to.right - from.left - from.right) / 2 / seconds;
    const double y_per_s = (to.top + to.bottom - from.top - from.bottom) / 2 / seconds;
    track.x_per_s += kSmoothing * (x_per_s - track.x_per_s);
    track.y_per_s += kSmoothing * (y_per_s - track.y_per_s);
  }
  track.seen_box = seen.box;
  track.seen_at = at;
  track.at = {Moved(seen.box, track, SecondsBetween(at, now)), seen.motion};
  track.last_seen = now;
  ++track.num_seen;
  track.is_faint = !is_sure;
  if (!is_sure) return;
  ++track.num_sure;
  track.last_sure = now;
}

/// Whether what is hardly seen may go on from a track: it was seen surely, more than once and not long ago.
bool MayFade(const BoxTrack& track, Timestamp now) {
  return track.num_sure >= kSureToFade && SecondsBetween(track.last_sure, now) <= kFadeS;
}

/// The boxes of what moves, and no more of them than are followed.
std::vector<SortedBox> MovingOf(const std::vector<Box>& boxes, const MotionTable& table) {
  std::vector<SortedBox> moving = SortByMotion(boxes, table);
  const auto is_static = [](const SortedBox& sorted) { return sorted.motion == Motion::kStatic; };
  moving.erase(std::remove_if(moving.begin(), moving.end(), is_static), moving.end());
  if (moving.size() <= kMostBoxes) return moving;
  LogWarning("boxes-many", "a picture has " + std::to_string(moving.size()) + " boxes of what moves; the " +
                               std::to_string(kMostBoxes) +
                               " surest are followed (were they written without a threshold of confidence?)");
  std::stable_sort(moving.begin(), moving.end(),
                   [](const SortedBox& a, const SortedBox& b) { return a.box.confidence > b.box.confidence; });
  moving.resize(kMostBoxes);
  return moving;
}

}  // namespace

bool BoxTracks::IsSure(const SortedBox& seen) const {
  constexpr double kRarer = 2;  // rooms hold far more people than animals: a cat of .3 is a plant more often than not
  const bool is_rare = seen.box.name == "cat" || seen.box.name == "dog";
  return seen.box.confidence >= sure_confidence_ * (is_rare ? kRarer : 1);
}

void BoxTracks::MoveTo(Timestamp now, int width, int height) {
  const double seconds = last_ ? SecondsBetween(*last_, now) : 0;
  for (BoxTrack& track : tracks_) track.at.box = Cut(Moved(track.at.box, track, seconds), width, height);
  last_ = now;
}

void BoxTracks::Match(Timestamp now, Timestamp at, const std::vector<SortedBox>& seen) {
  const double age_s = SecondsBetween(at, now);
  struct Pair {
    double overlap;
    bool is_sure;
    size_t track, box;
  };
  std::vector<Pair> pairs;
  std::vector<bool> is_seen_surely;
  for (const SortedBox& one : seen) is_seen_surely.push_back(IsSure(one));
  for (size_t t = 0; t < tracks_.size(); ++t) {
    const Box then = Moved(tracks_[t].at.box, tracks_[t], -age_s);
    const bool may_fade = MayFade(tracks_[t], now);
    for (size_t b = 0; b < seen.size(); ++b) {
      if (tracks_[t].at.motion != seen[b].motion || (!is_seen_surely[b] && !may_fade)) continue;
      const double overlap = IoU(then, seen[b].box);
      if (overlap >= kLeastOverlap) pairs.push_back({overlap, is_seen_surely[b], t, b});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return a.is_sure != b.is_sure ? a.is_sure : a.overlap > b.overlap;
  });
  std::vector<bool> is_track_done(tracks_.size()), is_box_done(seen.size());
  for (const Pair& pair : pairs) {
    if (is_track_done[pair.track] || is_box_done[pair.box]) continue;
    is_track_done[pair.track] = is_box_done[pair.box] = true;
    See(tracks_[pair.track], seen[pair.box], pair.is_sure, at, now);
  }
  for (size_t b = 0; b < seen.size(); ++b) {
    if (is_box_done[b] || !is_seen_surely[b]) continue;
    BoxTrack track;
    See(track, seen[b], true, at, now);
    tracks_.push_back(track);
  }
}

void BoxTracks::Update(Timestamp now, const SeenAt& looked, const MotionTable& table, int width, int height) {
  MoveTo(now, width, height);
  if (looked.seen.has_looked) {
    last_look_ = now;
    if (looked.seen.says_nobody) tracks_.clear();
    Match(now, looked.at, MovingOf(looked.seen.boxes, table));
    last_look_of_ = looked.at;
  } else if (SecondsBetween(last_look_of_, now) <= kSeenForS) {
    for (BoxTrack& track : tracks_) {
      if (track.seen_at == last_look_of_) track.last_seen = now;
    }
  }
  // A box is given up when the detector looked for long enough without finding it, or nobody looked for longer.
  const auto is_over = [&](const BoxTrack& track) {
    if (!HasArea(track.at.box)) return true;
    if (!track.IsBridged(now)) return false;
    const bool was_missed = track.last_seen < last_look_;
    if (was_missed && track.num_seen < kSeenToBridge) return true;
    const double missed_s = SecondsBetween(track.last_seen, now);
    const bool has_body = track.body && SecondsBetween(track.body_seen, now) < kBridgeS;
    return missed_s > (!was_missed ? kUnlookedS : has_body ? kBodyS : kBridgeS);
  };
  tracks_.erase(std::remove_if(tracks_.begin(), tracks_.end(), is_over), tracks_.end());
}

}  // namespace yorb
