// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/unfold.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "training/export_onnx.h"

namespace yorb {
namespace {

const ClassTable kTable{{"person", "chair"}, {"high", "low"}};

/// A network as training leaves it: its norms know its data.
Network MakeSettledNetwork(const std::string& name, const torch::Tensor& pictures) {
  torch::manual_seed(1);
  const torch::NoGradGuard no_grad;
  Network network(MakeLayout(name, kTable.size()));
  for (torch::Tensor& parameter : network->parameters()) {
    if (parameter.dim() == 1) parameter.add_(torch::rand_like(parameter) * 0.2);
  }
  network->train();
  for (int i = 0; i < 100; ++i) network->forward(pictures);
  network->eval();
  return network;
}

std::string WriteOnnx(Network network) {
  const std::string path = testing::TempDir() + "/unfold.onnx";
  std::ofstream(path, std::ios::binary) << ExportOnnx(network, kTable, {96, 64});
  return path;
}

double Distance(const std::array<torch::Tensor, 3>& a, const std::array<torch::Tensor, 3>& b) {
  double most = 0;
  for (size_t level = 0; level < 3; ++level) most = std::max(most, (a[level] - b[level]).abs().max().item<double>());
  return most;
}

class Unfold : public testing::TestWithParam<std::string> {};

TEST_P(Unfold, ValuesAreThoseOfTheFileAndTrainingStaysThere) {
  const torch::NoGradGuard no_grad;
  torch::manual_seed(2);
  const torch::Tensor pictures = torch::rand({8, 3, 64, 96}), others = torch::rand({2, 3, 64, 96});
  Network before = MakeSettledNetwork(GetParam(), pictures);
  Network after(MakeLayout(GetParam(), kTable.size()));
  ASSERT_TRUE(ReadFoldedWeights(WriteOnnx(before), kTable, pictures, after));
  EXPECT_TRUE(after->is_training());
  after->eval();
  EXPECT_LT(Distance(before->forward(others), after->forward(others)), 1e-3);
  const auto evaluated = after->forward(pictures);
  after->train();  // with the pictures' own statistics
  EXPECT_LT(Distance(evaluated, after->forward(pictures)), 1e-2);
}

INSTANTIATE_TEST_SUITE_P(AllNetworks, Unfold, testing::ValuesIn(LayoutNames()), [](const auto& name) {
  std::string word = name.param;
  std::erase(word, '-');
  return word;
});

TEST(Unfold, ClassesGoByName) {
  const torch::NoGradGuard no_grad;
  torch::manual_seed(2);
  const torch::Tensor pictures = torch::rand({2, 3, 64, 96});
  Network before = MakeSettledNetwork("yolo-mo", pictures);
  const ClassTable other{{"box", "person", "robot"}, {"static", "high", "high"}};
  Network after(MakeLayout("yolo-mo", other.size()));
  const torch::Tensor chance = after->heads[0]->weight.clone();
  ASSERT_TRUE(ReadFoldedWeights(WriteOnnx(before), other, pictures, after));
  const auto of_anchor = [](const torch::Tensor& all, int anchor, int channel, int num_classes) {
    return all.select(0, anchor * (5 + num_classes) + channel);
  };
  for (int anchor = 0; anchor < 3; ++anchor) {
    const torch::Tensor& own = after->heads[0]->weight;
    EXPECT_TRUE(of_anchor(own, anchor, 4, 3).equal(of_anchor(before->heads[0]->weight, anchor, 4, 2)));
    EXPECT_TRUE(of_anchor(own, anchor, 6, 3).equal(of_anchor(before->heads[0]->weight, anchor, 5, 2)));
    EXPECT_TRUE(of_anchor(own, anchor, 7, 3).equal(of_anchor(chance, anchor, 7, 3)));
  }
}

TEST(Unfold, AnotherNetworkIsBadInput) {
  const torch::Tensor pictures = torch::rand({2, 3, 64, 96});
  const std::string path = WriteOnnx(MakeSettledNetwork("yolo-mo", pictures));
  const Status status = ReadFoldedWeights(path, kTable, pictures, Network(MakeLayout("yolo-mo-n", kTable.size())));
  ASSERT_FALSE(status);
  EXPECT_THAT(status.error().message, testing::HasSubstr("--network"));
}

}  // namespace
}  // namespace yorb
