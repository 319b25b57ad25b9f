// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Operators that choose among numbers, against loops that do the same one by one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "detection/test_engines.h"

namespace yorb {
namespace {

using Floats = std::vector<float>;

/// The pixels that Compiled shows, in the order (channel, row, column), 0 to 1.
Floats Pixels(int width, int height) {
  const cv::Mat picture = TestPicture(width, height);
  Floats pixels;
  for (int i = 0; i < 3 * width * height; ++i)
    pixels.push_back(static_cast<float>(picture.at<cv::Vec3b>(i / width % height, i % width)[i / (width * height)]) /
                     255);
  return pixels;
}

std::vector<Floats> AllCompiled(const TestNetwork& net) {
  const auto model = ReadOnnxBytes(net.Bytes(), "test.onnx");
  EXPECT_TRUE(model) << model.error().message;
  const EngineInput input = InputOf(*model);
  return RunBy(MakeXnnpackEngine(*model, input, 1), TestPicture(input.width, input.height), 2);
}

std::string Refusal(const TestNetwork& net) {
  const auto engine = MakeXnnpackEngine(*ReadOnnxBytes(net.Bytes(), "a.onnx"), InputOf(net.model), 1);
  return engine ? "" : engine.error().message;
}

void ExpectNear(const Floats& given, const Floats& wanted) {
  ASSERT_EQ(given.size(), wanted.size());
  for (size_t i = 0; i < given.size(); ++i) EXPECT_NEAR(given[i], wanted[i], 1e-5) << i;
}

TEST(NetSelection, TheLargestComeInTheirOrderAndOfEqualOnesTheFirst) {
  TestNetwork net(2, 1);  // its numbers are constants; the picture is there for the program to have one
  const std::string numbers = net.Constant({2, 5}, {3, 1, 4, 1, 5, 2, 7, 7, 0, 7});
  const auto best = net.Ops("TopK", {numbers, net.Whole({3})}, {IntAttribute("axis", -1)}, 2);
  const auto least = net.Ops("TopK", {numbers, net.Whole({2})}, {IntAttribute("largest", 0)}, 2);
  const auto down = net.Ops("TopK", {numbers, net.Whole({1})}, {IntAttribute("axis", 0)}, 2);
  for (const auto& pair : {best, least, down}) net.Output(pair[0], {}), net.Output(pair[1], {});
  const auto given = AllCompiled(net);
  ASSERT_EQ(given.size(), 6u);
  EXPECT_EQ(given[0], (Floats{5, 4, 3, 7, 7, 7}));
  EXPECT_EQ(given[1], (Floats{4, 2, 0, 1, 2, 4}));
  EXPECT_EQ(given[2], (Floats{1, 1, 0, 2}));
  EXPECT_EQ(given[3], (Floats{1, 3, 3, 0}));
  EXPECT_EQ(given[4], (Floats{3, 7, 7, 1, 7}));
  EXPECT_EQ(given[5], (Floats{0, 1, 1, 0, 1}));
  TestNetwork many(2, 1);
  many.Output(many.Ops("TopK", {"images", many.Whole({3})}, {}, 2)[0], {});
  EXPECT_THAT(Refusal(many), testing::HasSubstr("more than there are"));
}

TEST(NetSelection, WhatIsComputedMayNameWhatIsTaken) {
  constexpr int kWidth = 4, kHeight = 3, kRow = kWidth;
  TestNetwork net(kWidth, kHeight);
  const auto place = [&](const std::string& axis_input) {  // (1, 3, 3): the column of the largest in each row
    return net.Op("ArgMax", {axis_input}, {IntAttribute("axis", 3), IntAttribute("keepdims", 0)});
  };
  const std::string column = place("images");
  const std::string apart = net.Op("Unsqueeze", {column, net.Whole({3})});  // (1, 3, 3, 1)
  net.Output(net.Op("GatherElements", {"images", apart}, {IntAttribute("axis", 3)}), {});
  const std::string table = net.Constant({4, 2}, {0, .5f, 1, 1.5f, 2, 2.5f, 3, 3.5f});
  net.Output(net.Op("Gather", {table, column}), {});
  const std::string index =
      net.Op("Concat", {apart, net.Op("Mod", {apart, net.Whole({2})})}, {IntAttribute("axis", 3)});
  net.Output(net.Op("GatherND", {table, index}), {});
  net.Output(net.Op("ScatterND", {net.Constant({4}, {9, 9, 9, 9}), net.Whole({2}), net.Constant({}, {5})}), {});
  net.Output(net.Op("Div", {column, net.Whole({2})}), {});
  const auto given = AllCompiled(net);
  const Floats pixels = Pixels(kWidth, kHeight);
  ASSERT_EQ(given.size(), 5u);
  Floats largest, rows, single, half;
  for (size_t row = 0; row < 9; ++row) {
    const auto first = pixels.begin() + static_cast<int64_t>(row) * kRow;
    const auto best = std::max_element(first, first + kRow);
    const auto at = static_cast<float>(best - first);
    largest.push_back(*best);
    rows.push_back(at), rows.push_back(at + .5f);
    single.push_back(std::fmod(at, 2.f) == 0 ? at : at + .5f);
    half.push_back(std::floor(at / 2));
  }
  ExpectNear(given[0], largest);
  ExpectNear(given[1], rows);
  ExpectNear(given[2], single);
  ExpectNear(given[3], {9, 9, 5, 9});
  ExpectNear(given[4], half);
}

TEST(NetSelection, IndicesThatLeadAstrayStayWithinTheirAxis) {
  TestNetwork net(4, 2);
  const std::string wild = net.Op("Mul", {"images", net.Constant({1}, {1e30f})});
  const std::string table = net.Constant({1, 3, 2, 4}, Floats(24, 7));
  net.Output(net.Op("GatherElements", {table, wild}, {IntAttribute("axis", 3)}), {});
  net.Output(net.Op("Gather", {net.Constant({3}, {7, 7, 7}), net.Op("Log", {net.Op("Neg", {"images"})})}), {});
  for (const Floats& numbers : AllCompiled(net)) EXPECT_EQ(numbers, Floats(24, 7));
}

TEST(NetSelection, TilesFramesAndBackwardSlicesAreAsTheyAreWritten) {
  TestNetwork net(3, 2);
  net.Output(net.Op("Tile", {"images", net.Whole({1, 1, 2, 3})}), {});
  net.Output(net.Op("Pad", {"images", net.Whole({0, 0, 1, 2, 0, 0, 0, 1}), net.Constant({}, {.25f})}), {});
  net.Output(net.Op("Slice", {"images", net.Whole({-1}), net.Whole({-1000}), net.Whole({1}), net.Whole({-1})}), {});
  net.Output(net.Op("Slice", {"images", net.Whole({2}), net.Whole({0}), net.Whole({3}), net.Whole({-1})}), {});
  const auto given = AllCompiled(net);
  const Floats pixels = Pixels(3, 2);
  const auto pixel = [&](int c, int y, int x) { return pixels[static_cast<size_t>((c * 2 + y) * 3 + x)]; };
  Floats tiled, framed, turned, cut;
  for (int c = 0; c < 3; ++c) {
    for (int y = 0; y < 4; ++y) {
      for (int x = 0; x < 9; ++x) tiled.push_back(pixel(c, y % 2, x % 3));
    }
    for (int y = -1; y < 2; ++y) {
      for (int x = -2; x < 4; ++x) framed.push_back(y < 0 || x < 0 || x > 2 ? .25f : pixel(c, y, x));
    }
    for (int i = 0; i < 6; ++i) turned.push_back(pixel(2 - c, i / 3, i % 3));
    for (int i = 0; i < 4; ++i) cut.push_back(pixel(c, i / 2, 2 - i % 2));
  }
  ExpectNear(given[0], tiled);
  ExpectNear(given[1], framed);
  ExpectNear(given[2], turned);
  ExpectNear(given[3], cut);
}

TEST(NetSelection, ComparisonsNormalisationAndChoicesAreAsTheyAreWritten) {
  TestNetwork net(4, 2);
  const std::string half = net.Constant({1}, {.5f});
  net.Output(net.Op("Where", {net.Op("Greater", {"images", half}), "images", net.Op("Neg", {"images"})}), {});
  const std::string low =
      net.Op("Not", {net.Op("Cast", {net.Op("GreaterOrEqual", {"images", half})}, {IntAttribute("to", kOnnxBool)})});
  net.Output(net.Op("Cast", {low}, {IntAttribute("to", kOnnxFloat)}), {});
  net.Output(net.Op("BatchNormalization",
                    {"images", net.Constant({3}, {1, 2, 3}), net.Constant({3}, {0, .5f, 1}),
                     net.Constant({3}, {.1f, .2f, .3f}), net.Constant({3}, {1, 4, .25f})},
                    {FloatAttribute("epsilon", 0)}),
             {});
  net.Output(net.Op("Cast", {net.Op("Mul", {"images", net.Constant({1}, {10})})}, {IntAttribute("to", kOnnxInt64)}),
             {});
  net.Output(net.Op("Cast", {"images"}, {IntAttribute("to", kOnnxBfloat16)}), {});
  const auto given = AllCompiled(net);
  const Floats pixels = Pixels(4, 2);
  const Floats scale{1, 2, 3}, shift{0, .5f, 1}, mean{.1f, .2f, .3f}, deviation{1, 2, .5f};
  for (size_t i = 0; i < 24; ++i) {
    const float value = pixels[i];
    EXPECT_NEAR(given[0][i], value > .5f ? value : -value, 1e-6);
    EXPECT_EQ(given[1][i], value >= .5f ? 0 : 1);
    EXPECT_NEAR(given[2][i], (value - mean[i / 8]) / deviation[i / 8] * scale[i / 8] + shift[i / 8], 1e-5);
    EXPECT_EQ(given[3][i], std::floor(value * 10));
    EXPECT_NEAR(given[4][i], value, 1e-6);  // all is kept as floats
  }
}

TEST(NetSelection, PartsOfAShapeAreThoseThatAreAskedFor) {
  TestNetwork net(4, 2, 15);
  const std::string sides = net.Op("Shape", {"images"}, {IntAttribute("start", 2)});
  const std::string rest = net.Op("Shape", {"images"}, {IntAttribute("start", -4), IntAttribute("end", -2)});
  for (const std::string& part : {sides, rest}) net.Output(part, {2});
  const auto given = AllCompiled(net);
  EXPECT_EQ(given[0], (Floats{2, 4}));
  EXPECT_EQ(given[1], (Floats{1, 3}));
  TestNetwork open(4, 2);
  open.Output(open.Op("Clip", {"images", "", open.Op("ReduceMax", {"images"}, {IntAttribute("keepdims", 0)})}), {});
  EXPECT_THAT(Refusal(open), testing::HasSubstr("not known beforehand"));
}

TEST(NetSelection, TransposedConvolutionsAreOpenCvs) {
  for (const auto& [kernel, stride, pad] : {std::tuple(2, 2, 0), std::tuple(3, 1, 1), std::tuple(4, 2, 1)}) {
    TestNetwork net(10, 6);
    const auto pair = [](int64_t size) { return std::vector<int64_t>{size, size}; };
    net.Output(net.Op("ConvTranspose", {"images", net.Random({3, 5, kernel, kernel}), net.Random({5})},
                      {IntsAttribute("kernel_shape", pair(kernel)), IntsAttribute("strides", pair(stride)),
                       IntsAttribute("pads", {pad, pad, pad, pad})}),
               {});
    ExpectAsOpenCv(net);
  }
}

}  // namespace
}  // namespace yorb
