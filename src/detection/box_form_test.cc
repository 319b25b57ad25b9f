// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/box_form.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "detection/test_network.h"
#include "detection/yolo_detector.h"
#include "pictures/test_folder.h"

namespace yorb {
namespace {

using testing::HasSubstr;

/// How a head gives its boxes and scores.
struct Head {
  BoxForm form = BoxForm::kCentre;
  float scale = 1;             ///< of the boxes
  bool is_apart = false;       ///< boxes and scores are outputs of their own
  bool are_columns = false;    ///< the cells stand last
  float objectness = 1;        ///< of rows of all cells
  float most_of_a_colour = 1;  ///< what the network takes for a full one; negative: in the order B, G, R
};

/// A box of its own size for each of the 64 cells of 8x8, by their middles, and nothing in the 20 coarser cells.
std::vector<float> Places(const Head& head) {
  std::vector<float> boxes(4 * 84, 0);
  for (size_t i = 0; i < 64; ++i) {
    const float x = static_cast<float>(i % 8) * 8, y = static_cast<float>(i / 8) * 8;
    std::vector<float> box{x + 4, y + 4, 8, 8};
    if (head.form == BoxForm::kCorners) box = {x, y, x + 8, y + 8};
    if (head.form == BoxForm::kRelative) box = {.5f, .5f, 0, 0};
    for (size_t k = 0; k < 4; ++k) boxes[k * 84 + i] = box[k] * head.scale;
  }
  return boxes;
}

/// Person from red, cup from green: (1, 2, 84).
std::string ScoresOf(TestNetwork& net, const Head& head) {
  const float by = 1 / std::abs(head.most_of_a_colour);
  const std::vector<float> rgb{by, -by, -by, -by, by, -by}, bgr{-by, -by, by, -by, by, -by};
  const std::string mixed =
      net.Op("Relu", {net.Op("Conv", {"images", net.Constant({2, 3, 1, 1}, head.most_of_a_colour < 0 ? bgr : rgb)},
                             {IntsAttribute("kernel_shape", {1, 1})})});
  const std::string cells =
      net.Op("AveragePool", {mixed}, {IntsAttribute("kernel_shape", {8, 8}), IntsAttribute("strides", {8, 8})});
  return net.Op("Concat", {net.Reshaped(cells, {1, 2, 64}), net.Constant({1, 2, 20}, std::vector<float>(40, 0))},
                {IntAttribute("axis", 2)});
}

TestNetwork NetworkOf(const Head& head) {
  TestNetwork net(64, 64);
  net.model.metadata["names"] = "{0: 'person', 1: 'cup'}";
  const std::string scores = ScoresOf(net, head), boxes = net.Op("Identity", {net.Constant({1, 4, 84}, Places(head))});
  const auto give = [&](const std::string& value, int64_t size) {
    const std::string turned = net.Op("Transpose", {value}, {IntsAttribute("perm", {0, 2, 1})});
    net.Output(head.are_columns ? value : turned,
               head.are_columns ? std::vector<int64_t>{1, size, 84} : std::vector<int64_t>{1, 84, size});
  };
  if (head.is_apart) {
    give(scores, 2), give(boxes, 4);
  } else {
    const std::string objectness = net.Constant({1, 1, 84}, std::vector<float>(84, head.objectness));
    give(net.Op("Concat", {boxes, objectness, scores}, {IntAttribute("axis", 1)}), 7);
  }
  return net;
}

Result<std::vector<Box>> BoxesOf(const TestNetwork& net) {
  const TestFolder folder;
  DetectionOptions options;
  options.model = folder.Write("net.onnx", net.Bytes());
  auto detector = YoloDetector::Open(options);
  if (!detector) return detector.error();
  cv::Mat bgr(64, 64, CV_8UC3, cv::Scalar::all(20));
  bgr(cv::Rect(8, 16, 8, 8)).setTo(cv::Scalar(0, 0, 255));
  bgr(cv::Rect(40, 48, 8, 8)).setTo(cv::Scalar(0, 255, 0));
  auto detections = (*detector)->Detect(ImageSetOf(bgr));
  if (!detections) return detections.error();
  return detections->boxes;
}

void ExpectRedAndGreen(const Result<std::vector<Box>>& boxes) {
  ASSERT_TRUE(boxes) << boxes.error().message;
  ASSERT_EQ(boxes->size(), 2u);
  for (const Box& box : *boxes) {
    EXPECT_NEAR(box.left, box.name == "person" ? 8 : 40, .01);
    EXPECT_NEAR(box.top, box.name == "person" ? 16 : 48, .01);
    EXPECT_NEAR(box.right, box.name == "person" ? 16 : 48, .01);
    EXPECT_GT(box.confidence, .6);
  }
  EXPECT_NE((*boxes)[0].name, (*boxes)[1].name);
}

void ExpectRedAndGreen(const Head& head) { ExpectRedAndGreen(BoxesOf(NetworkOf(head))); }

std::string Refusal(const Head& head) {
  const auto boxes = BoxesOf(NetworkOf(head));
  return boxes ? std::string() : boxes.error().message;
}

TEST(BoxForm, BoxesApartAreCornersOrCentresWhateverOutputTheyAre) {
  for (const BoxForm form : {BoxForm::kCentre, BoxForm::kCorners}) {
    ExpectRedAndGreen({.form = form, .is_apart = true});
    ExpectRedAndGreen({.form = form, .is_apart = true, .are_columns = true});
  }
  ExpectRedAndGreen({.form = BoxForm::kCorners, .scale = 1 / 64.f, .is_apart = true});
  EXPECT_THAT(Refusal({.form = BoxForm::kCorners, .scale = .3f, .is_apart = true}),
              testing::AllOf(HasSubstr("net.onnx gives boxes (1, 84, 4)"), HasSubstr("export it")));
}

TEST(BoxForm, ColumnsMayBeOfCornersWhereTheNetworkShowsIt) {
  TestNetwork net = TwoColourNetwork();
  OnnxTensor& places = *std::find_if(net.model.constants.begin(), net.model.constants.end(), [](const OnnxTensor& c) {
    return c.dims == std::vector<int64_t>{1, 4, 64};
  });
  for (size_t i = 0; i < 64; ++i) {
    for (const size_t k : {0, 1}) {
      const float centre = places.floats[k * 64 + i];
      places.floats[k * 64 + i] = centre - 4, places.floats[(k + 2) * 64 + i] = centre + 4;
    }
  }
  ExpectRedAndGreen(BoxesOf(net));
}

TEST(BoxForm, YoloxIsHandedPicturesAsItWasTrainedOnThem) {
  ExpectRedAndGreen({.form = BoxForm::kRelative, .objectness = .8f, .most_of_a_colour = -255});
}

TEST(BoxForm, RowsOfAllCellsWithoutObjectnessAreYoloSix) {
  ExpectRedAndGreen({.form = BoxForm::kCentre});
  // YOLOX with its boxes decoded would want its pixels in another way, and nothing says so.
  EXPECT_THAT(Refusal({.form = BoxForm::kCentre, .objectness = .8f}),
              testing::AllOf(HasSubstr("net.onnx gives rows of all cells"), HasSubstr("decode_in_inference")));
}

}  // namespace
}  // namespace yorb
