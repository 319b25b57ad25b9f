// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/own_suppression.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "detection/test_network.h"
#include "detection/yolo_detector.h"
#include "pictures/test_folder.h"

namespace yorb {
namespace {

using testing::HasSubstr;

/// Puts a suppression of doubles behind a value (1, 4+C, N), as exports with nms=True have it, with a confidence of its
/// own; the output says in rows of six what is left.
void Suppress(TestNetwork& net, const std::string& all, int64_t num_classes, float confidence) {
  const std::string rows = net.Op("Transpose", {all}, {IntsAttribute("perm", {0, 2, 1})});
  const auto parts = net.Ops("Split", {rows, net.Whole({4, num_classes})}, {IntAttribute("axis", 2)}, 2);
  const std::string scores = net.Op("Transpose", {parts[1]}, {IntsAttribute("perm", {0, 2, 1})});
  const std::string kept = net.Op("NonMaxSuppression", {parts[0], scores, net.Whole({300}), net.Constant({1}, {.45f}),
                                                        net.Constant({1}, {confidence})});
  const std::string place = net.Op("Gather", {kept, net.Whole({2})}, {IntAttribute("axis", 1)});
  net.model.outputs.clear();
  net.Output(net.Op("Gather", {parts[0], place}, {IntAttribute("axis", 1)}), {1, 300, 6});
}

/// A red square of 8x8 at column 1, row 2 (of cells), a weak one at column 5.
cv::Mat RedAndWeak() {
  cv::Mat bgr(64, 64, CV_8UC3, cv::Scalar::all(20));
  bgr(cv::Rect(8, 16, 8, 8)).setTo(cv::Scalar(0, 0, 255));
  bgr(cv::Rect(40, 16, 8, 8)).setTo(cv::Scalar(0, 0, 100));
  return bgr;
}

Result<std::vector<Box>> BoxesOf(const TestNetwork& net, double confidence) {
  const TestFolder folder;
  DetectionOptions options;
  options.model = folder.Write("net.onnx", net.Bytes());
  options.confidence = confidence;
  auto detector = YoloDetector::Open(options);
  if (!detector) return detector.error();
  auto detections = (*detector)->Detect(ImageSetOf(RedAndWeak()));
  if (!detections) return detections.error();
  return detections->boxes;
}

TEST(OwnSuppression, BoxesAreThoseOfTheNetworkWithoutItAndTheOptionsCount) {
  TestNetwork net = TwoColourNetwork();
  Suppress(net, net.model.outputs[0].name, 2, .9f);
  for (const double confidence : {.2, .6}) {
    const auto plain = BoxesOf(TwoColourNetwork(), confidence), given = BoxesOf(net, confidence);
    ASSERT_TRUE(given) << given.error().message;
    ASSERT_EQ(given->size(), confidence < .5 ? 2u : 1u);
    ASSERT_EQ(plain->size(), given->size());
    for (size_t i = 0; i < given->size(); ++i) {
      EXPECT_EQ((*given)[i].name, "person");
      EXPECT_EQ((*given)[i].left, (*plain)[i].left);
      EXPECT_EQ((*given)[i].bottom, (*plain)[i].bottom);
      EXPECT_EQ((*given)[i].confidence, (*plain)[i].confidence);
    }
  }
}

TEST(OwnSuppression, WhatStandsBeforeTheDecodingIsNotTakenForBoxes) {
  // 64 numbers of the edges and two scores, as YOLOv8 has them before: without names they might be 62 classes.
  TestNetwork net(64, 64);
  const std::string scores = net.Reshaped(net.Cells(), {1, 2, 64});
  const std::string edges = net.Constant({1, 64, 64}, std::vector<float>(64 * 64, .5f));
  const std::string used = net.Op("Concat", {edges, scores}, {IntAttribute("axis", 1)});
  const std::string all =
      net.Op("Concat", {used, net.Constant({1, 66, 20}, std::vector<float>(66 * 20, 0))}, {IntAttribute("axis", 2)});
  Suppress(net, all, 62, .25f);
  const auto given = BoxesOf(net, .25);
  ASSERT_FALSE(given);
  EXPECT_THAT(given.error().message, testing::AllOf(HasSubstr("net.onnx"), HasSubstr("export it")));
}

}  // namespace
}  // namespace yorb
