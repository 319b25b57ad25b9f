// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "system/frame_log.h"

#include <algorithm>
#include <unordered_map>

namespace yorb {

void FrameLog::Add(const FrameRecord& record) {
  const std::lock_guard<std::mutex> lock(mutex_);
  records_.push_back(record);
  stage_ms_["extract"].push_back(record.extract_ms);
  if (record.detect_ms > 0) stage_ms_["detect"].push_back(record.detect_ms);
  stage_ms_["remove"].push_back(record.remove_ms);
  stage_ms_["track"].push_back(record.track_ms);
  stage_ms_["frame_total"].push_back(record.frame_total_ms);
}

void FrameLog::Add(const MappingTimes& times) {
  const std::lock_guard<std::mutex> lock(mutex_);
  stage_ms_["mapping"].push_back(times.total_ms);
  stage_ms_["insert"].push_back(times.insert_ms);
  stage_ms_["triangulate"].push_back(times.triangulate_ms);
  stage_ms_["fuse"].push_back(times.fuse_ms);
  if (!times.has_adjusted) return;
  stage_ms_["local_ba"].push_back(times.local_ba_ms);
  stage_ms_["cull"].push_back(times.cull_ms);
}

size_t FrameLog::num_frames() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return records_.size();
}

SlamReport FrameLog::Report(const Map& map) const {
  SlamReport report;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    report.frames = records_;
    report.stage_ms = stage_ms_;
  }
  // A frame that became a keyframe has the keyframe's own, adjusted pose.
  std::unordered_map<FrameId, Rigid3> keyframe_poses;
  map.VisitKeyframes([&](const Keyframe& keyframe) {
    keyframe_poses[keyframe.frame->id] = keyframe.cam_from_world;
    report.keyframes.push_back({keyframe.frame->timestamp, keyframe.cam_from_world.Inverse()});
  });
  // Those of a map that was loaded may be of any time.
  std::stable_sort(report.keyframes.begin(), report.keyframes.end(),
                   [](const StampedPose& a, const StampedPose& b) { return a.timestamp < b.timestamp; });
  for (const FrameRecord& record : report.frames) {
    if (record.state != TrackingState::kTracking) continue;
    const auto own = keyframe_poses.find(record.id);
    if (own != keyframe_poses.end()) {
      report.trajectory.push_back({record.timestamp, own->second.Inverse()});
      continue;
    }
    const auto reference = map.CamFromWorld(record.reference);
    if (!reference) continue;  // the first keyframe is still on its way into the map
    report.trajectory.push_back({record.timestamp, (record.cam_from_reference * *reference).Inverse()});
  }
  report.num_landmarks = map.num_landmarks();
  return report;
}

}  // namespace yorb
