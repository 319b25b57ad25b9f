// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/shaped_engine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "detection/test_network.h"
#include "detection/yolo_detector.h"
#include "pictures/test_folder.h"

namespace yorb {
namespace {

/// Three raw maps for 64x64 px and one class: every cell of 8x8 sees a box of its own size with as much confidence as
/// there is red in it; the coarser maps see nothing. It has nothing but convolutions and means, as ours.
TestNetwork RedCells() {
  TestNetwork net(64, 64);
  net.model.metadata["names"] = "{0: 'person'}";
  const std::string red = net.Cells();
  for (int stride = 8; stride <= 32; stride *= 2) {
    std::vector<float> weights(18 * 2, 0), biases(18, -20);
    if (stride == 8) {
      biases[0] = biases[1] = biases[5] = 0;  // the middle of the cell, sure of the class
      biases[2] = static_cast<float>(std::log(0.5 * std::sqrt(8 / 10.) / (1 - 0.5 * std::sqrt(8 / 10.))));
      biases[3] = static_cast<float>(std::log(0.5 * std::sqrt(8 / 13.) / (1 - 0.5 * std::sqrt(8 / 13.))));
      biases[4] = -10, weights[4 * 2] = 40, biases[5] = 20;
    }
    const std::string size = std::to_string(stride);
    const std::string cells = stride == 8 ? red
                                          : net.Op("MaxPool", {red},
                                                   {IntsAttribute("kernel_shape", {stride / 8, stride / 8}),
                                                    IntsAttribute("strides", {stride / 8, stride / 8})});
    net.Output(net.Op("Conv", {cells, net.Constant({18, 2, 1, 1}, weights), net.Constant({18}, biases)},
                      {IntsAttribute("kernel_shape", {1, 1})}),
               {1, 18, 64 / stride, 64 / stride});
  }
  return net;
}

/// A dark picture with a red square of 8x8 at column 5, row 2 (of cells).
cv::Mat OneRed(int width, int height) {
  cv::Mat bgr(height, width, CV_8UC3, cv::Scalar::all(20));
  bgr(cv::Rect(40, 16, 8, 8)).setTo(cv::Scalar(0, 0, 255));
  return bgr;
}

Result<std::unique_ptr<YoloDetector>> Open(const TestFolder& folder, const TestNetwork& net) {
  DetectionOptions options;
  options.model = folder.Write("net.onnx", net.Bytes());
  return YoloDetector::Open(options);
}

/// RedCells whose file says at what longer sides single pictures are looked at, ready for them.
std::unique_ptr<YoloDetector> OpenWithStills(const TestFolder& folder, const std::string& stills) {
  TestNetwork net = RedCells();
  net.model.metadata["stills"] = stills;
  auto detector = Open(folder, net);
  EXPECT_TRUE(detector) << detector.error().message;
  if (!detector) return nullptr;
  EXPECT_TRUE((*detector)->FitToPictures({}));
  return *std::move(detector);
}

void ExpectOneRed(YoloDetector& detector, const cv::Mat& picture, double scale) {
  const auto found = detector.Detect(ImageSetOf(picture));
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->boxes.size(), 1u);
  EXPECT_NEAR(found->boxes[0].left, 40 * scale, 0.1 * scale);
  EXPECT_NEAR(found->boxes[0].top, 16 * scale, 0.1 * scale);
  EXPECT_NEAR(found->boxes[0].right, 48 * scale, 0.1 * scale);
  EXPECT_NEAR(found->boxes[0].bottom, 24 * scale, 0.1 * scale);
}

TEST(InputSizeFor, TheLongerSideIsKeptAndTheOtherFollows) {
  EXPECT_EQ(InputSizeFor({640, 480}, 416), cv::Size(416, 320));
  EXPECT_EQ(InputSizeFor({480, 640}, 416), cv::Size(320, 416));
  EXPECT_EQ(InputSizeFor({100, 100}, 320), cv::Size(320, 320));
  EXPECT_EQ(InputSizeFor({1280, 720}, 400), cv::Size(416, 256));  // 400 is no whole number of cells
  EXPECT_EQ(InputSizeFor({5000, 10}, 416), cv::Size(416, 32));
}

TEST(FitToPictures, EveryShapeShowsTheSame) {
  const TestFolder folder;
  auto detector = Open(folder, RedCells());
  ASSERT_TRUE(detector) << detector.error().message;
  ExpectOneRed(**detector, OneRed(64, 64), 1);
  ASSERT_TRUE((*detector)->FitToPictures({128}));
  for (const cv::Size size : {cv::Size(128, 64), cv::Size(128, 128), cv::Size(64, 128), cv::Size(128, 96)}) {
    ExpectOneRed(**detector, OneRed(size.width, size.height), 1);
    ExpectOneRed(**detector, OneRed(size.width, size.height), 1);  // by the engine that is there now
  }
  cv::Mat large;
  cv::resize(OneRed(128, 64), large, {}, 3, 3, cv::INTER_NEAREST);
  ExpectOneRed(**detector, large, 3);
}

TEST(FitToPictures, TheFileSaysHowLarge) {
  const TestFolder folder;
  const auto detector = OpenWithStills(folder, "128");
  ASSERT_NE(detector, nullptr);
  ExpectOneRed(*detector, OneRed(128, 64), 1);
  EXPECT_EQ(detector->input_size(), cv::Size(64, 64));
}

TEST(FitToPictures, SeveralLooksSeeAThingWhereItIs) {
  const TestFolder folder;
  const auto detector = OpenWithStills(folder, "[192, 192, 96]");
  ASSERT_NE(detector, nullptr);
  const cv::Mat picture = OneRed(192, 64);
  const auto found = detector->Detect(ImageSetOf(picture));
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->boxes.size(), 1u);
  EXPECT_NEAR(found->boxes[0].confidence, 2. / 3, .01);  // at 96 px it is half a cell and not red enough
  ASSERT_TRUE(detector->FitToPictures({192, 192}));
  ExpectOneRed(*detector, picture, 1);  // the second look sees it mirrored
}

TEST(FitToPictures, ANetworkOfOneSizeKeepsIt) {
  const TestFolder folder;
  auto detector = Open(folder, TwoColourNetwork());
  ASSERT_TRUE(detector) << detector.error().message;
  EXPECT_TRUE((*detector)->FitToPictures({}));
  const Status refused = (*detector)->FitToPictures({128});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, testing::HasSubstr("64x64 alone"));
  ExpectOneRed(**detector, OneRed(64, 64), 1);
}

}  // namespace
}  // namespace yorb
