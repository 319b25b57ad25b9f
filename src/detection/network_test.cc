// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/network.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "detection/test_network.h"
#include "detection/yolo_detector.h"
#include "pictures/test_folder.h"

namespace yorb {
namespace {

/// TwoColourNetwork with an input of another kind; what it needs to make the usual one of it comes first.
TestNetwork WithInput(OnnxType type, bool is_channels_last, bool divides) {
  TestNetwork net = TwoColourNetwork();
  OnnxValue& input = net.model.inputs[0];
  input.type = type;
  if (is_channels_last) input.dims = {1, 64, 64, 3};
  const std::vector<OnnxNode> rest = std::exchange(net.model.nodes, {});
  std::string usual = "images";
  if (type != kOnnxFloat) usual = net.Op("Cast", {usual}, {IntAttribute("to", kOnnxFloat)});
  if (is_channels_last) usual = net.Op("Transpose", {usual}, {IntsAttribute("perm", {0, 3, 1, 2})});
  if (divides) usual = net.Op("Div", {usual, net.Constant({}, {255})});
  for (size_t i = 0; i < net.model.nodes.size(); ++i) {
    OnnxNode& node = net.model.nodes[i];
    node.name = "first" + std::to_string(i);
    for (std::string& name : node.inputs) name = name[0] == 'n' ? "first_" + name : name;
    for (std::string& name : node.outputs) name = "first_" + name;
  }
  for (OnnxNode node : rest) {
    for (std::string& name : node.inputs) name = name == "images" ? "first_" + usual : name;
    net.model.nodes.push_back(node);
  }
  return net;
}

TEST(Network, BytesAndChannelsThatStandLastAreReadAsTheFileMeansThem) {
  cv::Mat bgr(64, 64, CV_8UC3, cv::Scalar::all(20));
  bgr(cv::Rect(8, 16, 8, 8)).setTo(cv::Scalar(0, 0, 255));
  bgr(cv::Rect(40, 48, 8, 8)).setTo(cv::Scalar(0, 255, 0));
  const TestFolder folder;
  for (const TestNetwork& net :
       {WithInput(kOnnxUint8, false, true), WithInput(kOnnxUint8, true, true), WithInput(kOnnxFloat, true, false)}) {
    DetectionOptions options;
    options.model = folder.Write("net.onnx", net.Bytes());
    auto detector = YoloDetector::Open(options);
    ASSERT_TRUE(detector) << detector.error().message;
    const auto found = (*detector)->Detect(ImageSetOf(bgr));
    ASSERT_TRUE(found) << found.error().message;
    ASSERT_EQ(found->boxes.size(), 2u);
    for (const Box& box : found->boxes) {
      EXPECT_NEAR(box.left, box.name == "person" ? 8 : 40, .01);
      EXPECT_NEAR(box.top, box.name == "person" ? 16 : 48, .01);
      EXPECT_GT(box.confidence, .9);
    }
  }
}

TEST(Network, AnOutputWithoutAnAxisForPicturesIsReadAsOneWithIt) {
  TestNetwork net = TwoColourNetwork();
  const std::string flat = net.Reshaped(net.model.outputs[0].name, {6, 84});
  net.model.outputs.clear();
  net.Output(flat, {6, 84});
  const TestFolder folder;
  DetectionOptions options;
  options.model = folder.Write("net.onnx", net.Bytes());
  auto detector = YoloDetector::Open(options);
  ASSERT_TRUE(detector) << detector.error().message;
  cv::Mat bgr(64, 64, CV_8UC3, cv::Scalar::all(20));
  bgr(cv::Rect(8, 16, 8, 8)).setTo(cv::Scalar(0, 0, 255));
  const auto found = (*detector)->Detect(ImageSetOf(bgr));
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->boxes.size(), 1u);
  EXPECT_EQ(found->boxes[0].name, "person");
}

}  // namespace
}  // namespace yorb
