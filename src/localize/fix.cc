// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "localize/fix.h"

#include "optimize/observed.h"

namespace yorb {

Fix FixFromPoints(const Frame& frame, const Rigid3& guess, const std::vector<KnownPoint>& points,
                  const std::vector<int>& rows, const Planes& planes) {
  std::vector<PoseObservation> observations;
  std::vector<size_t> indices;
  for (size_t i = 0; i < rows.size(); ++i) {
    if (rows[i] < 0) continue;
    const auto row = static_cast<size_t>(rows[i]);
    observations.push_back({points[row].x_in_world, Observed(frame, i), points[row].trust});
    indices.push_back(i);
  }
  const PoseEstimate estimate = OptimizePose(guess, observations, Projection(*frame.rig), planes);

  Fix fix;
  fix.cam_from_world = estimate.cam_from_world;
  fix.matches.resize(frame.size());
  fix.sigma_m = estimate.SigmaOfPlace();
  fix.num_matched = observations.size();
  for (size_t k = 0; k < observations.size(); ++k) {
    if (!estimate.is_inlier[k]) continue;
    const LandmarkId landmark = points[static_cast<size_t>(rows[indices[k]])].landmark;
    fix.matches[indices[k]] = landmark;
    (landmark.IsValid() ? fix.num_inliers : fix.num_inliers_by_depth) += 1;
  }
  return fix;
}

Fix FixFromLandmarks(const Frame& frame, const Map& map, const Rigid3& guess, const std::vector<LandmarkId>& matches,
                     const Planes& planes) {
  std::vector<KnownPoint> points;
  std::vector<int> rows(frame.size(), -1);
  for (size_t i = 0; i < matches.size(); ++i) {
    const Landmark* landmark = map.Find(matches[i]);
    if (!landmark) continue;
    rows[i] = static_cast<int>(points.size());
    KnownPoint point;
    point.x_in_world = landmark->position;
    point.landmark = landmark->id;
    point.trust = TrustIn(*landmark, map);
    points.push_back(point);
  }
  return FixFromPoints(frame, guess, points, rows, planes);
}

Fix Refit(const Frame& frame, const Map& map, const Fix& fix, const Planes& planes) {
  constexpr double kMinKept = 0.8;
  Fix again = FixFromLandmarks(frame, map, fix.cam_from_world, fix.matches, planes);
  again.num_matched = fix.num_matched;
  const bool is_same = static_cast<double>(again.num_inliers) >= kMinKept * static_cast<double>(fix.num_inliers);
  return is_same && fix.num_inliers_by_depth == 0 ? again : fix;
}

}  // namespace yorb
