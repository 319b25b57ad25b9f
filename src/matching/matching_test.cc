// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "map/synthetic_world.h"
#include "matching/by_appearance.h"
#include "matching/by_projection.h"
#include "matching/duplicates.h"
#include "matching/epipolar.h"

namespace yorb {
namespace {

Rigid3 Moved(double x, double turn) { return {RotationFromVector({0, turn, 0}), Eigen::Vector3d(-x, 0.01, 0.02)}; }

/// A world, a map of its first view, and a second view.
struct Scene {
  explicit Scene(const Rigid3& second_pose, SyntheticWorldOptions options = {}) : world(3, options), pose(second_pose) {
    first = world.Look(Rigid3::Identity(), FrameId(0), Timestamp{0});
    second = world.Look(pose, FrameId(1), Timestamp{33});
    keyframe = map.AddKeyframe(first.frame, Rigid3::Identity(), KeyframeId());
    for (uint32_t i = 0; i < first.points.size(); ++i) {
      landmarks.push_back(map.AddLandmark(world.Position(first.points[i]), keyframe, i));
    }
  }
  /// Counts pairs (row of the first view, keypoint of the second), and those that show the same point.
  std::pair<int, int> Judge(const std::vector<int>& first_rows) const {
    int count = 0, right = 0;
    for (size_t i = 0; i < first_rows.size(); ++i) {
      if (first_rows[i] < 0) continue;
      ++count;
      right += first.points[static_cast<size_t>(first_rows[i])] == second.points[i];
    }
    return {count, right};
  }
  int NumShared() const {
    int count = 0;
    for (const uint32_t point : second.points) count += std::count(first.points.begin(), first.points.end(), point) > 0;
    return count;
  }

