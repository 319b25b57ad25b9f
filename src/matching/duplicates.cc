// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "matching/duplicates.h"

#include "matching/by_projection.h"

namespace yorb {
namespace {

constexpr double kChi2TwoResiduals = 5.991, kChi2ThreeResiduals = 7.815;  // 95 %

/// Whether a keypoint lies where the landmark must appear, by the uncertainty of its octave.
bool IsConsistent(const Frame& frame, const SearchArea& area, uint32_t index) {
  const Eigen::Vector2f error_px = frame.points_px[index] - area.px;
  const float right_error_px = frame.right_px[index] - area.right_px;
  const float variance = frame.InverseVariance(index);
  if (std::isnan(right_error_px)) return error_px.squaredNorm() * variance < kChi2TwoResiduals;
  return (error_px.squaredNorm() + right_error_px * right_error_px) * variance < kChi2ThreeResiduals;
}

}  // namespace

std::vector<Sighting> FindSightings(const Map& map, const std::vector<LandmarkId>& landmarks,
                                    const Keyframe& keyframe) {
  constexpr float kWidening = 1;
  const Frame& frame = *keyframe.frame;
  Claims claims(frame.size());
  for (size_t row = 0; row < landmarks.size(); ++row) {
    const Landmark* landmark = map.Find(landmarks[row]);
    if (!landmark || landmark->ViewOf(keyframe.id)) continue;
    const auto area = ExpectLandmark(*landmark, frame, keyframe.cam_from_world, kWidening);
    if (!area) continue;
    const auto may_be = [&](uint32_t index) { return IsConsistent(frame, *area, index); };
    const SearchResult found = FindNearest(frame, *area, landmark->descriptor, may_be);
    if (found.index >= 0 && found.distance <= kStrictDistance) {
      claims.Claim(found.index, static_cast<int>(row), found.distance);
    }
  }
  std::vector<Sighting> sightings;
  for (uint32_t index = 0; index < frame.size(); ++index) {
    const int row = claims.owners()[index];
    if (row >= 0) sightings.push_back({landmarks[static_cast<size_t>(row)], index});
  }
  return sightings;
}

}  // namespace yorb
