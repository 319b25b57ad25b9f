// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/ate.h"

namespace yorb {

AbsoluteError ComputeAbsoluteError(const Trajectory& reference, const Trajectory& estimate,
                                   const std::vector<StampPair>& pairs, EvalAlign align) {
  std::vector<Eigen::Vector3d> truth, found;
  for (const StampPair& pair : pairs) {
    truth.push_back(reference[pair.first].world_from_cam.translation);
    found.push_back(estimate[pair.second].world_from_cam.translation);
  }
  AbsoluteError result;
  if (align != EvalAlign::kNone) {
    const AlignMode mode = align == EvalAlign::kSim3 ? AlignMode::kSimilarity : AlignMode::kRigid;
    result.reference_from_estimate = AlignPoints(found, truth, mode);
  }
  for (size_t i = 0; i < pairs.size(); ++i) {
    result.errors.push_back((truth[i] - result.reference_from_estimate * found[i]).norm());
  }
  result.summary = Summarize(result.errors);
  return result;
}

std::vector<Timestamp> StampsOf(const Trajectory& trajectory) {
  std::vector<Timestamp> stamps;
  stamps.reserve(trajectory.size());
  for (const StampedPose& pose : trajectory) stamps.push_back(pose.timestamp);
  return stamps;
}

}  // namespace yorb