  SyntheticWorld world;
  Rigid3 pose;
  Map map;
  KeyframeId keyframe;
  SyntheticWorld::View first, second;
  std::vector<LandmarkId> landmarks;
};

TEST(MatchKnownPoints, FindsNearlyAllOfThemRightNearAGoodGuess) {
  const Scene scene(Moved(0.05, 0.02));
  std::vector<KnownPoint> points;
  for (size_t i = 0; i < scene.first.points.size(); ++i) {
    points.push_back({scene.world.Position(scene.first.points[i]), scene.first.frame->descriptors[i],
                      scene.first.frame->keypoints[i].octave, 0, scene.landmarks[i]});
  }
  const auto rows = MatchKnownPoints(*scene.second.frame, Moved(0.04, 0.025), Rigid3::Identity(), points, 15);
  const auto [count, right] = scene.Judge(rows);
  EXPECT_GT(count, 0.95 * scene.NumShared());
  EXPECT_GT(right, 0.99 * count);
}

TEST(MatchExpected, FindsLandmarksButNotOnTakenKeypoints) {
  const Scene scene(Moved(0.1, 0.05));
  std::vector<ExpectedLandmark> expected;
  for (const LandmarkId id : scene.landmarks) {
    const Landmark* landmark = scene.map.Find(id);
    const auto area = ExpectLandmark(*landmark, *scene.second.frame, scene.pose, 3);
    if (area) expected.push_back({id, landmark, *area});
  }
  std::vector<bool> taken(scene.second.frame->size());
  const auto rows = MatchExpected(*scene.second.frame, expected, taken);
  int count = 0, right = 0;
  for (size_t i = 0; i < rows.size(); ++i) {
    if (rows[i] < 0) continue;
    ++count;
    const LandmarkId id = expected[static_cast<size_t>(rows[i])].id;
    right += (scene.map.Find(id)->position - scene.world.Position(scene.second.points[i])).norm() < 1e-9;
  }
  EXPECT_GT(count, 0.9 * scene.NumShared());
  EXPECT_GT(right, 0.99 * count);

  taken.assign(taken.size(), true);
  for (const int row : MatchExpected(*scene.second.frame, expected, taken)) EXPECT_EQ(row, -1);
}

/// A frame of which everything is suspect.
Frame AllSuspect(Frame frame) {
  frame.num_suspects = frame.size();
  return frame;
}

TEST(MatchExpected, FindsOnlyGrownUpLandmarksAmongSuspects) {
  Scene scene(Moved(0.1, 0.05));
  Frame suspects = AllSuspect(*scene.second.frame);
  const auto count_found = [&] {
    std::vector<ExpectedLandmark> expected;
    for (const LandmarkId id : scene.landmarks) {
      const Landmark* landmark = scene.map.Find(id);
      const auto area = ExpectLandmark(*landmark, suspects, scene.pose, 3);
      if (area) expected.push_back({id, landmark, *area});
    }
    const auto rows = MatchExpected(suspects, expected, std::vector<bool>(suspects.size()));
    return std::count_if(rows.begin(), rows.end(), [](int row) { return row >= 0; });
  };
  EXPECT_EQ(count_found(), 0);
  for (size_t view = 1; view < Landmark::kGrownUp; ++view) {
    const KeyframeId again = scene.map.AddKeyframe(scene.first.frame, Rigid3::Identity(), scene.keyframe);
    for (uint32_t i = 0; i < scene.landmarks.size(); ++i) scene.map.Observe(scene.landmarks[i], again, i);
  }
  EXPECT_GT(count_found(), 0.9 * scene.NumShared());
  suspects.depth.assign(suspects.size(), 0);  // nothing tells what is in front from what is behind
  EXPECT_EQ(count_found(), 0);
}

TEST(MatchKnownPoints, FindsOnlyWhatIsGrownUpAmongSuspects) {
  const Scene scene(Moved(0.05, 0.02));
  const Frame suspects = AllSuspect(*scene.second.frame);
  std::vector<KnownPoint> points = KnownPointsOf(*scene.map.Find(scene.keyframe), scene.map);
  const auto match = [&] { return MatchKnownPoints(suspects, scene.pose, Rigid3::Identity(), points, 15); };
  EXPECT_EQ(scene.Judge(match()).first, 0);
  for (KnownPoint& point : points) point.is_grown_up = true;
  EXPECT_GT(scene.Judge(match()).first, 0.95 * scene.NumShared());
}

TEST(ExpectLandmark, SaysNothingBehindOutsideOrFromAside) {
  const Scene scene(Rigid3::Identity());
  const Landmark& landmark = *scene.map.Find(scene.landmarks[0]);
  const Frame& frame = *scene.first.frame;
  EXPECT_TRUE(ExpectLandmark(landmark, frame, Rigid3::Identity(), 1).has_value());
  const Rigid3 back_turned(RotationFromVector({0, M_PI, 0}), Eigen::Vector3d::Zero());
  EXPECT_FALSE(ExpectLandmark(landmark, frame, back_turned, 1).has_value());
  Landmark aside = landmark;
  aside.view_direction = -landmark.view_direction;
  EXPECT_FALSE(ExpectLandmark(aside, frame, Rigid3::Identity(), 1).has_value());
  Landmark near_only = landmark;
  near_only.max_distance = 0.5 * landmark.position.norm();
  EXPECT_FALSE(ExpectLandmark(near_only, frame, Rigid3::Identity(), 1).has_value());
}

TEST(MatchByAppearance, NeedsNoPose) {
  const Scene scene(Moved(0.5, 0.3));
  const auto points = KnownPointsOf(*scene.map.Find(scene.keyframe), scene.map);
  const auto [count, right] = scene.Judge(MatchByAppearance(*scene.second.frame, points));
  EXPECT_GT(count, 0.9 * scene.NumShared());
  EXPECT_EQ(right, count);
  EXPECT_EQ(scene.Judge(MatchByAppearance(AllSuspect(*scene.second.frame), points)).first, 0);
}

TEST(MatchByAppearance, GivesNothingForAnotherWorld) {
  const Scene scene(Rigid3::Identity());
  const auto elsewhere = SyntheticWorld(77).Look(Rigid3::Identity(), FrameId(5), Timestamp{5});
  const auto points = KnownPointsOf(*scene.map.Find(scene.keyframe), scene.map);
  ASSERT_GT(points.size(), 100u);
  for (const int row : MatchByAppearance(*elsewhere.frame, points)) EXPECT_EQ(row, -1);
}

TEST(FindSightings, FindsLandmarksThatAnotherKeyframeShouldSee) {
  Scene scene(Moved(0.2, 0.0));
  const KeyframeId second = scene.map.AddKeyframe(scene.second.frame, scene.pose, scene.keyframe);
  const auto sightings = FindSightings(scene.map, scene.landmarks, *scene.map.Find(second));
  int right = 0;
  for (const Sighting& s : sightings) {
    right += (scene.map.Find(s.landmark)->position - scene.world.Position(scene.second.points[s.index])).norm() < 1e-9;
  }
  EXPECT_GT(static_cast<int>(sightings.size()), 0.8 * scene.NumShared());
  EXPECT_EQ(right, static_cast<int>(sightings.size()));
}

TEST(MatchUnknown, PairsKeypointsWithAndWithoutDepth) {
  SyntheticWorldOptions options;
  options.depth_share = 0.5;
  const Scene scene(Moved(0.3, 0.05), options);
  Map map;
  const KeyframeId a = map.AddKeyframe(scene.first.frame, Rigid3::Identity(), KeyframeId());
  const KeyframeId b = map.AddKeyframe(scene.second.frame, scene.pose, a);
  const auto pairs = MatchUnknown(*map.Find(a), *map.Find(b));
  int right = 0, without_depth = 0;
  for (const KeypointPair& pair : pairs) {
    right += scene.first.points[pair.first] == scene.second.points[pair.second];
    without_depth += !scene.first.frame->HasDepth(pair.first);
  }
  EXPECT_GT(static_cast<int>(pairs.size()), 0.8 * scene.NumShared());
  EXPECT_GT(right, 0.98 * static_cast<double>(pairs.size()));
  EXPECT_GT(without_depth, 0.3 * static_cast<double>(pairs.size()));
}

TEST(DropOddTurns, KeepsTheTurnOfMost) {
  Claims claims(100);
  std::vector<float> turn_rad(100, 0.5f);
  for (int i = 0; i < 100; ++i) claims.Claim(i, i, 10);
  for (size_t i = 0; i < 5; ++i) turn_rad[i] = 2.5f;
  DropOddTurns(turn_rad, claims);
  for (size_t i = 0; i < 100; ++i) EXPECT_EQ(claims.owners()[i] >= 0, i >= 5) << i;
}

TEST(Claims, AKeypointGoesToTheClaimThatResemblesItMost) {
  Claims claims(2);
  claims.Claim(0, 7, 30);
  claims.Claim(0, 8, 20);
  claims.Claim(0, 9, 20);
  EXPECT_EQ(claims.owners()[0], 8);
  EXPECT_EQ(claims.owners()[1], -1);
}

}  // namespace
}  // namespace yorb
