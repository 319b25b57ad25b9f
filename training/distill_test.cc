// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/distill.h"

#include <gtest/gtest.h>

namespace yorb {
namespace {

using Maps = std::array<torch::Tensor, 3>;

/// A teacher of the names given, without a network: its maps come from the tests.
Teacher TeacherOf(const std::vector<int64_t>& own, const std::vector<int64_t>& learner) {
  Teacher teacher;
  teacher.own_class = own;
  teacher.learner_class = learner;
  return teacher;
}

Maps RandomMaps(int64_t num_classes, bool needs_gradient) {
  Maps maps;
  for (size_t i = 0; i < 3; ++i) {
    maps[i] = torch::randn({2, 3 * (5 + num_classes), 8 >> i, 12 >> i});
    maps[i].set_requires_grad(needs_gradient);
  }
  return maps;
}

Maps CopyOf(const Maps& maps) {
  Maps copy;
  for (size_t i = 0; i < 3; ++i) copy[i] = maps[i].detach().clone().set_requires_grad(true);
  return copy;
}

Batch Pictures(std::vector<Target> targets, int64_t num_classes) {
  return {torch::zeros({2, 64, 96, 3}, torch::kUInt8), std::move(targets), torch::ones({2, num_classes})};
}

double LargestGradient(const Maps& maps) {
  double largest = 0;
  for (const torch::Tensor& map : maps) largest = std::max(largest, map.grad().abs().max().item<double>());
  return largest;
}

/// A channel of an anchor at a place: 4 is objectness, 5 the first class.
torch::Tensor At(const torch::Tensor& map, int64_t channel, int64_t row, int64_t column) {
  return map.index({0, channel, row, column});
}

TEST(DistillationLoss, WhoEqualsTheTeacherHasNothingToLearn) {
  torch::manual_seed(1);
  const Layout layout = MakeLayout("yolo-mo-n", 4);
  const Maps taught = RandomMaps(4, false), equal = CopyOf(taught), other = RandomMaps(4, true);
  const Teacher teacher = TeacherOf({0, 1, 2, 3}, {0, 1, 2, 3});
  DistillationLoss(equal, taught, Pictures({}, 4), layout, teacher, {}).backward();
  DistillationLoss(other, taught, Pictures({}, 4), layout, teacher, {}).backward();
  EXPECT_LT(LargestGradient(equal), 1e-6);
  EXPECT_GT(LargestGradient(other), 1e-3);
}

TEST(DistillationLoss, ClassesAreMatchedByTheirPairs) {
  torch::manual_seed(2);
  const Layout layout = MakeLayout("yolo-mo-n", 2);
  const Maps taught = RandomMaps(2, false);
  Maps swapped = CopyOf(taught);
  for (size_t i = 0; i < 3; ++i) {
    const std::vector<int64_t> order{0, 1, 2, 3, 4, 6, 5, 7, 8, 9, 10, 11, 13, 12, 14, 15, 16, 17, 18, 20, 19};
    swapped[i] = taught[i].index_select(1, torch::tensor(order)).detach().set_requires_grad(true);
  }
  DistillationLoss(swapped, taught, Pictures({}, 2), layout, TeacherOf({0, 1}, {1, 0}), {}).backward();
  EXPECT_LT(LargestGradient(swapped), 1e-6);
}

TEST(DistillationLoss, WhatOnlyTheTeacherKnowsIsBackground) {
  const Layout layout = MakeLayout("yolo-mo-n", 1);
  Maps taught, maps;
  for (size_t i = 0; i < 3; ++i) {
    taught[i] = torch::full({2, 21, 8 >> i, 12 >> i}, 6.0);
    taught[i].slice(1, 5, 6).fill_(-9);  // its first class, which both know, is not there; the second is
    maps[i] = torch::zeros({2, 18, 8 >> i, 12 >> i}).set_requires_grad(true);
  }
  DistillationLoss(maps, taught, Pictures({}, 1), layout, TeacherOf({0}, {0}), {}).backward();
  EXPECT_GT(At(maps[0].grad(), 4, 3, 5).item<double>(), 0);  // objectness is to fall
  EXPECT_NEAR(At(maps[0].grad(), 5, 3, 5).item<double>(), 0, 1e-9);
}

TEST(DistillationLoss, WhatTheTeacherDoesNotKnowIsLeftToTheTruth) {
  const Layout layout = MakeLayout("yolo-mo-n", 2);
  Maps taught, maps;
  for (size_t i = 0; i < 3; ++i) {
    taught[i] = torch::full({2, 21, 8 >> i, 12 >> i}, -9.0);
    torch::Tensor own = torch::zeros({2, 21, 8 >> i, 12 >> i});
    own.index_put_({0, 6, 3 >> i, 5 >> i}, 2.0);  // the first anchor sees the second class
    maps[i] = own.set_requires_grad(true);
  }
  const std::vector<Target> truth{{0, {60, 28, 72, 44, 0, false}}};  // its centre is in column 8, row 4
  DistillationLoss(maps, taught, Pictures(truth, 2), layout, TeacherOf({0}, {0}), {}).backward();
  EXPECT_EQ(At(maps[0].grad(), 4, 3, 5).item<double>(), 0);
  EXPECT_LT(At(maps[0].grad(), 4, 4, 8).item<double>(), 0);  // there objectness is to rise, for the truth
  EXPECT_GT(At(maps[0].grad(), 4, 1, 1).item<double>(), 0);
}

}  // namespace
}  // namespace yorb
