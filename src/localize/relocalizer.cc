// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "localize/relocalizer.h"

#include <algorithm>

#include "geometry/pnp.h"
#include "localize/evidence.h"
#include "localize/local_map.h"
#include "matching/by_appearance.h"
#include "optimize/observed.h"

namespace yorb {
namespace {

/// Adds the landmarks of a place that the coarse pose says must be in view.
Fix Extend(const Frame& frame, const Map& map, const Fix& coarse, const std::vector<KeyframeId>& around,
           double radius_px) {
  constexpr double kRadiusOfWideningOne = 4;
  LocalMap local;
  local.keyframes = around;
  const auto widening = static_cast<float>(radius_px / kRadiusOfWideningOne);
  const auto expected = ExpectLocalLandmarks(map, local, frame, coarse.cam_from_world, coarse.matches, widening);
  return FixWithExpected(frame, map, coarse, expected);
}

}  // namespace

std::optional<Fix> FixByAppearance(const Frame& frame, const std::vector<KnownPoint>& points, Random random) {
  constexpr size_t kMinMatches = 12;
  std::vector<int> rows = MatchByAppearance(frame, points);
  std::vector<PnpObservation> observations;
  std::vector<size_t> indices;
  for (size_t i = 0; i < rows.size(); ++i) {
    if (rows[i] < 0) continue;
    const Eigen::Vector2f& px = frame.points_px[i];
    const double deviation = frame.scales->scale[static_cast<size_t>(frame.keypoints[i].octave)] / frame.rig->camera.fx;
    observations.push_back({points[static_cast<size_t>(rows[i])].x_in_world,
                            frame.rig->camera.Unproject(px.x(), px.y(), 1).head<2>(), deviation});
    indices.push_back(i);
  }
  if (observations.size() < kMinMatches) return std::nullopt;
  const auto pnp = PnpRansac(observations, PnpOptions(), random);
  if (!pnp) return std::nullopt;
  for (size_t k = 0; k < observations.size(); ++k) {
    if (!pnp->is_inlier[k]) rows[indices[k]] = -1;
  }
  return FixFromPoints(frame, pnp->cam_from_world, points, rows);
}

std::optional<Fix> RelocalizeAgainst(const Frame& frame, const Map& map, const Keyframe& keyframe,
                                     const RecognitionTerms& terms, Random random) {
  constexpr size_t kHopeless = 10;
  auto fix = FixByAppearance(frame, KnownPointsOf(keyframe, map), random);
  if (!fix || fix->num_inliers < kHopeless) return std::nullopt;
  const bool is_strict = terms.min_share > 0;
  if (fix->num_inliers >= terms.min_inliers && !is_strict) return fix;
  constexpr size_t kNeighbours = 5;
  const std::vector<KeyframeId> around = keyframe.WithStrongest(kNeighbours, 1);
  fix = Extend(frame, map, *fix, around, terms.radius_px);
  if (fix->num_inliers < terms.min_inliers) return std::nullopt;
  if (!is_strict) return fix;
  const Evidence evidence = Weigh(frame, map, *fix, around);
  if (evidence.Share() < terms.min_share || evidence.spread < terms.min_spread) return std::nullopt;
  return fix;
}

std::optional<Fix> Relocalize(const Frame& frame, const Map& map, const std::vector<KeyframeId>& candidates,
                              const RecognitionTerms& terms, Random random) {
  for (const KeyframeId id : candidates) {
    auto fix = RelocalizeAgainst(frame, map, *map.Find(id), terms, random);
    if (fix) return fix;
  }
  return std::nullopt;
}

std::vector<KeyframeId> NewestAndSomeOlder(const Map& map, FrameId frame) {
  constexpr size_t kNewest = 8, kOlder = 4;
  std::vector<KeyframeId> all;
  map.VisitKeyframes([&](const Keyframe& keyframe) { all.push_back(keyframe.id); });
  std::reverse(all.begin(), all.end());
  if (all.size() <= kNewest + kOlder) return all;
  std::vector<KeyframeId> chosen(all.begin(), all.begin() + kNewest);
  const size_t num_older = all.size() - kNewest;
  for (size_t k = 0; k < kOlder; ++k) chosen.push_back(all[kNewest + (frame.value() * kOlder + k) % num_older]);
  return chosen;
}

}  // namespace yorb
