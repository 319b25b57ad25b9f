// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "localize/evidence.h"

#include <algorithm>
#include <array>
#include <limits>

#include "localize/local_map.h"

namespace yorb {
namespace {

/// Whether the frame shows anything near the place of a landmark that is not in its way.
bool CouldBeSeen(const Frame& frame, const ExpectedLandmark& expected, double depth_m) {
  constexpr float kNearPx = 12;
  constexpr double kInFront = 0.85;  // of the landmark's depth
  float nearest = std::numeric_limits<float>::infinity();
  bool is_hidden = false;
  const Eigen::Vector2f& px = expected.area.px;
  frame.grid.VisitNear(px.x(), px.y(), kNearPx, [&](uint32_t index) {
    const float distance = (frame.points_px[index] - px).norm();
    if (distance > kNearPx || distance >= nearest) return;
    nearest = distance;
    is_hidden = frame.HasDepth(index) && frame.depth[index] < kInFront * depth_m;
  });
  return nearest <= kNearPx && !is_hidden;
}

/// Counts what is expected and found in each part of the picture.
class Parts {
 public:
  explicit Parts(const PixelBounds& bounds) : bounds_(bounds) {}

  void Add(const Eigen::Vector2f& px, bool is_found) {
    const auto cell = [](float at, float from, float to, size_t count) {
      const float share = std::clamp((at - from) / (to - from), 0.f, 1.f);
      return std::min(static_cast<size_t>(share * static_cast<float>(count)), count - 1);
    };
    const size_t column = cell(px.x(), bounds_.min_x, bounds_.max_x, kColumns);
    const size_t row = cell(px.y(), bounds_.min_y, bounds_.max_y, kRows);
    ++expected_[row * kColumns + column];
    found_[row * kColumns + column] += is_found;
  }

  Evidence Sum() const {
    constexpr size_t kEnough = 8, kFewest = 2, kOneIn = 10;
    Evidence sum;
    for (size_t i = 0; i < expected_.size(); ++i) {
      sum.num_expected += expected_[i];
      sum.num_found += found_[i];
      if (expected_[i] < kEnough) continue;
      ++sum.num_parts;
      sum.num_parts_found += found_[i] >= kFewest && kOneIn * found_[i] >= expected_[i];
    }
    return sum;
  }

 private:
  static constexpr size_t kColumns = 4, kRows = 3;
  PixelBounds bounds_;
  std::array<size_t, kColumns * kRows> expected_{}, found_{};
};

}  // namespace

Evidence Weigh(const Frame& frame, const Map& map, const Fix& fix, const std::vector<KeyframeId>& keyframes) {
  constexpr float kWidening = 1;
  Parts parts(frame.bounds);
  for (size_t i = 0; i < frame.size(); ++i) {
    if (fix.matches[i].IsValid()) parts.Add(frame.points_px[i], true);
  }
  LocalMap local;
  local.keyframes = keyframes;
  for (const auto& expected : ExpectLocalLandmarks(map, local, frame, fix.cam_from_world, fix.matches, kWidening)) {
    const double depth_m = (fix.cam_from_world * expected.landmark->position).z();
    if (CouldBeSeen(frame, expected, depth_m)) parts.Add(expected.area.px, false);
  }
  return parts.Sum();
}

}  // namespace yorb
