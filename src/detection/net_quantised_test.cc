// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Quantised operators, against loops that do the same one by one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "detection/test_engines.h"

namespace yorb {
namespace {

using Floats = std::vector<float>;

std::string Short(TestNetwork& net, OnnxType type, const std::vector<int64_t>& dims, const std::vector<int64_t>& ints) {
  const std::string name = net.Whole(ints);
  net.model.constants.back().dims = dims, net.model.constants.back().type = type;
  return name;
}

/// The channel values of the picture that Compiled shows, 0 to 1, in the order (channel, row, column).
Floats PixelsOf(int width, int height) {
  const cv::Mat picture = TestPicture(width, height);
  Floats pixels;
  for (int channel = 0; channel < 3; ++channel) {
    for (int i = 0; i < width * height; ++i)
      pixels.push_back(static_cast<float>(picture.at<cv::Vec3b>(i / width, i % width)[channel] / 255.0));
  }
  return pixels;
}

float HalfToEven(float number) { return std::nearbyint(number); }

TEST(NetQuantised, NumbersAreRoundedAndCutAsTheirTypeSays) {
  struct Kind {
    OnnxType type;
    int64_t zero;
    float least, most;
  };
  for (const Kind& kind :
       {Kind{kOnnxUint8, 100, 0, 255}, Kind{kOnnxInt8, -28, -128, 127}, Kind{kOnnxUint16, 65400, 0, 65535}}) {
    TestNetwork net(8, 4);
    const std::string scale = net.Constant({}, {1 / 200.f}), zero = Short(net, kind.type, {}, {kind.zero});
    const std::string quantised = net.Op("QuantizeLinear", {"images", scale, zero});
    if (kind.type == kOnnxUint16) net.model.nodes.back().domain = "com.microsoft";  // as ONNX Runtime writes it
    net.Output(net.Op("DequantizeLinear", {quantised, scale, zero}), {});
    const Floats pixels = PixelsOf(8, 4), given = Compiled(net);
    ASSERT_EQ(given.size(), pixels.size());
    for (size_t i = 0; i < given.size(); ++i) {
      const auto offset = static_cast<float>(kind.zero);
      const float wanted = std::clamp(HalfToEven(pixels[i] * 200) + offset, kind.least, kind.most) - offset;
      EXPECT_NEAR(given[i], wanted / 200, 1e-6) << pixels[i];
    }
  }
}

TEST(NetQuantised, WeightsWithAScaleForEachOutputAreThoseOfAConvolution) {
  const std::vector<int64_t> weights{-128, 127, 5, 100, -100, 17};
  const Floats scales{.01f, .02f}, offsets{3, -4};
  Floats plain;
  for (size_t i = 0; i < weights.size(); ++i)
    plain.push_back((static_cast<float>(weights[i]) - offsets[i / 3]) * scales[i / 3]);
  const auto convolved = [&](bool is_quantised) {
    TestNetwork net(8, 4);
    std::string kernel = net.Constant({2, 3, 1, 1}, plain);
    if (is_quantised)
      kernel = net.Op("DequantizeLinear",
                      {Short(net, kOnnxInt8, {2, 3, 1, 1}, weights), net.Constant({2}, scales),
                       Short(net, kOnnxInt8, {2}, {3, -4})},
                      {IntAttribute("axis", 0)});
    net.Output(net.Op("Conv", {"images", kernel}, {IntsAttribute("kernel_shape", {1, 1})}), {});
    return Compiled(net);
  };
  const Floats given = convolved(true), wanted = convolved(false);
  ASSERT_EQ(given.size(), wanted.size());
  for (size_t i = 0; i < given.size(); ++i) EXPECT_NEAR(given[i], wanted[i], 1e-5) << i;
}

TEST(NetQuantised, WholeConvolutionsOfNumbersQuantisedOnTheWayAreRightToTheirStep) {
  const std::vector<int64_t> weights{228, 28, 128, 100, 200, 130};  // less 128, in hundredths
  TestNetwork net(8, 4);
  const auto quantised = net.Ops("DynamicQuantizeLinear", {"images"}, {}, 3);
  const std::string whole = net.Op(
      "ConvInteger",
      {quantised[0], Short(net, kOnnxUint8, {2, 3, 1, 1}, weights), quantised[2], Short(net, kOnnxUint8, {}, {128})},
      {IntsAttribute("kernel_shape", {1, 1})});
  const std::string factor = net.Op("Mul", {quantised[1], net.Constant({}, {.01f})});
  net.Output(net.Op("Mul", {net.Op("Cast", {whole}, {IntAttribute("to", kOnnxFloat)}), factor}), {});
  const Floats pixels = PixelsOf(8, 4), given = Compiled(net);
  ASSERT_EQ(given.size(), 64u);
  for (size_t i = 0; i < given.size(); ++i) {
    float wanted = 0;
    for (size_t channel = 0; channel < 3; ++channel)
      wanted += pixels[channel * 32 + i % 32] * static_cast<float>(weights[i / 32 * 3 + channel] - 128) / 100;
    EXPECT_NEAR(given[i], wanted, 3 * .5 / 255) << i;
  }
}

TEST(NetQuantised, ScalesThatDoNotFitAndUnknownTypesAreRefused) {
  const auto refusal = [](const std::vector<int64_t>& scale_dims, OnnxType type, float scale_is = 1) {
    TestNetwork net(8, 4);
    const std::string scale = net.Constant(scale_dims, Floats(static_cast<size_t>(scale_dims[0]), scale_is));
    net.Output(net.Op("QuantizeLinear", {"images", scale, Short(net, type, {1}, {0})}), {});
    const auto engine = MakeXnnpackEngine(*ReadOnnxBytes(net.Bytes(), "a.onnx"), InputOf(net.model), 1);
    return engine ? std::string() : engine.error().message;
  };
  EXPECT_EQ(refusal({3}, kOnnxUint8), "");
  EXPECT_THAT(refusal({2}, kOnnxUint8), testing::HasSubstr("QuantizeLinear: its scales do not fit"));
  for (const float scale : {0.f, -1.f, HUGE_VALF, std::nanf("")})
    EXPECT_THAT(refusal({1}, kOnnxUint8, scale), testing::HasSubstr("a scale that is not above 0"));
  EXPECT_THAT(refusal({1}, kOnnxInt64), testing::HasSubstr("QuantizeLinear: it is to a type"));
}

}  // namespace
}  // namespace yorb
