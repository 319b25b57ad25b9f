// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/loss.h"

#include <gtest/gtest.h>

#include <cmath>

#include "training/assign.h"
#include "training/decode.h"

namespace yorb {
namespace {

Layout SmallLayout() { return MakeLayout("yolo-mo-n", 3); }

Target MakeTarget(float left, float top, float right, float bottom, int class_index) {
  return {0, {left, top, right, bottom, class_index, false}};
}

Batch MakeOneBatch(std::vector<Target> targets) {
  return {torch::zeros({1, 64, 96, 3}, torch::kUInt8), std::move(targets), torch::ones({1, 3})};
}

std::array<torch::Tensor, 3> Maps(double value) {
  return {torch::full({1, 24, 8, 12}, value), torch::full({1, 24, 4, 6}, value), torch::full({1, 24, 2, 3}, value)};
}

double Logit(double p) { return std::log(p / (1 - p)); }

TEST(AssignAnchors, CellsAreTheCentresAndTwoNeighbours) {
  const LevelAssignment level = AssignAnchors({MakeTarget(36, 20, 52, 44, 1)}, SmallLayout().anchors[0], 8, 8, 12);
  ASSERT_EQ(level.sure.size() % 3, 0u);
  ASSERT_GT(level.sure.size(), 0u);
  for (size_t i = 0; i < level.sure.size(); ++i) {
    // The centre (44, 32) is (5.5, 4.0) in cells, and stays so from whichever cell it is seen.
    EXPECT_NEAR(static_cast<double>(level.sure.column[i]) + level.sure.boxes[4 * i], 5.5, 1e-6);
    EXPECT_NEAR(static_cast<double>(level.sure.row[i]) + level.sure.boxes[4 * i + 1], 4.0, 1e-6);
    EXPECT_GT(level.sure.boxes[4 * i], -0.51);  // what the decoding can reach
    EXPECT_LT(level.sure.boxes[4 * i], 1.51);
  }
}

TEST(AssignAnchors, BoxesOfAnotherScaleAndDoubtfulOnesAreLeftOut) {
  Target doubtful = MakeTarget(36, 20, 52, 44, 1);
  doubtful.box.is_doubtful = true;
  const LevelAssignment level =
      AssignAnchors({MakeTarget(0, 0, 96, 2, 0), doubtful}, SmallLayout().anchors[0], 8, 8, 12);
  EXPECT_EQ(level.sure.size(), 0u);
  EXPECT_GT(level.doubtful.size(), 0u);
}

TEST(CompleteIou, IsOneForEqualBoxesAndFallsWithDistanceAndShape) {
  const torch::Tensor a = torch::tensor({{5.0f, 5.0f, 4.0f, 2.0f}});
  const auto with = [&](std::vector<float> box) {
    return CompleteIou(a, torch::tensor(box).view({1, 4})).item<double>();
  };
  EXPECT_NEAR(with({5, 5, 4, 2}), 1, 1e-5);
  EXPECT_GT(with({6, 5, 4, 2}), with({7, 5, 4, 2}));
  EXPECT_LT(with({30, 5, 4, 2}), with({15, 5, 4, 2}));  // a gradient even where nothing overlaps
  // IoU of (5,5,4,2) and (6,5,4,2): 6 / 10; distance 1 of a hull's diagonal^2 of 25 + 4.
  EXPECT_NEAR(with({6, 5, 4, 2}), 0.6 - 1.0 / 29, 1e-5);
}

TEST(DetectionLoss, TruthThatTheNetworkDecodesHasNoBoxLoss) {
  const Layout layout = SmallLayout();
  std::array<torch::Tensor, 3> maps = Maps(-12);
  const Anchor anchor = layout.anchors[0][1];
  // Anchor 1 of stride 8 at row 4, column 5: sigmoids of a half give the cell's centre and the anchor's size.
  for (int i = 0; i < 4; ++i) maps[0].index_put_({0, 8 + i, 4, 5}, 0.0);
  maps[0].index_put_({0, 8 + 4, 4, 5}, 9.0);
  maps[0].index_put_({0, 8 + 5 + 2, 4, 5}, 9.0);
  const auto found = DecodeBoxes(maps, layout, {});
  ASSERT_EQ(found[0].size(), 1u);
  const SceneBox box = found[0][0].box;
  EXPECT_NEAR((box.left + box.right) / 2, 44, 1e-3);
  EXPECT_NEAR(box.width(), anchor.width_px, 1e-3);
  EXPECT_EQ(box.class_index, 2);
  // The loss of the same box against itself, in the one cell that predicts it.
  const LevelAssignment level = AssignAnchors({{0, box}}, layout.anchors[0], 8, 8, 12);
  bool is_there = false;
  for (size_t i = 0; i < level.sure.size(); ++i)
    is_there |= level.sure.row[i] == 4 && level.sure.column[i] == 5 && level.sure.anchor[i] == 1;
  EXPECT_TRUE(is_there);
}

TEST(DetectionLoss, BackgroundIsPunishedUnlessInDoubt) {
  const Layout layout = SmallLayout();
  const Loss quiet = DetectionLoss(Maps(-8), MakeOneBatch({}), layout, {});
  const Loss loud = DetectionLoss(Maps(Logit(0.5)), MakeOneBatch({}), layout, {});
  EXPECT_GT(loud.objectness, 100 * quiet.objectness);
  std::vector<Target> doubtful{MakeTarget(36, 20, 52, 44, 1)};
  doubtful[0].box.is_doubtful = true;
  const Loss less = DetectionLoss(Maps(Logit(0.5)), MakeOneBatch(doubtful), layout, {});
  EXPECT_LT(less.objectness, loud.objectness);
}

/// A picture that is not judged for class 2.
Batch UnjudgedBatch(std::vector<Target> targets) {
  Batch batch = MakeOneBatch(std::move(targets));
  batch.judged.index_put_({0, 2}, 0.0);
  return batch;
}

LossOptions Unjudged(double part) {
  LossOptions options;
  options.unjudged = part;
  return options;
}

TEST(DetectionLoss, NamingAnUnjudgedClassIsNoWayOutOfTheBackground) {
  const Layout layout = SmallLayout();
  auto maps = Maps(Logit(0.5));
  for (torch::Tensor& map : maps)
    map.index_put_({0, torch::indexing::Slice(7, torch::indexing::None, 8)}, 3.0);  // class 2
  const auto loss = [&](const Batch& batch, double part) {
    return DetectionLoss(maps, batch, layout, Unjudged(part)).objectness;
  };
  const double judged = loss(MakeOneBatch({}), 1);
  EXPECT_GT(judged, 0.1);
  EXPECT_NEAR(loss(UnjudgedBatch({}), 1), judged, 1e-9);
  EXPECT_NEAR(loss(UnjudgedBatch({}), 0.25), judged / 4, 1e-6);
  EXPECT_NEAR(loss(UnjudgedBatch({}), 0), 0, 1e-9);
}

TEST(DetectionLoss, AThingOfOneClassIsNoneThatThePictureIsNotJudgedFor) {
  const Layout layout = SmallLayout();
  const auto gradient = [&](double part) {
    auto maps = Maps(-1);
    for (torch::Tensor& map : maps) map.set_requires_grad(true);
    DetectionLoss(maps, UnjudgedBatch({MakeTarget(36, 20, 52, 44, 0)}), layout, Unjudged(part)).total.backward();
    const torch::Tensor of_values = maps[0].grad().view({3, 8, 8, 12}).transpose(0, 1);
    std::vector<double> most;
    for (int label = 0; label < 3; ++label) most.push_back(of_values[5 + label].abs().max().item<double>());
    return most;
  };
  EXPECT_EQ(gradient(0)[2], 0);
  EXPECT_GT(gradient(1)[2], 0);
  EXPECT_NEAR(gradient(1)[2], gradient(1)[1], 1e-9);
  EXPECT_GT(gradient(0)[0], 0);
}

}  // namespace
}  // namespace yorb
