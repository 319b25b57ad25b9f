// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/export_onnx.h"

#include <gtest/gtest.h>
#include <onnx/checker.h>

#include <opencv2/dnn.hpp>

namespace yorb {
namespace {

const ClassTable kTable{{"person", "chair"}, {"high", "low"}};

/// A network with norms and biases that are not those of its birth.
Network MakeStirredNetwork(const std::string& name) {
  torch::manual_seed(1);
  const torch::NoGradGuard no_grad;
  Network network(MakeLayout(name, kTable.size()));
  for (torch::Tensor& parameter : network->parameters()) {
    if (parameter.dim() == 1) parameter.add_(torch::rand_like(parameter) * 0.2);
  }
  for (const auto& buffer : network->named_buffers()) {
    if (buffer.key().ends_with("running_mean")) buffer.value().copy_(torch::randn_like(buffer.value()) * 0.1);
    if (buffer.key().ends_with("running_var")) buffer.value().copy_(0.5 + torch::rand_like(buffer.value()));
  }
  network->eval();
  return network;
}

class ExportOnnx : public testing::TestWithParam<std::string> {};

TEST_P(ExportOnnx, OpenCvReadsItAndGivesTheValuesOfLibtorch) {
  Network network = MakeStirredNetwork(GetParam());
  const std::string bytes = yorb::ExportOnnx(network, kTable, {96, 64});
  cv::dnn::Net net = cv::dnn::readNetFromONNX(bytes.data(), bytes.size());
  const torch::NoGradGuard no_grad;
  const torch::Tensor picture = torch::rand({1, 3, 64, 96});
  const int shape[] = {1, 3, 64, 96};
  net.setInput(cv::Mat(4, shape, CV_32F, picture.data_ptr<float>()));
  std::vector<cv::Mat> outputs;
  net.forward(outputs, std::vector<cv::String>{"stride8", "stride16", "stride32"});
  const auto maps = network(picture);
  for (size_t level = 0; level < 3; ++level) {
    const torch::Tensor map = maps[level].contiguous();
    ASSERT_EQ(outputs[level].total(), static_cast<size_t>(map.numel()));
    const torch::Tensor other = torch::from_blob(outputs[level].data, map.sizes());
    EXPECT_LT((map - other).abs().max().item<double>(), 1e-3);
    EXPECT_GT(map.std().item<double>(),
              1e-3);  // the values differ from place to place, so that equality says something
  }
}

TEST_P(ExportOnnx, TheRulesOfOnnxHold) {
  onnx::ModelProto model;
  ASSERT_TRUE(model.ParseFromString(yorb::ExportOnnx(MakeStirredNetwork(GetParam()), kTable, {96, 64})));
  try {
    onnx::checker::check_model(model);
  } catch (const std::exception& wrong) {
    FAIL() << wrong.what();
  }
}

INSTANTIATE_TEST_SUITE_P(AllNetworks, ExportOnnx, testing::ValuesIn(LayoutNames()), [](const auto& name) {
  std::string word = name.param;
  std::erase(word, '-');
  return word;
});

}  // namespace
}  // namespace yorb
