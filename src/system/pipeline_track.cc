// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// How the pipeline gives frames to the tracker, and again those in which the camera was lost.
#include <algorithm>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

#include "core/stopwatch.h"
#include "system/pipeline.h"

namespace yorb {
namespace {

constexpr size_t kMostWaiting = 100;  // frames of a lost camera

/// What the tracker says of a frame, with what is known from before.
FrameRecord Joined(const FrameRecord& before, const FrameRecord& tracked) {
  FrameRecord record = tracked;
  record.num_extracted = before.num_extracted;
  record.num_static = before.num_static;
  record.num_removed = before.num_removed;
  record.num_given_back = before.num_given_back;
  record.num_boxes = before.num_boxes;
  record.num_bridged = before.num_bridged;
  record.extract_ms = before.extract_ms;
  record.detect_ms = before.detect_ms;
  record.remove_ms = before.remove_ms;
  record.track_ms = before.track_ms;
  record.frame_total_ms = before.frame_total_ms;
  return record;
}

/// What tells the keypoints of one picture apart.
using Places = std::set<std::tuple<int, float, float>>;

std::tuple<int, float, float> PlaceOf(const Keypoint& point) { return {point.octave, point.x, point.y}; }

Places PlacesOf(const std::vector<Keypoint>& points) {
  Places places;
  for (const Keypoint& point : points) places.insert(PlaceOf(point));
  return places;
}

/// How many of the points that the tracker found to move were counted among the dynamic ones before.
int CountSuspects(const Frame& frame, const Places& moving) {
  if (moving.empty()) return 0;
  const auto first = frame.keypoints.end() - static_cast<std::ptrdiff_t>(frame.num_suspects);
  return static_cast<int>(std::count_if(first, frame.keypoints.end(),
                                        [&](const Keypoint& point) { return moving.count(PlaceOf(point)) > 0; }));
}

/// Marks as dynamic the points that the tracker found to move.
void MarkMoving(const std::vector<Keypoint>& points, const Places& moving, std::vector<Verdict>& verdicts) {
  if (moving.empty()) return;
  for (size_t i = 0; i < points.size(); ++i) {
    if (moving.count(PlaceOf(points[i])) > 0) verdicts[i] = Verdict::kDynamic;
  }
}

}  // namespace

/// Tracks a frame and gives its proposal away. Where a lost camera begins a new sub-map, the frames that it was lost in
/// are tracked again, in that: live, where the next picture does not wait, only the newest one.
/// False, and nothing more is tracked, once `give` says that nobody takes proposals any more.
bool Pipeline::TrackAll(Extracted extracted, const std::function<bool(Proposal)>& give) {
  const size_t most_waiting = mode_ == Mode::kLive ? 1 : kMostWaiting;
  std::deque<Extracted> queue;
  queue.push_back(std::move(extracted));
  while (!queue.empty()) {
    Extracted next = std::move(queue.front());
    queue.pop_front();
    Tracked tracked = Track(next);
    if (tracked.proposal && !give(*std::move(tracked.proposal))) return false;
    if (tracked.record.reference.IsValid()) {
      waiting_.clear();
    } else {
      waiting_.push_back(std::move(next));
      if (waiting_.size() > most_waiting) waiting_.pop_front();
    }
    if (!tracked.starts_over) continue;
    std::move(queue.begin(), queue.end(), std::back_inserter(waiting_));
    queue = std::exchange(waiting_, {});
  }
  return true;
}

Tracked Pipeline::Track(Extracted& extracted) {
  const Stopwatch watch;
  const size_t backlog = num_pending_;  // before the view: where nothing waits, it shows all keyframes
  const MapSnapshot map = view_.Get();
  Tracked tracked = tracker_.Track(extracted.frame, *map, backlog, extracted.sight);
  const Places moving = PlacesOf(tracked.moving);
  const int num_new = static_cast<int>(moving.size()) - CountSuspects(*extracted.frame, moving);
  extracted.record.num_static -= num_new;
  extracted.record.num_removed += num_new;
  const double track_ms = watch.ms();
  extracted.record.track_ms += track_ms;
  extracted.record.frame_total_ms += track_ms;
  log_.Add(Joined(extracted.record, tracked.record));
  if (extracted.judged) {
    Judged& judged = *extracted.judged;
    MarkMoving(judged.points, moving, judged.verdicts);
    parts_.watch({judged.images, judged.points, judged.verdicts, judged.areas});
    extracted.judged.reset();
  }
  return tracked;
}

}  // namespace yorb
