// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/opencv_misreading.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "detection/test_engines.h"

namespace yorb {
namespace {

using Attributes = std::vector<OnnxAttribute>;

/// Makes the node in question of a picture of 3 channels, 8 x 6.
using Build = std::function<std::string(TestNetwork&)>;

std::string ComplaintOfOpenCv(const Build& build, int64_t opset = 13) {
  TestNetwork net(8, 6, opset);
  net.Output(build(net), {1, 3, 6, 8});
  const auto engine = MakeOpenCvEngine(*ReadOnnxBytes(net.Bytes(), "test.onnx"), InputOf(net.model));
  return engine ? "" : engine.error().message;
}

Build One(const std::string& op, const Attributes& attributes) {
  return [=](TestNetwork& net) { return net.Op(op, {"images"}, attributes); };
}

Attributes Window(int64_t side, int64_t stride, Attributes more) {
  Attributes attributes{IntsAttribute("kernel_shape", {side, side}), IntsAttribute("strides", {stride, stride})};
  attributes.insert(attributes.end(), more.begin(), more.end());
  return attributes;
}

void ExpectRefused(const std::string& op, const Build& build, int64_t opset = 13) {
  EXPECT_THAT(ComplaintOfOpenCv(build, opset),
              testing::AllOf(testing::HasSubstr("test.onnx cannot be run by OpenCV"),
                             testing::HasSubstr("other numbers than the file means for its operator " + op + ":")));
}

void ExpectTaken(const Build& build, int64_t opset = 13) { EXPECT_EQ(ComplaintOfOpenCv(build, opset), ""); }

TEST(OpenCvMisreading, Windows) {
  const OnnxAttribute edge = IntsAttribute("pads", {1, 1, 1, 1}), counts = IntAttribute("count_include_pad", 1);
  ExpectRefused("AveragePool", One("AveragePool", Window(3, 2, {edge, counts})));
  ExpectTaken(One("AveragePool", Window(3, 2, {edge})));
  ExpectTaken(One("AveragePool", Window(2, 2, {counts})));
  const OnnxAttribute lower = TextAttribute("auto_pad", "SAME_LOWER"), upper = TextAttribute("auto_pad", "SAME_UPPER");
  for (const char* op : {"AveragePool", "MaxPool"}) {
    ExpectRefused(op, One(op, Window(2, 2, {lower})));
    ExpectTaken(One(op, Window(2, 2, {upper})));
    ExpectTaken(One(op, Window(3, 1, {lower})));
  }
  ExpectRefused("MaxPool", One("MaxPool", Window(3, 1, {IntsAttribute("dilations", {2, 2})})));
  const auto convolution = [](const char* op, const Attributes& attributes) {
    return [=](TestNetwork& net) { return net.Op(op, {"images", net.Random({3, 3, 3, 3})}, attributes); };
  };
  ExpectRefused("Conv", convolution("Conv", Window(3, 2, {lower})));
  ExpectTaken(convolution("Conv", Window(3, 2, {upper})));
  ExpectRefused("ConvTranspose", convolution("ConvTranspose", Window(3, 1, {IntsAttribute("dilations", {2, 2})})));
  ExpectRefused("ConvTranspose", convolution("ConvTranspose", Window(3, 2, {IntsAttribute("output_shape", {12, 16})})));
  ExpectTaken(convolution("ConvTranspose", Window(3, 2, {})));
}

TEST(OpenCvMisreading, SoftmaxOfSeveralAxes) {
  for (const char* op : {"Softmax", "LogSoftmax"}) {
    const auto along = [&](int64_t axis) { return One(op, {IntAttribute("axis", axis)}); };
    for (const int64_t axis : {0, 1, 2, -2}) {
      ExpectRefused(op, along(axis), 11);
      ExpectTaken(along(axis), 13);
    }
    for (const int64_t axis : {3, -1}) ExpectTaken(along(axis), 11);
    ExpectRefused(op, One(op, {}), 11);
    ExpectRefused(op, One(op, {}), 13);
    const Build of_means = [&](TestNetwork& net) {
      return net.Op(op, {net.Op("GlobalAveragePool", {"images"})}, {IntAttribute("axis", 1)});
    };
    ExpectTaken(of_means, 11);
  }
}

TEST(OpenCvMisreading, ResizeWherePixelsLieElsewhere) {
  const auto resize = [](const std::string& mode, const std::string& place, float scale) {
    return [=](TestNetwork& net) {
      return net.Op("Resize", {"images", "", net.Constant({4}, {1, 1, scale, scale})},
                    {TextAttribute("mode", mode), TextAttribute("coordinate_transformation_mode", place)});
    };
  };
  ExpectTaken(resize("nearest", "half_pixel", 2));
  ExpectRefused("Resize", resize("linear", "half_pixel", 1.3f));
  ExpectTaken(resize("linear", "half_pixel", 1.5f));
  ExpectTaken(resize("linear", "align_corners", 1.3f));
  const Build behind_unknown = [&](TestNetwork& net) {
    const std::string unknown = net.Op("Elu", {"images"});
    return net.Op("Resize", {unknown, "", net.Constant({4}, {1, 1, 2, 2})},
                  {TextAttribute("mode", "nearest"), TextAttribute("nearest_mode", "ceil")});
  };
  ExpectRefused("Resize", behind_unknown);
}

TEST(OpenCvMisreading, Arithmetic) {
  const auto by = [](const char* op, const std::vector<int64_t>& dims, bool is_first) {
    return [=](TestNetwork& net) {
      const std::string constant = net.Random(dims);
      return is_first ? net.Op(op, {constant, "images"}) : net.Op(op, {"images", constant});
    };
  };
  ExpectRefused("Div", by("Div", {1, 3, 1, 1}, true));
  ExpectTaken(by("Div", {1, 3, 1, 1}, false));
  ExpectTaken(by("Div", {1}, true));
  for (const char* op : {"Greater", "Less"}) {
    ExpectRefused(op, by(op, {1}, true));
    ExpectTaken(by(op, {1}, false));
  }
  ExpectRefused("PRelu", by("PRelu", {6, 1}, false));
  ExpectRefused("PRelu", by("PRelu", {3, 6, 8}, false));
  for (const std::vector<int64_t>& slopes : {std::vector<int64_t>{3, 1, 1}, {1, 3, 1, 1}, {1}})
    ExpectTaken(by("PRelu", slopes, false));
  const auto of_means = [](bool is_first) {
    return [=](TestNetwork& net) {
      const std::string means = net.Op("GlobalAveragePool", {"images"});
      return is_first ? net.Op("Div", {means, "images"}) : net.Op("Div", {"images", means});
    };
  };
  ExpectRefused("Div", of_means(true));
  ExpectTaken(of_means(false));
  const auto product = [](Attributes attributes) {
    attributes.push_back(IntAttribute("transB", 1));
    return [=](TestNetwork& net) {
      return net.Op("Gemm", {net.Op("Flatten", {"images"}), net.Random({5, 144}), net.Random({5})}, attributes);
    };
  };
  ExpectRefused("Gemm", product({FloatAttribute("alpha", .5f)}));
  ExpectRefused("Gemm", product({FloatAttribute("beta", 2)}));
  ExpectTaken(product({}));
}

TEST(OpenCvMisreading, WhatMovesNumbersAbout) {
  const auto split = [](const std::vector<int64_t>& sizes) {
    return [=](TestNetwork& net) {
      return net.Op("Neg", {net.Ops("Split", {"images", net.Whole(sizes)}, {IntAttribute("axis", 3)}, 2)[1]});
    };
  };
  ExpectRefused("Split", split({2, 6}));
  ExpectTaken(split({4, 4}));
  const auto gather = [](int64_t axis) {
    return [=](TestNetwork& net) { return net.Op("Gather", {"images", net.Whole({1})}, {IntAttribute("axis", axis)}); };
  };
  ExpectRefused("Gather", gather(-1));
  ExpectTaken(gather(3));
  const Build quantised = [](TestNetwork& net) {
    const std::string step = net.Constant({}, {.05f});
    return net.Op("DequantizeLinear", {net.Op("QuantizeLinear", {"images", step}), step});
  };
  ExpectRefused("DequantizeLinear", quantised);
  const auto cast = [](const char* op) {
    return [=](TestNetwork& net) { return net.Op("Cast", {net.Op(op, {"images"})}, {IntAttribute("to", kOnnxInt64)}); };
  };
  ExpectRefused("Cast", cast("Exp"));
  ExpectTaken(cast("Floor"));
  const auto sums = [](const std::vector<int64_t>& axis, int64_t is_exclusive) {
    return [=](TestNetwork& net) {
      return net.Op("CumSum", {"images", net.Whole(axis)}, {IntAttribute("exclusive", is_exclusive)});
    };
  };
  ExpectRefused("CumSum", sums({1}, 0));
  ExpectRefused("CumSum", sums({-1}, 1));
  ExpectTaken(sums({-1}, 0));
}

}  // namespace
}  // namespace yorb
