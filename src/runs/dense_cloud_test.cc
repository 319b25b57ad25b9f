// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/dense_cloud.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "map/map_parts.h"
#include "runs/test_dataset.h"
#include "runs/voxel_grid.h"

namespace yorb {
namespace {

/// Somebody stands in the left half of each picture.
class SomebodyLeft : public Detector {
 public:
  explicit SomebodyLeft(float confidence = 0.9f) : confidence_(confidence) {}

  Result<Detections> Detect(const ImageSet& images) override {
    Detections seen;
    Box box;
    box.name = "person";
    box.confidence = confidence_;
    box.left = 0;
    box.top = 0;
    box.right = static_cast<float>(images.grey.cols) / 2;
    box.bottom = static_cast<float>(images.grey.rows);
    seen.boxes.push_back(box);
    return seen;
  }

 private:
  float confidence_;
};

/// A map whose keyframes took every fifth picture of the wall, and one more of another time.
Map MapOf(const WallDataset& wall) {
  Map map;
  const auto add = [&](Timestamp time, double along, KeyframeId parent) {
    auto frame = std::make_shared<Frame>();
    frame->id = FrameId(map.next_keyframe().value());
    frame->timestamp = time;
    frame->rig = std::make_shared<const Rig>(wall.rig());
    return map.AddKeyframe(frame, Rigid3(Eigen::Quaterniond::Identity(), {-along, 0, 0}), parent);
  };
  KeyframeId last;
  for (size_t i = 0; i < wall.size(); i += 5) last = add(wall.TimeOf(i), 0.006 * static_cast<double>(i), last);
  add(Timestamp{5}, 0, last);
  return map;
}

TEST(DenseCloud, LiesOnWhatTheDepthPicturesShow) {
  const WallDataset wall(20);
  const auto made = MakeDenseClouds(MapOf(wall), {KeyframeId(0)}, wall, {}, {});
  ASSERT_TRUE(made.ok()) << made.error().message;
  EXPECT_EQ(made->num_keyframes, 4u);
  ASSERT_EQ(made->clouds.size(), 1u);
  const PointCloud& cloud = made->clouds[0];
  ASSERT_GT(cloud.points.size(), 10000u);
  for (size_t i = 0; i < cloud.points.size(); ++i) {
    EXPECT_NEAR(cloud.points[i].z(), 2, 1e-6);
    EXPECT_EQ(cloud.colours[i][0], cloud.colours[i][2]) << "grey pictures";
  }
  EXPECT_NEAR(cloud.points.front().x(), (1 - 160) * 0.006, 0.01);
  EXPECT_NEAR(cloud.points.front().y(), (1 - 120) * 0.006, 0.01);
}

TEST(DenseCloud, LeavesPeopleAndMaskedPixelsOut) {
  WallDataset wall(1);
  wall.left_mm = 1500;
  RunParts parts;
  parts.slam.detector = std::make_unique<SomebodyLeft>();
  const auto made = MakeDenseClouds(MapOf(wall), {KeyframeId(0)}, wall, parts, {});
  ASSERT_TRUE(made.ok()) << made.error().message;
  EXPECT_EQ(made->num_with_people, 1u);
  ASSERT_GT(made->clouds[0].points.size(), 1000u);
  for (const Eigen::Vector3d& p : made->clouds[0].points) EXPECT_GT(p.x(), 0) << "on the person";
}

TEST(DenseCloud, KeepsWhatOnlyAFaintBoxNames) {
  WallDataset wall(1);
  wall.left_mm = 1500;
  RunParts parts;
  parts.slam.detector = std::make_unique<SomebodyLeft>(0.2f);
  parts.sure_confidence = 0.3;
  const auto made = MakeDenseClouds(MapOf(wall), {KeyframeId(0)}, wall, parts, {});
  ASSERT_TRUE(made.ok()) << made.error().message;
  EXPECT_EQ(made->num_with_people, 0u);
  const auto is_left = [](const Eigen::Vector3d& p) { return p.x() < -0.1; };
  const std::vector<Eigen::Vector3d>& points = made->clouds[0].points;
  EXPECT_TRUE(std::any_of(points.begin(), points.end(), is_left));
}

TEST(DenseCloud, IsRefusedWithARecordingOfAnotherTime) {
  const WallDataset wall(20), later(20, 7);
  const Map map = MapOf(WallDataset(1));
  const auto made = MakeDenseClouds(map, {KeyframeId(0)}, WallDataset(3, 0.001), {}, {});
  EXPECT_TRUE(made.ok()) << "the first picture is in it";
  Map other;
  auto frame = std::make_shared<Frame>();
  frame->timestamp = Timestamp{5};
  frame->rig = std::make_shared<const Rig>(wall.rig());
  other.AddKeyframe(frame, Rigid3::Identity(), KeyframeId());
  const auto refused = MakeDenseClouds(other, {KeyframeId(0)}, later, {}, {});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().kind, Error::Kind::kBadInput);
}

TEST(DenseCloud, StopsWhenItIsAskedTo) {
  const WallDataset wall(20);
  const DenseOptions options{0.01, [] { return true; }};
  const auto made = MakeDenseClouds(MapOf(wall), {KeyframeId(0)}, wall, {}, options);
  ASSERT_TRUE(made.ok());
  EXPECT_TRUE(made->was_stopped);
}

TEST(VoxelGrid, KeepsTheMeanOfEachCube) {
  VoxelGrid grid(0.1);
  grid.Add({0.01, 0.01, 0.01}, {10, 0, 0});
  grid.Add({0.03, 0.05, 0.01}, {20, 0, 5});
  grid.Add({-0.01, 0.01, 0.01}, {7, 7, 7});
  const PointCloud cloud = grid.Cloud();
  ASSERT_EQ(cloud.points.size(), 2u);
  EXPECT_LT((cloud.points[0] - Eigen::Vector3d(0.02, 0.03, 0.01)).norm(), 1e-12);
  EXPECT_EQ(cloud.colours[0], (std::array<uint8_t, 3>{15, 0, 3}));
  EXPECT_EQ(cloud.points[1].x(), -0.01);
}

}  // namespace
}  // namespace yorb
