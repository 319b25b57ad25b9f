// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/detector.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "datasets/test_recording.h"
#include "detection/test_network.h"
#include "pictures/png.h"

namespace yorb {
namespace {

/// Two rows with names of their own, a concatenation between them, and three heads of two classes.
TestNetwork NamedNetwork() {
  TestNetwork net(64, 64);
  const std::string first = net.Op("Relu", {net.Conv("images", 3, 8, 3, 2)});
  const std::string expanded = net.Conv(first, 8, 16, 1, 1), deep = net.Conv(expanded, 16, 16, 3, 2, 16);
  const std::string pooled =
      net.Op("MaxPool", {first}, {IntsAttribute("kernel_shape", {2, 2}), IntsAttribute("strides", {2, 2})});
  const std::string both = net.Op("Concat", {deep, pooled}, {IntAttribute("axis", 1)});
  const std::string cells = net.Conv(both, 24, 8, 3, 2);
  const std::string coarse = net.Conv(cells, 8, 8, 3, 2), coarser = net.Conv(coarse, 8, 8, 3, 2);
  for (const auto& [value, size] : {std::pair(cells, 8), std::pair(coarse, 4), std::pair(coarser, 2)})
    net.Output(net.Op("Sigmoid", {net.Conv(value, 8, 21, 1, 1)}), {1, 21, size, size});
  net.model.metadata["names"] = "['person', 'cup']";
  net.model.nodes[0].name = "0";
  net.model.nodes[2].name = "1.expand";
  net.model.nodes[3].name = "1.dw";
  return net;
}

TEST(BenchDetector, TakesANetworkApart) {
  const TestFolder folder;
  folder.Write("net.onnx", NamedNetwork().Bytes());
  const auto network = OpenNetwork(folder.Path("net.onnx"), {});
  ASSERT_TRUE(network) << network.error().message;
  const NetworkTable table = TableOf(*network);
  ASSERT_GE(table.rows.size(), 4u);
  EXPECT_EQ(table.rows[0].name, "0");
  EXPECT_EQ(table.rows[0].from, "picture");
  EXPECT_EQ(table.rows[0].parameters, 3 * 8 * 9 + 8);
  EXPECT_EQ(table.rows[0].module, "Conv3x3/2 Relu MaxPool");
  EXPECT_NEAR(table.rows[0].gflops, 2e-9 * 3 * 8 * 9 * 32 * 32, 1e-15);
  EXPECT_EQ(table.rows[1].name, "1");
  EXPECT_EQ(table.rows[1].from, "0");
  EXPECT_EQ(table.rows[1].parameters, 8 * 16 + 16 + 16 * 9 + 16);
  EXPECT_EQ(table.rows[1].module, "Conv1x1 DWConv3x3/2");
  EXPECT_EQ(table.rows[1].shape, (std::vector<int64_t>{1, 16, 16, 16}));
  EXPECT_EQ(table.rows[2].module, "Concat");
  EXPECT_EQ(table.rows[2].from, "0, 1");
  int64_t sum = 0;
  for (const NetworkRow& row : table.rows) sum += row.parameters;
  EXPECT_EQ(table.parameters, sum);
  EXPECT_EQ(table.num_convolutions, 9u);
}

TEST(BenchDetector, RunsJudgesAndDrawsAllNetworks) {
  const TestFolder folder;
  folder.Write("a.onnx", NamedNetwork().Bytes());
  folder.Write("b.onnx", TwoColourNetwork().Bytes());
  cv::Mat picture(64, 64, CV_8UC3, cv::Scalar::all(20));
  picture(cv::Rect(8, 16, 8, 8)).setTo(cv::Scalar(0, 0, 255));
  folder.WritePicture("set/images/1.png", picture);
  folder.Write("set/labels/1.txt", "0 0.1875 0.3125 0.125 0.125\n");
  DetectorBenchOptions options;
  options.models = {folder.Path("a.onnx"), folder.Path("b.onnx")};
  options.labelled = folder.Path("set");
  options.rounds = 2;
  const auto report = MeasureDetectors(options);
  ASSERT_TRUE(report) << report.error().message;
  const auto json = nlohmann::json::parse(DetectorJson(*report));
  ASSERT_EQ(json["networks"].size(), 2u);
  EXPECT_EQ(json["networks"][0]["name"], "a");
  EXPECT_GT(json["networks"][0]["latency_ms"], 0);
  EXPECT_GT(json["networks"][0]["ratio_to_opencv"], 0);
  EXPECT_NEAR(json["networks"][1]["map50"], 1, 1e-9);
  EXPECT_THAT(DetectorText(*report), testing::AllOf(testing::HasSubstr("Layers of a"), testing::HasSubstr("mAP50-95")));
  const auto figures = DetectorFigures({folder.Path("set/images/1.png")}, options, "out");
  ASSERT_TRUE(figures) << figures.error().message;
  ASSERT_EQ(figures->files.size(), 1u);
  const std::string& png = figures->files.front().content;
  EXPECT_EQ(DecodePng(png).pixels.size(), cv::Size(128, 64));
}

TEST(BenchDetector, PicturesThatCannotBeReadAreLeftOutAndTold) {
  const TestFolder folder;
  folder.Write("net.onnx", NamedNetwork().Bytes());
  folder.WritePicture("set/images/1.png", TestColour(1));
  folder.Write("set/images/2.png", "torn");
  folder.Write("set/labels/1.txt", "0 0.5 0.5 0.25 0.25\n");
  folder.Write("set/classes.txt", "person\ncup\n");
  WriteRecording(folder, "room", 3);
  folder.Write("room/rgb/1.png", "");
  folder.Write("room/people.txt", Stamp(0) + " 0 0 32 48 1500\n");
  DetectorBenchOptions options;
  options.models = {folder.Path("net.onnx"), folder.Path("net.onnx")};
  options.labelled = folder.Path("set");
  options.sequences = {folder.Path("room")};
  options.rounds = 1;
  const auto report = MeasureDetectors(options);
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->networks[1].judgement->num_pictures, 1u);
  EXPECT_EQ(report->networks[1].people[0].num_pictures, 2u);
  EXPECT_EQ(report->unreadable().count(), 2u) << "each once, however many networks there are";
  const std::string told = report->unreadable().Told().error().message;
  EXPECT_THAT(told, testing::AllOf(testing::HasSubstr("2.png"), testing::HasSubstr("rgb/1.png")));
  const auto figures = DetectorFigures({folder.Path("set/images/2.png")}, options, "out");
  ASSERT_TRUE(figures) << figures.error().message;
  EXPECT_TRUE(figures->files.empty());
  EXPECT_FALSE(figures->unreadable.Told().ok());
}

TEST(BenchDetector, PeopleAreFoundOnceAndBoxesOnNobodyAreFalse) {
  const cv::Size size(100, 100);
  const TruePerson near{{}, {"person", 1, 10, 10, 30, 50}, 500}, far{{}, {"person", 1, 60, 10, 70, 20}, 100};
  const TruePerson hidden{{}, {"person", 1, 60, 40, 90, 90}, 400};
  EXPECT_TRUE(MustBeFound(near, 100, 100));
  EXPECT_FALSE(MustBeFound(far, 100, 100)) << "1 % of the picture";
  EXPECT_FALSE(MustBeFound(hidden, 100, 100)) << "27 % body";
  const std::vector<Box> found{{"Person", .9, 11, 10, 30, 50},
                               {"person", .8, 10, 10, 30, 50},
                               {"person", .7, 60, 40, 90, 90},
                               {"chair", .6, 0, 0, 9, 9}};
  const PeopleScore score = ScorePeople(found, {near, far, hidden}, size);
  EXPECT_EQ(score.num_true, 1u);
  EXPECT_EQ(score.num_found, 1u);
  EXPECT_EQ(score.num_false, 1u) << "the second box on the same person";
  EXPECT_EQ(ScorePeople({}, {near}, size).recall(), 0);
}

TEST(BenchDetector, PeopleOfASequenceAreSought) {
  const TestFolder folder;
  WriteRecording(folder, "room", 2);
  folder.Write("room/people.txt", "# people\n" + Stamp(0) + " 0 0 32 48 1500\n" + Stamp(1) + " 0 0 32 48 1500\n");
  NullDetector nobody;
  const auto score = MeasurePeople(folder.Path("room"), nobody, nullptr);
  ASSERT_TRUE(score) << score.error().message;
  EXPECT_EQ(score->num_pictures, 2u);
  EXPECT_EQ(score->num_true, 2u);
  EXPECT_EQ(score->num_found, 0u);
  folder.Write("room/people.txt", "1 2 3\n");
  EXPECT_THAT(MeasurePeople(folder.Path("room"), nobody, nullptr).error().message,
              testing::HasSubstr("people.txt, line 1"));
}

}  // namespace
}  // namespace yorb
