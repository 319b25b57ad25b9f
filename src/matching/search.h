// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Room: matching. Which point of a picture is which point of the map, by appearance near where it should be.
// Takes: frames, map snapshots, poses. Gives: lists of (keypoint, landmark). Owns: nothing.
// Runs on: whichever thread calls. May not: change the map or estimate poses.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "features/frame.h"
#include "features/hamming.h"

namespace yorb {

/// Bounds on the Hamming distance of a match: 256 bits, of which two views of one corner differ in about 30, and
/// two corners by chance in 128 +- 8.
constexpr int kStrictDistance = 50, kLooseDistance = 100;

/// Where in a frame to look for a point.
struct SearchArea {
  Eigen::Vector2f px;
  float right_px = std::numeric_limits<float>::quiet_NaN();  ///< expected x in the right picture; NaN: not known
  float radius_px = 0;
  int min_octave = 0, max_octave = 0;
};

/// The two nearest descriptors of an area.
struct SearchResult {
  int index = -1;  ///< of the nearest; -1: none
  int distance = 257, second_distance = 257;
  int octave = -1, second_octave = -1;

  /// Whether the second nearest is so near that the nearest may be chance; another octave shows the same corner again.
  bool IsAmbiguous(double ratio) const { return octave == second_octave && distance > ratio * second_distance; }
};

/// Looks through the keypoints of an area for which `is_free(index)` holds.
template <typename IsFree>
SearchResult FindNearest(const Frame& frame, const SearchArea& area, const Descriptor& descriptor, IsFree&& is_free) {
  SearchResult result;
  frame.grid.VisitNear(area.px.x(), area.px.y(), area.radius_px, [&](uint32_t index) {
    const Keypoint& keypoint = frame.keypoints[index];
    if (keypoint.octave < area.min_octave || keypoint.octave > area.max_octave) return;
    const Eigen::Vector2f offset_px = frame.points_px[index] - area.px;
    if (std::abs(offset_px.x()) > area.radius_px || std::abs(offset_px.y()) > area.radius_px) return;
    if (!is_free(index)) return;
    // A NaN on either side compares false: unknown depth speaks against nothing.
    if (std::abs(frame.right_px[index] - area.right_px) > area.radius_px) return;
    const int distance = HammingDistance(descriptor, frame.descriptors[index]);
    if (distance < result.distance) {
      result.second_distance = result.distance;
      result.second_octave = result.octave;
      result.distance = distance;
      result.octave = keypoint.octave;
      result.index = static_cast<int>(index);
    } else if (distance < result.second_distance) {
      result.second_distance = distance;
      result.second_octave = keypoint.octave;
    }
  });
  return result;
}

/// Which keypoint is whose: each keypoint goes to the claim that resembles it most, the first of equals.
class Claims {
 public:
  explicit Claims(size_t num_keypoints) : owner_(num_keypoints, -1), distance_(num_keypoints, 257) {}

  void Claim(int index, int owner, int distance) {
    const auto i = static_cast<size_t>(index);
    if (distance >= distance_[i]) return;
    distance_[i] = distance;
    owner_[i] = owner;
  }
  void Drop(size_t index) { owner_[index] = -1; }
  const std::vector<int>& owners() const { return owner_; }  ///< a row a keypoint; -1: nobody's

 private:
  std::vector<int> owner_, distance_;
};

/// Drops claims whose keypoint turned by another angle than most: true pairs of two pictures turn together.
/// `turn_rad` is one angle difference a keypoint; only claimed rows are read.
void DropOddTurns(const std::vector<float>& turn_rad, Claims& claims);

}  // namespace yorb
