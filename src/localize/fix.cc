// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "localize/fix.h"

#include "optimize/crowding.h"
#include "optimize/observed.h"

namespace yorb {
namespace {

/// Lets each place of the picture count for a few points, however many were found there.
void WeighPlaces(const Rig& rig, std::vector<PoseObservation>& observations) {
  std::vector<Eigen::Vector2f> points_px;
  points_px.reserve(observations.size());
  for (const PoseObservation& o : observations) {
    points_px.emplace_back(static_cast<float>(o.seen.x_px), static_cast<float>(o.seen.y_px));
  }
  const std::vector<double> shares = SharesOfPlaces(points_px, rig);
  for (size_t k = 0; k < shares.size(); ++k) observations[k].weight *= shares[k];
}

}  // namespace

Fix FixFromPoints(const Frame& frame, const Rigid3& guess, const std::vector<KnownPoint>& points,
                  const std::vector<int>& rows, const Support& support) {
  std::vector<PoseObservation> observations;
  std::vector<uint32_t> indices;
  for (uint32_t i = 0; i < rows.size(); ++i) {
    if (rows[i] < 0) continue;
    const auto row = static_cast<size_t>(rows[i]);
    observations.push_back({points[row].x_in_world, Observed(frame, i), points[row].trust});
    indices.push_back(i);
  }
  observations.insert(observations.end(), support.followed.begin(), support.followed.end());
  WeighPlaces(*frame.rig, observations);
  const PoseEstimate estimate =
      OptimizePose(guess, observations, Projection(*frame.rig), support.planes, support.expected);

  Fix fix;
  fix.cam_from_world = estimate.cam_from_world;
  fix.matches.resize(frame.size());
  fix.sigma_m = estimate.SigmaOfPlace();
  fix.information = estimate.information;
  fix.held_by = estimate.held_by;
  fix.num_matched = observations.size();
  for (size_t k = 0; k < observations.size(); ++k) {
    if (!estimate.is_inlier[k]) continue;
    if (k >= indices.size()) {
      fix.followed.push_back(observations[k]);
      continue;
    }
    const KnownPoint& point = points[static_cast<size_t>(rows[indices[k]])];
    if (point.landmark.IsValid()) {
      fix.matches[indices[k]] = point.landmark;
      ++fix.num_inliers;
    } else {
      fix.by_depth.push_back({indices[k], point.x_in_world});
    }
  }
  return fix;
}

Fix FixFromLandmarks(const Frame& frame, const Map& map, const Rigid3& guess, const std::vector<LandmarkId>& matches,
                     const std::vector<DepthPoint>& by_depth, const Support& support) {
  std::vector<KnownPoint> points;
  std::vector<int> rows(frame.size(), -1);
  const auto add = [&](size_t row, const KnownPoint& point) {
    rows[row] = static_cast<int>(points.size());
    points.push_back(point);
  };
  for (size_t i = 0; i < matches.size(); ++i) {
    const Landmark* landmark = map.Find(matches[i]);
    if (!landmark) continue;
    KnownPoint point;
    point.x_in_world = landmark->position;
    point.landmark = landmark->id;
    point.trust = TrustIn(*landmark, map);
    add(i, point);
  }
  for (const DepthPoint& known : by_depth) {
    if (rows[known.row] >= 0) continue;
    KnownPoint point;
    point.x_in_world = known.x_in_world;
    add(known.row, point);
  }
  return FixFromPoints(frame, guess, points, rows, support);
}

Fix Refit(const Frame& frame, const Map& map, const Fix& fix, Support support) {
  constexpr double kMinKept = 0.8;
  support.followed = fix.followed;
  Fix again = FixFromLandmarks(frame, map, fix.cam_from_world, fix.matches, fix.by_depth, support);
  again.num_matched = fix.num_matched;
  const bool is_same = static_cast<double>(again.num_in_all()) >= kMinKept * static_cast<double>(fix.num_in_all());
  return is_same ? again : fix;
}

Matrix6d BesideLandmarks(const Frame& frame, const Fix& fix) {
  std::vector<PoseObservation> observations;
  for (const DepthPoint& point : fix.by_depth) {
    observations.push_back({point.x_in_world, Observed(frame, point.row), kTrustInNew});
  }
  observations.insert(observations.end(), fix.followed.begin(), fix.followed.end());
  return fix.held_by + InformationAt(fix.cam_from_world, observations, Projection(*frame.rig));
}

}  // namespace yorb
