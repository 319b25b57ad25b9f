// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/yolo_detector.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "core/parallel.h"
#include "detection/class_names.h"
#include "detection/test_network.h"
#include "pictures/test_folder.h"

namespace yorb {
namespace {

using testing::HasSubstr;

/// Dark, with squares of 8x8 in pure colours: red at column 1, row 2, green at column 5, row 6 (of cells).
cv::Mat RedAndGreen() {
  cv::Mat bgr(64, 64, CV_8UC3, cv::Scalar::all(20));
  bgr(cv::Rect(8, 16, 8, 8)).setTo(cv::Scalar(0, 0, 255));
  bgr(cv::Rect(40, 48, 8, 8)).setTo(cv::Scalar(0, 255, 0));
  return bgr;
}

Result<std::vector<Box>> BoxesOf(const TestNetwork& net, const std::string& engine, const cv::Mat& picture) {
  const TestFolder folder;
  DetectionOptions options;
  options.model = folder.Write("net.onnx", net.Bytes());
  options.engine = engine;
  auto detector = YoloDetector::Open(options);
  if (!detector) return detector.error();
  auto detections = (*detector)->Detect(ImageSetOf(picture));
  if (!detections) return detections.error();
  return detections->boxes;
}

void ExpectRedAndGreen(const std::vector<Box>& boxes, double scale) {
  ASSERT_EQ(boxes.size(), 2u);
  for (const Box& box : boxes) {
    const bool is_person = box.name == "person";
    EXPECT_NEAR(box.left, (is_person ? 8 : 40) * scale, 0.01 * scale);
    EXPECT_NEAR(box.top, (is_person ? 16 : 48) * scale, 0.01 * scale);
    EXPECT_NEAR(box.right, (is_person ? 16 : 48) * scale, 0.01 * scale);
    EXPECT_NEAR(box.bottom, (is_person ? 24 : 56) * scale, 0.01 * scale);
    EXPECT_GT(box.confidence, 0.9);
  }
  EXPECT_NE(boxes[0].name, boxes[1].name);
}

TEST(YoloDetector, FindsWhatIsThereInPixelsOfThePictureWithEitherEngine) {
  for (const char* engine : {"auto", "opencv", "xnnpack"}) {
    const auto boxes = BoxesOf(TwoColourNetwork(), engine, RedAndGreen());
    ASSERT_TRUE(boxes) << boxes.error().message;
    ExpectRedAndGreen(*boxes, 1);
    cv::Mat large;
    cv::resize(RedAndGreen(), large, {256, 256}, 0, 0, cv::INTER_NEAREST);
    ExpectRedAndGreen(*BoxesOf(TwoColourNetwork(), engine, large), 4);
  }
}

TEST(YoloDetector, ColourOrderAndSizeOfBarsAreTheNetworks) {
  cv::Mat wide(64, 128, CV_8UC3, cv::Scalar::all(20));  // halved, with bars above and below
  wide(cv::Rect(16, 16, 16, 16)).setTo(cv::Scalar(0, 0, 255));
  const auto boxes = BoxesOf(TwoColourNetwork(), "auto", wide);
  ASSERT_TRUE(boxes) << boxes.error().message;
  ASSERT_EQ(boxes->size(), 1u);
  EXPECT_EQ(boxes->front().name, "person");
  EXPECT_NEAR(boxes->front().left, 16, 0.1);
  EXPECT_NEAR(boxes->front().top, 16, 0.1);
  EXPECT_NEAR(boxes->front().bottom, 32, 0.1);
}

TEST(YoloDetector, GreyPicturesAndNothingInThemAreFine) {
  const auto boxes = BoxesOf(TwoColourNetwork(), "auto", cv::Mat(48, 64, CV_8UC1, cv::Scalar(200)));
  ASSERT_TRUE(boxes) << boxes.error().message;
  EXPECT_TRUE(boxes->empty());
}

/// Raw maps whose objectness and class come from how red a cell is; the box is the anchor, which the metadata make 8 px
/// wide and high.
TestNetwork RawMapNetwork() {
  TestNetwork net(64, 64);
  std::vector<float> weights(21 * 2, 0), bias(21, -9);
  for (size_t k = 0; k < 4; ++k) bias[k] = 0;
  weights[4 * 2] = 19, weights[5 * 2] = 19;
  const std::string none = net.Constant({21, 2, 1, 1}, std::vector<float>(42, 0)),
                    all = net.Constant({21, 2, 1, 1}, weights);
  for (const int64_t pool : {4, 1, 2}) {  // in an order of its own
    std::string cells = net.Cells();
    if (pool > 1)
      cells = net.Op("AveragePool", {cells},
                     {IntsAttribute("kernel_shape", {pool, pool}), IntsAttribute("strides", {pool, pool})});
    net.Output(net.Op("Conv", {cells, pool == 1 ? all : none, net.Constant({21}, bias)},
                      {IntsAttribute("kernel_shape", {1, 1})}),
               {1, 21, 8 / pool, 8 / pool});
  }
  net.model.metadata = {{"names", "['person', 'cup']"}, {"anchors", "8,8, 9,9, 9,9, 16,16, 9,9, 9,9, 32,32, 9,9, 9,9"}};
  return net;
}

TEST(YoloDetector, RawMapsFindTheirAnchorsAndLogits) {
  const auto boxes = BoxesOf(RawMapNetwork(), "auto", RedAndGreen());
  ASSERT_TRUE(boxes) << boxes.error().message;
  ASSERT_EQ(boxes->size(), 1u);
  EXPECT_EQ(boxes->front().name, "person");
  EXPECT_NEAR(boxes->front().left, 8, 0.01);
  EXPECT_NEAR(boxes->front().bottom, 24, 0.01);
}

/// Adds an output `people`: how red the cells are, 20 at the most, less 10.
void AddPeople(TestNetwork& net, int64_t num_channels = 1) {
  std::vector<float> weights(static_cast<size_t>(2 * num_channels), 0);
  weights[0] = 20;
  const std::vector<float> bias(static_cast<size_t>(num_channels), -10);
  net.Op("Conv", {net.Cells(), net.Constant({num_channels, 2, 1, 1}, weights), net.Constant({num_channels}, bias)},
         {IntsAttribute("kernel_shape", {1, 1})});
  net.model.nodes.back().outputs = {"people"};
  net.Output("people", {1, num_channels, 8, 8});
  net.model.metadata["people"] = "8";
}

TEST(YoloDetector, AMapOfPeopleIsReadBesideTheBoxes) {
  TestNetwork net = RawMapNetwork();
  AddPeople(net);
  const TestFolder folder;
  for (const char* engine : {"opencv", "xnnpack"}) {
    DetectionOptions options;
    options.model = folder.Write("people.onnx", net.Bytes());
    options.engine = engine;
    const auto detector = YoloDetector::Open(options);
    ASSERT_TRUE(detector) << detector.error().message;
    for (int k = 0; k < 2; ++k) {  // the second run reads only what counts
      const auto seen = (*detector)->Detect(ImageSetOf(RedAndGreen()));
      ASSERT_TRUE(seen) << seen.error().message;
      EXPECT_EQ(seen->boxes.size(), 1u);
      ASSERT_EQ(seen->people.size(), cv::Size(8, 8));
      EXPECT_GT(seen->people.at<uint8_t>(2, 1), 250);
      EXPECT_LT(seen->people.at<uint8_t>(6, 5), 5);
      EXPECT_EQ(cv::countNonZero(seen->people > 5), 1);
    }
  }
}

TEST(YoloDetector, AMapOfPeopleIsNamedInTheFileAndOneNumberACell) {
  TestNetwork wide = RawMapNetwork(), unnamed = RawMapNetwork();
  AddPeople(wide, 2);
  const auto refused = BoxesOf(wide, "auto", RedAndGreen());
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("people"), std::string::npos) << refused.error().message;
  AddPeople(unnamed);
  unnamed.model.metadata.erase("people");
  const TestFolder folder;
  const auto network = OpenNetwork(folder.Write("unnamed.onnx", unnamed.Bytes()), {});
  ASSERT_TRUE(network) << network.error().message;
  EXPECT_FALSE(network->has_people);
}

TEST(YoloDetector, NamesComeFromTheFileThenFromBesideItThenFromNumbers) {
  const TestFolder folder;
  DetectionOptions options;
  options.model = folder.Write("net.onnx", TwoColourNetwork(false).Bytes());
  EXPECT_EQ((*YoloDetector::Open(options))->names(), (std::vector<std::string>{"class0", "class1"}));
  folder.Write("net.names", "person\r\ncup\r\n");
  EXPECT_EQ((*YoloDetector::Open(options))->names(), (std::vector<std::string>{"person", "cup"}));
  folder.Write("net.names", "person\n");
  EXPECT_THAT(YoloDetector::Open(options).error().message,
              testing::AllOf(HasSubstr("net.onnx does not fit"), HasSubstr("net.names, which has 1 class name")));
  TestNetwork odd = TwoColourNetwork(false);
  odd.model.metadata["names"] = "person,cup";
  options.model = folder.Write("odd.onnx", odd.Bytes());
  EXPECT_THAT(YoloDetector::Open(options).error().message,
              testing::AllOf(HasSubstr("odd.onnx carries class names that are no list"), HasSubstr("odd.onnx.names")));
  for (const char* none : {" ", "{}", "[]"}) {
    odd.model.metadata["names"] = none;
    options.model = folder.Write("none.onnx", odd.Bytes());
    EXPECT_EQ((*YoloDetector::Open(options))->names(), (std::vector<std::string>{"class0", "class1"})) << none;
  }
  options.model = folder.Path("odd.onnx");
  folder.Write("odd.onnx.names", "person\ncup\n");
  EXPECT_EQ((*YoloDetector::Open(options))->names(), (std::vector<std::string>{"person", "cup"}));
}

TEST(YoloDetector, MoreThreadsThanTheMachineRunsAreNotTaken) {
  const TestFolder folder;
  DetectionOptions options;
  options.model = folder.Write("net.onnx", TwoColourNetwork(false).Bytes());
  const auto said_for = [&](int threads) {
    options.threads = threads;
    testing::internal::CaptureStderr();
    EXPECT_TRUE(YoloDetector::Open(options));
    return testing::internal::GetCapturedStderr();
  };
  EXPECT_THAT(said_for(NumHardwareThreads()), testing::Not(HasSubstr("detection.threads")));
  const std::string said = said_for(NumHardwareThreads() + 1);
  EXPECT_THAT(said, HasSubstr("the network takes " + std::to_string(NumHardwareThreads())));
}

TEST(YoloDetector, NumbersOfClassesAreNoPartOfTheirNames) {
  const TestFolder folder;
  DetectionOptions options;
  options.model = folder.Write("net.onnx", TwoColourNetwork(false).Bytes());
  const auto names_in = [&](const std::string& text) {
    folder.Write("net.names", text);
    return (*YoloDetector::Open(options))->names();
  };
  const std::vector<std::string> wanted{"person", "paper cup"};
  for (const char* text : {"0 person\n1 paper cup\n", "0: person\n1: paper cup\n", "1\tpaper cup\n0\tperson\n"})
    EXPECT_EQ(names_in(text), wanted) << text;
  for (const auto& [first, second] : {std::pair("1 euro", "2 euro"), std::pair("0 person", "cup"), std::pair("0", "1")})
    EXPECT_EQ(names_in(std::string(first) + "\n" + second), (std::vector<std::string>{first, second}));
  EXPECT_EQ(names_in("1 paper cup\n 0  person"), wanted);
  folder.Write("net.names", "0 a\n0 b\n");
  EXPECT_THAT(YoloDetector::Open(options).error().message,
              HasSubstr("net.names, line 2: the number 0 stands here twice"));
}

TEST(YoloDetector, BoxesThatAreFractionsAreReadWhereTheyAreThoseOfTheInput) {
  const auto read = BoxesOf(TwoColourNetwork(true, {1 / 64.f}), "auto", RedAndGreen());
  ASSERT_TRUE(read) << read.error().message;
  ExpectRedAndGreen(*read, 1);
  const TestNetwork net = TwoColourNetwork(true, {.5f / 64});
  const auto boxes = BoxesOf(net, "auto", RedAndGreen());
  ASSERT_FALSE(boxes);
  EXPECT_THAT(boxes.error().message, testing::AllOf(HasSubstr("net.onnx: "), HasSubstr("fractions of the picture")));
  EXPECT_TRUE(BoxesOf(net, "auto", cv::Mat(64, 64, CV_8UC3, cv::Scalar::all(20)))) << "nothing is there";
}

TEST(YoloDetector, ATinyBoxInTheCornerIsNoFraction) {
  TestNetwork net = TwoColourNetwork();
  for (OnnxTensor& tensor : net.model.constants) {
    if (tensor.dims != std::vector<int64_t>{1, 4, 64}) continue;
    tensor.floats[0] = tensor.floats[64] = .5f, tensor.floats[128] = tensor.floats[192] = 1;  // the first cell's
  }
  const TestFolder folder;
  DetectionOptions options;
  options.model = folder.Write("net.onnx", net.Bytes());
  auto detector = YoloDetector::Open(options);
  ASSERT_TRUE(detector) << detector.error().message;
  const auto expect_one = [&](const cv::Mat& picture) {
    const auto found = (*detector)->Detect(ImageSetOf(picture));
    ASSERT_TRUE(found) << found.error().message;
    ASSERT_EQ(found->boxes.size(), 1u);
    EXPECT_NEAR(found->boxes[0].right, 1, 1e-5);
  };
  cv::Mat tiny(64, 64, CV_8UC3, cv::Scalar::all(20)), with_weak;
  tiny(cv::Rect(0, 0, 8, 8)).setTo(cv::Scalar(0, 0, 255));
  tiny.copyTo(with_weak);
  with_weak(cv::Rect(40, 48, 8, 8)).setTo(cv::Scalar(0, 0, 40));  // a box far below the confidence
  expect_one(with_weak);
  ASSERT_TRUE((*detector)->Detect(ImageSetOf(RedAndGreen())));
  expect_one(tiny);  // by now its boxes are known to be in pixels
}

TEST(YoloDetector, ScoresThatAreNoProbabilitiesAreRefused) {
  const auto complaint = [](float factor, float offset) {
    const auto boxes = BoxesOf(TwoColourNetwork(true, {1, factor, offset}), "auto", RedAndGreen());
    return boxes ? "" : boxes.error().message;
  };
  EXPECT_THAT(complaint(255, 0), testing::AllOf(HasSubstr("net.onnx gives scores"), HasSubstr("sigmoid")));
  EXPECT_THAT(complaint(10, -6), testing::AllOf(HasSubstr("net.onnx gives scores"), HasSubstr("sigmoid")));
  EXPECT_THAT(complaint(1, NAN), testing::AllOf(HasSubstr("net.onnx gives scores"), HasSubstr("no numbers")));
  EXPECT_EQ(complaint(1.000001f, 0), "");
}

TEST(YoloDetector, TheSizeIsTheFilesOrItsMetadatasOrTheUsers) {
  const TestFolder folder;
  DetectionOptions options;
  const auto size_of = [&](const TestNetwork& net) {
    options.model = folder.Write("net.onnx", net.Bytes());
    const auto detector = YoloDetector::Open(options);
    EXPECT_TRUE(detector) << detector.error().message;
    return detector ? (*detector)->input_size() : cv::Size();
  };
  TestNetwork net(96, 64);
  for (const int stride : {8, 16, 32})
    net.Output(net.Op("Sigmoid", {net.Conv("images", 3, 21, stride, stride)}), {1, 21, 64 / stride, 96 / stride});
  for (OnnxNode& node : net.model.nodes) {
    if (node.op == "Conv") node.attributes[2].ints = {0, 0, 0, 0};  // no padding: cells side by side
  }
  EXPECT_EQ(size_of(net), cv::Size(96, 64));
  net.model.inputs[0].dims = {-1, 3, -1, -1};
  net.model.metadata["imgsz"] = "[64, 128]";
  EXPECT_EQ(size_of(net), cv::Size(128, 64)) << "height comes first";
  net.model.metadata["imgsz"] = "160";
  EXPECT_EQ(size_of(net), cv::Size(160, 160));
  net.model.metadata.clear();
  EXPECT_EQ(size_of(net), cv::Size(640, 640));
  options.width = 320, options.height = 256;
  EXPECT_EQ(size_of(net), cv::Size(320, 256));
  net.model.inputs[0].dims = {1, 3, 64, 96};
  EXPECT_EQ(size_of(net), cv::Size(320, 256));
  options.model = folder.Write("decoded.onnx", TwoColourNetwork().Bytes());
  const auto fixed = YoloDetector::Open(options);
  ASSERT_FALSE(fixed) << "its boxes are decoded for one size within the graph";
  EXPECT_THAT(fixed.error().message, HasSubstr("decoded.onnx"));
}

// Of 75 numbers a cell without names, YOLOv5's come from one convolution: 20 classes; YOLOv8's own from two: 11.
TEST(YoloDetector, MapsWithoutNamesAreToldByWhatMadeThem) {
  const auto open = [](bool is_joined) {
    TestNetwork net(64, 64);
    for (const int64_t stride : {8, 16, 32}) {
      const auto cells = [&](int64_t size) { return net.Conv("images", 3, size, 1, stride); };
      const std::string map =
          is_joined ? net.Op("Concat", {cells(64), cells(11)}, {IntAttribute("axis", 1)}) : cells(75);
      net.Output(map, {1, 75, 64 / stride, 64 / stride});
    }
    const TestFolder folder;
    DetectionOptions options;
    options.model = folder.Write("net.onnx", net.Bytes());
    return YoloDetector::Open(options);
  };
  const auto fives = open(false), eights = open(true);
  ASSERT_TRUE(fives) << fives.error().message;
  EXPECT_EQ((*fives)->names().size(), 20u);
  ASSERT_FALSE(eights);
  EXPECT_THAT(eights.error().message, HasSubstr("whether these are YOLOv8's maps or YOLOv5's is not said"));
}

TEST(YoloDetector, EightyClassesWithoutNamesAreCocos) {
  TestNetwork net(64, 64);
  net.Output(net.Op("Mul", {net.Constant({1, 84, 84}, std::vector<float>(84 * 84, 0)),
                            net.Reshaped(net.Op("GlobalAveragePool", {net.Conv("images", 3, 1, 1, 1)}), {1, 1, 1})}),
             {1, 84, 84});
  const TestFolder folder;
  DetectionOptions options;
  options.model = folder.Write("net.onnx", net.Bytes());
  const auto detector = YoloDetector::Open(options);
  ASSERT_TRUE(detector) << detector.error().message;
  EXPECT_EQ((*detector)->names(), CocoNames());
}

TEST(YoloDetector, CornerRowsOfAllCellsStillHaveTheirDoubles) {
  const auto num_boxes = [](int64_t num_rows) {
    TestNetwork net(64, 64);
    std::vector<float> rows(static_cast<size_t>(num_rows) * 6, 0);
    const float twice[] = {8, 16, 24, 32, .9f, 1, 8, 16, 25, 33, .8f, 1};
    std::copy(twice, twice + 12, rows.begin());
    const std::string picture = net.Reshaped(net.Op("GlobalAveragePool", {net.Conv("images", 3, 1, 1, 1)}), {1, 1, 1});
    const std::string nothing = net.Op("Mul", {picture, net.Constant({1}, {0})});
    net.Output(net.Op("Add", {net.Constant({1, num_rows, 6}, rows), nothing}), {1, num_rows, 6});
    net.model.metadata["names"] = "['person', 'cup', 'dog']";
    const auto boxes = BoxesOf(net, "auto", RedAndGreen());
    EXPECT_TRUE(boxes) << boxes.error().message;
    return boxes ? boxes->size() : 0;
  };
  EXPECT_EQ(num_boxes(300), 2u) << "they were chosen within the graph";
  EXPECT_EQ(num_boxes(84), 1u) << "a row a cell";
}

TEST(YoloDetector, WhatIsNoDetectorIsRefusedByNameBeforeItRuns) {
  const TestFolder folder;
  const auto complaint = [&](const std::string& bytes) {
    DetectionOptions options;
    options.model = folder.Write("bad.onnx", bytes);
    const auto detector = YoloDetector::Open(options);
    EXPECT_FALSE(detector);
    return detector ? std::string() : detector.error().message;
  };
  EXPECT_THAT(complaint("no network"), HasSubstr("bad.onnx is no ONNX file"));
  TestNetwork classifier(64, 64);
  classifier.Output(classifier.Reshaped(classifier.Op("GlobalAveragePool", {"images"}), {1, 3}), {1, 3});
  EXPECT_THAT(complaint(classifier.Bytes()), testing::AllOf(HasSubstr("bad.onnx"), HasSubstr("(1, 3)")));
  TestNetwork odd = TwoColourNetwork();
  odd.model.inputs[0].dims = {1, 64, 64, 3};
  EXPECT_THAT(complaint(odd.Bytes()), testing::AllOf(HasSubstr("bad.onnx"), HasSubstr("its input stand last")));
  odd.model.inputs[0].dims = {1, 64, 64, 5};
  EXPECT_THAT(complaint(odd.Bytes()), testing::AllOf(HasSubstr("bad.onnx"), HasSubstr("(1, 64, 64, 5)")));
  odd.model.inputs[0].dims = {1, 3, 64, 50};
  EXPECT_THAT(complaint(odd.Bytes()), testing::AllOf(HasSubstr("multiples of 32"), HasSubstr("not 50x64")));
  TestNetwork named = TwoColourNetwork();
  named.model.metadata["names"] = "person and cup";
  EXPECT_THAT(complaint(named.Bytes()), HasSubstr("person and cup"));
  DetectionOptions options;
  options.model = "no_such.onnx";
  EXPECT_THAT(YoloDetector::Open(options).error().message, HasSubstr("no_such.onnx does not exist"));
}

}  // namespace
}  // namespace yorb
