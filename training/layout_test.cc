// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/layout.h"

#include <gtest/gtest.h>
#include <torch/torch.h>

#include "training/network.h"

namespace yorb {
namespace {

int64_t NumParameters(const std::string& name, int num_classes) {
  Network network(MakeLayout(name, num_classes));
  int64_t sum = 0;
  for (const torch::Tensor& parameter : network->parameters()) sum += parameter.numel();
  return sum;
}

TEST(Layout, YoloV5HasItsPublishedNumberOfParameters) {
  EXPECT_EQ(NumParameters("yolov5s", 80), 7235389);
  EXPECT_EQ(NumParameters("yolov5n", 80), 1872157);
}

TEST(Layout, YoloMoHasAboutHalfOfYoloV5sParameters) {
  EXPECT_NEAR(static_cast<double>(NumParameters("yolo-mo", 10)), 3.57e6, 0.01e6);
  EXPECT_LT(NumParameters("yolo-mo-n", 10), NumParameters("yolo-mo", 10) / 2);
}

TEST(Layout, EveryNetworkGivesThreeMapsOfItsStrides) {
  for (const std::string& name : LayoutNames()) {
    Network network(MakeLayout(name, 7));
    network->eval();
    const torch::NoGradGuard no_grad;
    const auto maps = network(torch::rand({2, 3, 96, 64}));
    for (size_t level = 0; level < 3; ++level) {
      const int stride = network->layout.strides[level];
      EXPECT_EQ(maps[level].sizes(), (std::vector<int64_t>{2, 3 * 12, 96 / stride, 64 / stride})) << name;
    }
  }
}

TEST(Layout, ChannelsAreMultiplesOfEightAndNotMuchSmallerThanAsked) {
  EXPECT_EQ(MakeDivisible(16 / 4.0), 8);
  EXPECT_EQ(MakeDivisible(96 / 4.0), 24);
  EXPECT_EQ(MakeDivisible(240 / 4.0), 64);
  EXPECT_EQ(MakeDivisible(120 / 4.0), 32);
  EXPECT_EQ(MakeDivisible(144 / 4.0), 40);
  EXPECT_EQ(MakeDivisible(288 / 4.0), 72);
  EXPECT_EQ(MakeDivisible(576 / 4.0), 144);
}

}  // namespace
}  // namespace yorb
