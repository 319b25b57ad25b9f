// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "matching/by_appearance.h"

namespace yorb {

std::vector<LandmarkId> MatchByAppearance(const Frame& frame, const Keyframe& keyframe, const Map& map) {
  constexpr double kRatio = 0.75;
  std::vector<Descriptor> rows;
  std::vector<uint32_t> indices;
  for (uint32_t i = 0; i < keyframe.landmarks.size(); ++i) {
    if (!keyframe.landmarks[i].IsValid() || !map.Find(keyframe.landmarks[i])) continue;
    rows.push_back(keyframe.frame->descriptors[i]);
    indices.push_back(i);
  }

  Claims claims(frame.size());  // by row of `rows`
  std::vector<int> best_of_row(rows.size(), 257);
  std::vector<uint16_t> distances(rows.size());
  struct Pair {
    int row = -1, distance = 257;
  };
  std::vector<Pair> nearest(frame.size());
  for (size_t i = 0; i < frame.size(); ++i) {
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
  std::vector<float> turn_rad(frame.size(), 0.f);
  for (size_t i = 0; i < frame.size(); ++i) {
    const auto [row, distance] = nearest[i];
    if (row < 0 || distance > best_of_row[static_cast<size_t>(row)]) continue;
    claims.Claim(static_cast<int>(i), row, distance);
    turn_rad[i] = keyframe.frame->keypoints[indices[static_cast<size_t>(row)]].angle_rad - frame.keypoints[i].angle_rad;
  }
  DropOddTurns(turn_rad, claims);

  std::vector<LandmarkId> matches(frame.size());
  for (size_t i = 0; i < frame.size(); ++i) {
    const int row = claims.owners()[i];
    if (row >= 0) matches[i] = keyframe.landmarks[indices[static_cast<size_t>(row)]];
  }
  return matches;
}

}  // namespace yorb
