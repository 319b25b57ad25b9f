// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/trust.h"

#include <gtest/gtest.h>

#include "map/synthetic_world.h"

namespace yorb {
namespace {

/// The trust in a landmark that so many keyframes saw, each `step_s` after the one before.
double TrustAfter(int num_views, double step_s) {
  const SyntheticWorld world(2);
  Map map;
  KeyframeId keyframe;
  LandmarkId landmark;
  for (int k = 0; k < num_views; ++k) {
    const Timestamp time{static_cast<int64_t>(k * step_s * 1e9)};
    const auto view = world.Look(Rigid3::Identity(), FrameId(static_cast<uint32_t>(k)), time);
    keyframe = map.AddKeyframe(view.frame, Rigid3::Identity(), keyframe);
    if (k == 0) landmark = map.AddLandmark(world.Position(view.points[0]), keyframe, 0);
    if (k > 0) map.Observe(landmark, keyframe, 0);
  }
  return TrustIn(*map.Find(landmark), map);
}

TEST(TrustIn, GrowsWithViewsAndWithTime) {
  EXPECT_DOUBLE_EQ(TrustAfter(1, 1), kTrustInNew);
  EXPECT_DOUBLE_EQ(TrustAfter(4, 1), 1);
  EXPECT_DOUBLE_EQ(TrustAfter(9, 10), 1);
  EXPECT_DOUBLE_EQ(TrustAfter(4, 0), 0.6);
  EXPECT_DOUBLE_EQ(TrustAfter(5, 0.25), 0.8);
  EXPECT_DOUBLE_EQ(TrustAfter(2, 2), 0.5);
}

}  // namespace
}  // namespace yorb
