// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "matching/by_appearance.h"

#include <algorithm>

namespace yorb {

std::vector<KnownPoint> KnownPointsOf(const Keyframe& keyframe, const Map& map) {
  std::vector<KnownPoint> points;
  for (size_t i = 0; i < keyframe.landmarks.size(); ++i) {
    const LandmarkId id = keyframe.landmarks[i];
    const Landmark* landmark = id.IsValid() ? map.Find(id) : nullptr;
    if (!landmark) continue;
    const Keypoint& keypoint = keyframe.frame->keypoints[i];
    points.push_back({landmark->position, keyframe.frame->descriptors[i], keypoint.octave, keypoint.angle_rad, id});
  }
  return points;
}

std::vector<int> MatchByAppearance(const Frame& frame, const std::vector<KnownPoint>& points) {
  constexpr double kRatio = 0.75;
  std::vector<Descriptor> rows;
  for (const KnownPoint& point : points) rows.push_back(point.descriptor);

  struct Pair {
    int row = -1, distance = 257;
  };
  std::vector<Pair> nearest(frame.size());
  std::vector<int> best_of_row(rows.size(), 257);
  std::vector<uint16_t> distances(rows.size());
  for (size_t i = 0; i < frame.size() && !frame.IsSuspect(i); ++i) {
    HammingDistances(frame.descriptors[i], rows.data(), rows.size(), distances.data());
    int second = 257;
    for (size_t row = 0; row < rows.size(); ++row) {
      const int distance = distances[row];
      best_of_row[row] = std::min(best_of_row[row], distance);
      if (distance < nearest[i].distance) {
        second = nearest[i].distance;
        nearest[i] = {static_cast<int>(row), distance};
      } else if (distance < second) {
        second = distance;
      }
    }
    if (nearest[i].distance > kStrictDistance || nearest[i].distance > kRatio * second) nearest[i].row = -1;
  }

  Claims claims(frame.size());
  std::vector<float> turn_rad(frame.size(), 0.f);
  for (size_t i = 0; i < frame.size() && !frame.IsSuspect(i); ++i) {
    const auto [row, distance] = nearest[i];
    if (row < 0 || distance > best_of_row[static_cast<size_t>(row)]) continue;
    claims.Claim(static_cast<int>(i), row, distance);
    turn_rad[i] = points[static_cast<size_t>(row)].angle_rad - frame.keypoints[i].angle_rad;
  }
  DropOddTurns(turn_rad, claims);
  return claims.owners();
}

}  // namespace yorb
