// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/edge_maps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "detection/test_network.h"
#include "detection/yolo_detector.h"
#include "pictures/test_folder.h"

namespace yorb {
namespace {

using testing::HasSubstr;

struct Kind {
  bool is_joined = true, are_logits = true, has_names = true;
};

/// YOLOv8's maps for 64x64 px: each cell of 8x8 sees a box from one cell and a half left and above its middle to half a
/// cell right and below; person from red, cup from green. The finest maps come last.
TestNetwork EdgeNetwork(const Kind& kind) {
  TestNetwork net(64, 64);
  if (kind.has_names) net.model.metadata["names"] = "{0: 'person', 1: 'cup'}";
  for (const int64_t stride : {32, 16, 8}) {
    const int64_t side = 64 / stride, cells = side * side;
    std::vector<float> numbers(static_cast<size_t>(64 * cells), -50);
    for (int64_t edge = 0; edge < 4; ++edge) {  // half as far as the next number, each as likely
      for (const int64_t bin : {edge < 2 ? 1 : 0, edge < 2 ? 2 : 1})
        std::fill_n(numbers.begin() + (edge * kEdgeBins + bin) * cells, cells, 3.f);
    }
    const std::string edges = net.Op("Identity", {net.Constant({1, 64, side, side}, numbers)});
    std::string scores = net.Cells();
    if (stride > 8)
      scores = net.Op("Mul", {net.Op("AveragePool", {scores},
                                     {IntsAttribute("kernel_shape", {stride / 8, stride / 8}),
                                      IntsAttribute("strides", {stride / 8, stride / 8})}),
                              net.Constant({}, {0})});
    scores = net.Op("Mul", {net.Op("Sub", {scores, net.Constant({}, {.5f})}), net.Constant({}, {20})});
    if (!kind.are_logits) scores = net.Op("Sigmoid", {scores});
    if (kind.is_joined) {
      net.Output(net.Op("Concat", {edges, scores}, {IntAttribute("axis", 1)}), {1, 66, side, side});
    } else {
      net.Output(scores, {1, 2, side, side});
      net.Output(edges, {1, 64, side, side});
      net.Output(net.Op("ReduceSum", {scores, net.Whole({1})}), {1, 1, side, side});
    }
  }
  return net;
}

Result<std::vector<Box>> BoxesOf(const Kind& kind) {
  const TestFolder folder;
  DetectionOptions options;
  options.model = folder.Write("net.onnx", EdgeNetwork(kind).Bytes());
  auto detector = YoloDetector::Open(options);
  if (!detector) return detector.error();
  cv::Mat bgr(64, 64, CV_8UC3, cv::Scalar::all(20));
  bgr(cv::Rect(16, 16, 8, 8)).setTo(cv::Scalar(0, 0, 255));
  bgr(cv::Rect(40, 48, 8, 8)).setTo(cv::Scalar(0, 255, 0));
  auto detections = (*detector)->Detect(ImageSetOf(bgr));
  if (!detections) return detections.error();
  return detections->boxes;
}

TEST(EdgeMaps, YoloEightsOwnMapsGiveTheirBoxes) {
  for (const Kind& kind :
       {Kind{}, Kind{.are_logits = false}, Kind{.is_joined = false}, Kind{.is_joined = false, .are_logits = false},
        Kind{.is_joined = false, .has_names = false}}) {
    const auto boxes = BoxesOf(kind);
    ASSERT_TRUE(boxes) << boxes.error().message;
    ASSERT_EQ(boxes->size(), 2u);
    for (const Box& box : *boxes) {
      const bool is_person = box.name == (kind.has_names ? "person" : "class0");
      EXPECT_NEAR(box.left, is_person ? 8 : 32, 1e-3);
      EXPECT_NEAR(box.top, is_person ? 8 : 40, 1e-3);
      EXPECT_NEAR(box.right, is_person ? 24 : 48, 1e-3);
      EXPECT_NEAR(box.bottom, is_person ? 24 : 56, 1e-3);
      EXPECT_GT(box.confidence, .9);
    }
    EXPECT_NE((*boxes)[0].name, (*boxes)[1].name);
  }
}

TEST(EdgeMaps, MapsThatMayBeYoloFivesNeedNames) {
  const auto boxes = BoxesOf({.has_names = false});
  ASSERT_FALSE(boxes);
  EXPECT_THAT(boxes.error().message, testing::AllOf(HasSubstr("(1, 66, 2, 2)"), HasSubstr(".names")));
}

TEST(EdgeMaps, PartsThatDoNotFitTogetherAreNone) {
  HeadFacts facts;
  facts.width = facts.height = 64;
  const auto found = [&](const std::vector<std::vector<int64_t>>& shapes, int num_names) {
    facts.shapes = shapes, facts.num_names = num_names;
    return EdgeMapsOf(facts).has_value();
  };
  EXPECT_TRUE(found({{1, 144, 8, 8}, {1, 144, 4, 4}, {1, 144, 2, 2}}, 80));
  EXPECT_FALSE(found({{1, 144, 8, 8}, {1, 144, 4, 4}, {1, 144, 2, 2}}, 79));
  EXPECT_FALSE(found({{1, 144, 8, 8}, {1, 144, 4, 4}}, 80));
  EXPECT_FALSE(found({{1, 144, 8, 8}, {1, 144, 4, 4}, {1, 144, 4, 4}}, 80));
  const std::vector<std::vector<int64_t>> coarse{{1, 64, 4, 4}, {1, 3, 4, 4}, {1, 64, 2, 2}, {1, 3, 2, 2}};
  const auto with = [&](std::vector<std::vector<int64_t>> finest) {
    finest.insert(finest.end(), coarse.begin(), coarse.end());
    return finest;
  };
  EXPECT_TRUE(found(with({{1, 64, 8, 8}, {1, 3, 8, 8}}), 0));
  EXPECT_FALSE(found(with({{1, 64, 8, 8}, {1, 4, 8, 8}}), 0)) << "classes that differ";
  EXPECT_FALSE(found(with({{1, 64, 8, 8}, {1, 64, 8, 8}}), 0)) << "which is which?";
  EXPECT_FALSE(found(with({{1, 64, 8, 8}, {1, 3, 8, 8}, {1, 32, 8, 8}}), 0)) << "masks' numbers, too";
}

}  // namespace
}  // namespace yorb
