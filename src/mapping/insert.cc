// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/insert.h"

#include <algorithm>

namespace yorb {

KeyframeId InsertKeyframe(Map& map, const Proposal& proposal) {
  const KeyframeId reference = map.Surviving(proposal.reference);
  Rigid3 cam_from_world = proposal.cam_from_reference;
  if (proposal.reference.IsValid()) cam_from_world = cam_from_world * *map.CamFromWorld(proposal.reference);
  const KeyframeId id = map.AddKeyframe(proposal.frame, cam_from_world, reference);
  if (reference.IsValid() && !proposal.information.isZero()) {
    const Rigid3 cam_from_reference = cam_from_world * map.Find(reference)->cam_from_world.Inverse();
    map.SetTie(id, {reference, cam_from_reference, proposal.information});
  }
  map.SetLines(id, proposal.lines);
  for (const LandmarkCount& count : proposal.counts) map.Count(map.Resolve(count.id), count.visible, count.found);
  for (uint32_t i = 0; i < proposal.matches.size(); ++i) {
    if (!proposal.matches[i].IsValid()) continue;
    const LandmarkId landmark = map.Resolve(proposal.matches[i]);
    if (map.Find(landmark) && map.Observe(landmark, id, i)) map.Refresh(landmark);
  }
  return id;
}

std::vector<LandmarkId> AddLandmarksByDepth(Map& map, KeyframeId keyframe) {
  constexpr size_t kNearestInAnyCase = 100;
  const FramePtr frame = map.Find(keyframe)->frame;
  const Rigid3 world_from_cam = map.Find(keyframe)->cam_from_world.Inverse();
  std::vector<std::pair<float, uint32_t>> by_depth;
  for (uint32_t i = 0; i < frame->size(); ++i) {
    if (frame->HasDepth(i)) by_depth.emplace_back(frame->depth[i], i);
  }
  std::sort(by_depth.begin(), by_depth.end());

  std::vector<LandmarkId> added;
  for (size_t rank = 0; rank < by_depth.size(); ++rank) {
    const auto [depth, index] = by_depth[rank];
    if (rank >= kNearestInAnyCase && depth > frame->rig->CloseDepth()) break;
    if (map.Find(keyframe)->landmarks[index].IsValid()) continue;
    added.push_back(map.AddLandmark(world_from_cam * frame->PointInCam(index), keyframe, index));
  }
  return added;
}

}  // namespace yorb
