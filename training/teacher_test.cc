// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/teacher.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <opencv2/dnn.hpp>

#include "core/files.h"
#include "training/export_onnx.h"

namespace yorb {
namespace {

std::string Written(const std::string& name, Network network, const ClassTable& table) {
  const std::string path = testing::TempDir() + "/" + name + ".onnx";
  EXPECT_TRUE(WriteFileWhole(path, ExportOnnx(network, table, {96, 64})));
  return path;
}

Network Stirred(const std::string& layout, int num_classes) {
  torch::manual_seed(3);
  const torch::NoGradGuard no_grad;
  Network network(MakeLayout(layout, num_classes));
  for (const auto& buffer : network->named_buffers()) {
    if (buffer.key().ends_with("running_mean")) buffer.value().copy_(torch::randn_like(buffer.value()) * 0.1);
    if (buffer.key().ends_with("running_var")) buffer.value().copy_(0.5 + torch::rand_like(buffer.value()));
  }
  network->eval();
  return network;
}

TEST(ReadTeacher, AnExportedNetworkComesBack) {
  const ClassTable table{{"person", "car", "dining table"}, {"", "", ""}};
  const ClassTable learner{{"door", "dining_table", "person"}, {"", "", ""}};
  for (const char* name : {"yolov5n", "yolov5s"}) {
    Network network = Stirred(name, table.size());
    Result<Teacher> teacher = ReadTeacher(Written(name, network, table), learner);
    ASSERT_TRUE(teacher) << teacher.error().message;
    EXPECT_EQ(teacher->own_class, (std::vector<int64_t>{0, 2}));
    EXPECT_EQ(teacher->learner_class, (std::vector<int64_t>{2, 1}));
    const torch::NoGradGuard no_grad;
    const torch::Tensor pictures = torch::rand({2, 3, 96, 64});
    const auto wanted = network(pictures), given = teacher->network(pictures);
    for (size_t i = 0; i < 3; ++i) EXPECT_LT((wanted[i] - given[i]).abs().max().item<double>(), 1e-3);
  }
}

TEST(ReadTeacher, ARealOneSeesWhatOpenCvSeesWithIt) {
  const char* data = std::getenv("YORB_DATA");
  const std::string path = std::string(data == nullptr ? "" : data) + "/weights/yolov5n_416.onnx";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "YORB_DATA names no folder with weights/yolov5n_416.onnx";
  Result<Teacher> teacher = ReadTeacher(path, ClassTable{{"person"}, {""}});
  ASSERT_TRUE(teacher) << teacher.error().message;
  const torch::NoGradGuard no_grad;
  const torch::Tensor picture = torch::rand({1, 3, 416, 416});
  cv::dnn::Net net = cv::dnn::readNetFromONNX(path);
  const int shape[] = {1, 3, 416, 416};
  net.setInput(cv::Mat(4, shape, CV_32F, picture.data_ptr<float>()));
  std::vector<cv::Mat> outputs;
  net.forward(outputs, net.getUnconnectedOutLayersNames());
  const auto maps = teacher->network(picture);
  for (const torch::Tensor& map : maps) {
    const auto same = std::find_if(outputs.begin(), outputs.end(), [&](const cv::Mat& output) {
      return output.total() == static_cast<size_t>(map.numel());
    });
    ASSERT_NE(same, outputs.end());
    const torch::Tensor other = torch::from_blob(same->data, map.sizes());
    EXPECT_LT((map.sigmoid() - other).abs().max().item<double>(), 1e-3);
  }
}

TEST(ReadTeacher, OtherFilesAreRefused) {
  const ClassTable table{{"person"}, {""}};
  EXPECT_FALSE(ReadTeacher(Written("mo", Stirred("yolo-mo-n", 1), table), table));
  EXPECT_FALSE(ReadTeacher(Written("strange", Stirred("yolov5n", 1), table), ClassTable{{"door"}, {""}}));
  EXPECT_FALSE(ReadTeacher(testing::TempDir() + "/missing.onnx", table));
}

}  // namespace
}  // namespace yorb
