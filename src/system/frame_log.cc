// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "system/frame_log.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "optimize/smooth_trajectory.h"

namespace yorb {
namespace {

/// The pose of a frame by the newest map, and the root of its sub-map.
struct Placed {
  Rigid3 cam_from_world;
  KeyframeId root;
};

std::optional<Placed> Place(const FrameRecord& record, const Map& map,
                            const std::unordered_map<FrameId, KeyframeId>& keyframe_of) {
  if (record.state != TrackingState::kTracking) return std::nullopt;
  // A frame that became a keyframe has the keyframe's own, adjusted pose.
  const auto own = keyframe_of.find(record.id);
  if (own != keyframe_of.end()) return Placed{map.Find(own->second)->cam_from_world, map.Find(own->second)->root};
  const auto reference = map.CamFromWorld(record.reference);
  if (!reference) return std::nullopt;  // the first keyframe is still on its way into the map
  return Placed{record.cam_from_reference * *reference, map.Find(map.Surviving(record.reference))->root};
}

/// Keyframes of a map that was loaded may be of any time.
void SortByTime(Trajectory& poses) {
  std::stable_sort(poses.begin(), poses.end(),
                   [](const StampedPose& a, const StampedPose& b) { return a.timestamp < b.timestamp; });
}

/// The frames of one sub-map on their way into its trajectory.
struct Path {
  std::vector<MeasuredPose> measured;
  std::vector<std::pair<Timestamp, size_t>> frames;  ///< with rows of `measured`: a repeated picture has one pose

  void Add(const FrameRecord& record, const Rigid3& cam_from_world) {
    const bool is_known = record.is_repeated && !measured.empty();
    if (!is_known) measured.push_back({record.timestamp, cam_from_world, record.information});
    frames.emplace_back(record.timestamp, measured.size() - 1);
  }

  Trajectory ToTrajectory(bool smooth) const {
    const std::vector<Rigid3> poses = smooth ? SmoothTrajectory(measured) : std::vector<Rigid3>();
    Trajectory trajectory;
    trajectory.reserve(frames.size());
    for (const auto& [timestamp, row] : frames) {
      trajectory.push_back({timestamp, (smooth ? poses[row] : measured[row].cam_from_world).Inverse()});
    }
    return trajectory;
  }
};

/// The sub-maps, those that were there from the beginning first, then the one with most frames of this run.
std::vector<SubmapReport> SubmapsOf(const std::vector<FrameRecord>& records, const Map& map, KeyframeId first_own,
                                    bool smooth) {
  std::map<uint32_t, SubmapReport> by_root;
  std::map<uint32_t, Path> paths;
  std::unordered_map<FrameId, KeyframeId> keyframe_of;
  map.VisitKeyframes([&](const Keyframe& keyframe) {
    keyframe_of[keyframe.frame->id] = keyframe.id;
    by_root[keyframe.root.value()].keyframes.push_back({keyframe.frame->timestamp, keyframe.cam_from_world.Inverse()});
  });
  for (const FrameRecord& record : records) {
    const auto placed = Place(record, map, keyframe_of);
    if (!placed) continue;
    paths[placed->root.value()].Add(record, placed->cam_from_world);
  }
  for (const auto& [root, path] : paths) by_root[root].trajectory = path.ToTrajectory(smooth);
  std::vector<SubmapReport> submaps;
  size_t num_old = 0;
  for (auto& [root, submap] : by_root) {
    num_old += KeyframeId(root) < first_own;
    submap.root = KeyframeId(root);
    SortByTime(submap.keyframes);
    submaps.push_back(std::move(submap));
  }
  const auto has_more = [](const SubmapReport& a, const SubmapReport& b) {
    return a.trajectory.size() > b.trajectory.size();
  };
  const auto own = submaps.begin() + static_cast<std::ptrdiff_t>(num_old);
  std::stable_sort(submaps.begin(), own, has_more);
  std::stable_sort(own, submaps.end(), has_more);
  if (submaps.empty()) submaps.emplace_back();
  return submaps;
}

}  // namespace

void FrameLog::Add(const FrameRecord& record) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto is_older = [&](const FrameRecord& other) { return other.id < record.id; };
  const auto known = std::partition_point(records_.begin(), records_.end(), is_older);
  if (known != records_.end() && known->id == record.id) {
    *known = record;
    return;
  }
  records_.insert(known, record);
  stage_ms_["extract"].push_back(record.extract_ms);
  if (record.detect_ms > 0) stage_ms_["detect"].push_back(record.detect_ms);
  stage_ms_["remove"].push_back(record.remove_ms);
  stage_ms_["track"].push_back(record.track_ms);
  stage_ms_["frame_total"].push_back(record.frame_total_ms);
}

void FrameLog::Add(const MappingTimes& times) {
  const std::lock_guard<std::mutex> lock(mutex_);
  num_landmarks_gone_ += times.num_landmarks_gone;
  stage_ms_["mapping"].push_back(times.total_ms);
  stage_ms_["insert"].push_back(times.insert_ms);
  stage_ms_["triangulate"].push_back(times.triangulate_ms);
  stage_ms_["fuse"].push_back(times.fuse_ms);
  if (!times.has_adjusted) return;
  stage_ms_["local_ba"].push_back(times.local_ba_ms);
  stage_ms_["cull"].push_back(times.cull_ms);
}

void FrameLog::Add(const std::string& stage, double ms) {
  const std::lock_guard<std::mutex> lock(mutex_);
  stage_ms_[stage].push_back(ms);
}

size_t FrameLog::num_frames() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return records_.size();
}

SlamReport FrameLog::Report(const Map& map, KeyframeId first_own, bool smooth) const {
  SlamReport report;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    report.frames = records_;
    report.stage_ms = stage_ms_;
    report.num_landmarks_gone = num_landmarks_gone_;
  }
  report.submaps = SubmapsOf(report.frames, map, first_own, smooth);
  report.num_keyframes = map.num_keyframes();
  report.num_landmarks = map.num_landmarks();
  report.num_loops = map.num_loops();
  return report;
}

}  // namespace yorb
