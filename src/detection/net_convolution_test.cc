// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Convolutions and enlargements, whichever way they are done, against OpenCV's and their definitions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <string>
#include <utility>
#include <vector>

#include "detection/make_engine.h"
#include "detection/net_join.h"
#include "detection/test_engines.h"
#include "detection/test_network.h"

namespace yorb {
namespace {

TEST(NetConvolution, ConvolutionsOfAllKindsAreAsOpenCvs) {
  for (const auto& [kernel, stride, group] : {std::tuple(1, 1, 1), std::tuple(3, 2, 1), std::tuple(5, 1, 8),
                                              std::tuple(3, 2, 8), std::tuple(3, 1, 4), std::tuple(6, 2, 1)}) {
    TestNetwork net(64, 32);
    const std::string x = net.Conv("images", 3, 8, 3, 1);
    const auto size = [&, k = kernel, step = stride](int64_t before) { return (before + k / 2 * 2 - k) / step + 1; };
    net.Output(net.Conv(x, 8, 16, kernel, stride, group), {1, 16, size(32), size(64)});
    ExpectAsOpenCv(net);
  }
}

TEST(NetConvolution, ConvolutionsOfEachChannelByItselfAreAsOpenCvs) {
  for (const auto& [width, height] : {std::pair(20, 16), std::pair(13, 7), std::pair(1, 1), std::pair(6, 3)}) {
    for (const int64_t kernel : {3, 5, 7}) {
      for (const int64_t stride : {1, 2, 3}) {
        TestNetwork net(width, height);
        const std::string wide = net.Conv("images", 3, 56, 1, 1);
        const std::string part =
            net.Op("Slice", {wide, net.Whole({8}), net.Whole({48}), net.Whole({1})});  // pixels with gaps between them
        const auto size = [&, step = stride](int64_t before) { return (before - 1) / step + 1; };
        const std::string deep = net.Conv(part, 40, 40, kernel, stride, 40);
        net.Output(kernel == 3 ? net.Op("Relu", {deep}) : deep, {1, 40, size(height), size(width)});
        ExpectAsOpenCv(net);
      }
    }
  }
}

TEST(NetConvolution, PaddingOfConvolutionsMayBeUneven) {
  TestNetwork net(12, 9);
  const std::string x = net.Conv("images", 3, 24, 1, 1);
  net.Output(net.Op("Conv", {x, net.Random({24, 1, 3, 3}, .5)},
                    {IntsAttribute("kernel_shape", {3, 3}), IntsAttribute("strides", {2, 2}),
                     IntsAttribute("pads", {0, 1, 2, 0}), IntAttribute("group", 24)}),
             {1, 24, 5, 6});
  ExpectAsOpenCv(net);
}

TEST(NetConvolution, ConvolutionsByWinogradsWayAreAsOpenCvs) {
  for (const auto& [width, height] : {std::pair(16, 8), std::pair(15, 9), std::pair(1, 1), std::pair(2, 7),
                                      std::pair(16, 16), std::pair(19, 14), std::pair(13, 17), std::pair(32, 3)}) {
    TestNetwork net(width, height, 11);
    const std::string wide = net.Conv("images", 3, 80, 1, 1);
    const std::string part =
        net.Ops("Split", {wide}, {IntAttribute("axis", 1), IntsAttribute("split", {48, 32})}, 2)[1];
    net.Output(net.Op("Relu", {net.Conv(part, 32, 40, 3, 1)}), {1, 40, height, width});
    const std::string no_bias = net.Op("Conv", {wide, net.Random({32, 80, 3, 3}, .1)},
                                       {IntsAttribute("kernel_shape", {3, 3}), IntsAttribute("pads", {1, 1, 1, 1})});
    net.Output(no_bias, {1, 32, height, width});
    ExpectAsOpenCv(net);
  }
}

TEST(NetConvolution, EnlargedPicturesAreConvolvedBeforeTheyAreEnlarged) {
  for (const bool has_relu : {false, true}) {
    TestNetwork net(32, 16);
    const std::string large = net.Conv("images", 3, 24, 3, 1), small = net.Conv(large, 24, 40, 3, 2);
    const auto up = [&](const std::string& x, float by) {
      return net.Op("Resize", {x, "", net.Constant({4}, {1, 1, by, by})},
                    {TextAttribute("mode", "nearest"), TextAttribute("coordinate_transformation_mode", "asymmetric"),
                     TextAttribute("nearest_mode", "floor")});
    };
    const std::string joined =
        net.Op("Concat", {up(small, 2), large, up(net.Conv(small, 40, 8, 3, 2), 4)}, {IntAttribute("axis", 1)});
    for (const int64_t out : {16, 20}) {
      const std::string mixed = net.Conv(joined, 72, out, 1, 1);
      net.Output(has_relu ? net.Op("Relu", {mixed}) : mixed, {1, out, 16, 32});
    }
    EXPECT_EQ(NodesToPutOff(net.model).size(), 3);
    ExpectAsOpenCv(net);
  }
}

TEST(NetConvolution, EnlargedPicturesThatOthersReadAreMade) {
  TestNetwork net(32, 16);
  const std::string large = net.Conv("images", 3, 24, 3, 1);
  const std::string up =
      net.Op("Resize", {net.Conv(large, 24, 40, 3, 2), "", net.Constant({4}, {1, 1, 2, 2})},
             {TextAttribute("mode", "nearest"), TextAttribute("coordinate_transformation_mode", "asymmetric"),
              TextAttribute("nearest_mode", "floor")});
  const std::string joined = net.Op("Concat", {up, large}, {IntAttribute("axis", 1)});
  net.Output(net.Conv(joined, 64, 16, 1, 1), {1, 16, 16, 32});
  net.Output(net.Conv(joined, 64, 16, 3, 1), {1, 16, 16, 32});
  EXPECT_TRUE(NodesToPutOff(net.model).empty());
  ExpectAsOpenCv(net);
}

/// How ONNX says that a Resize takes its pixels; without `rounding` its file leaves it out.
struct Way {
  std::string place, rounding;
  int factor = 2;
};

TestNetwork Enlarging(const Way& way) {
  TestNetwork net(6, 4);
  std::vector<OnnxAttribute> attributes{TextAttribute("mode", "nearest"),
                                        TextAttribute("coordinate_transformation_mode", way.place)};
  if (!way.rounding.empty()) attributes.push_back(TextAttribute("nearest_mode", way.rounding));
  const auto factor = static_cast<float>(way.factor);
  net.Output(net.Op("Resize", {"images", "", net.Constant({4}, {1, 1, factor, factor})}, attributes),
             {1, 3, 4 * way.factor, 6 * way.factor});
  return net;
}

/// The pixel of `count` that pixel `x` is made of, by ONNX's definition.
int SlowNearest(const Way& way, int x, int count) {
  double place = (x + .5) / way.factor - .5;
  if (way.place == "asymmetric") place = x / static_cast<double>(way.factor);
  if (way.place == "align_corners") place = x * (count - 1.) / (count * way.factor - 1.);
  if (way.place == "tf_half_pixel_for_nn") place = (x + .5) / way.factor;
  double pixel = std::ceil(place - .5);
  if (way.rounding == "floor") pixel = std::floor(place);
  if (way.rounding == "ceil") pixel = std::ceil(place);
  if (way.rounding == "round_prefer_ceil") pixel = std::floor(place + .5);
  return std::clamp(static_cast<int>(pixel), 0, count - 1);
}

/// Whether an engine reads it; if so, each pixel must be the right one, else the operator is named.
bool IsReadRightly(const Way& way, const std::string& by) {
  const auto model = ReadOnnxBytes(Enlarging(way).Bytes(), "test.onnx");
  DetectionOptions options;
  options.engine = by;
  auto engine = MakeEngine(*model, InputOf(*model), options);
  if (!engine) {
    EXPECT_THAT(engine.error().message, testing::AllOf(testing::HasSubstr("test.onnx"), testing::HasSubstr("Resize")));
    return false;
  }
  const cv::Mat picture = TestPicture(6, 4);
  const auto given = RunBy(std::move(engine), picture).at(0);
  const int rows = 4 * way.factor, columns = 6 * way.factor;
  for (int i = 0; i < 3 * rows * columns; ++i) {
    const int y = SlowNearest(way, i / columns % rows, 4), x = SlowNearest(way, i % columns, 6);
    EXPECT_NEAR(given.at(static_cast<size_t>(i)), picture.at<cv::Vec3b>(y, x)[i / (rows * columns)] / 255.0, 1e-6)
        << by << ": " << way.place << " " << way.rounding << " " << way.factor;
  }
  return true;
}

TEST(NetConvolution, EnlargementsTakeThePixelsOfTheirFileOrAreRefused) {
  for (const char* place : {"half_pixel", "pytorch_half_pixel", "half_pixel_symmetric", "asymmetric", "align_corners",
                            "tf_half_pixel_for_nn"}) {
    for (const char* rounding : {"", "floor", "ceil", "round_prefer_floor", "round_prefer_ceil"}) {
      for (const int factor : {2, 3, 4}) {
        for (const char* by : {"auto", "opencv", "xnnpack"}) IsReadRightly({place, rounding, factor}, by);
      }
    }
  }
}

TEST(NetConvolution, EnlargementsToBlocksAreReadAndNoOthers) {
  for (const int factor : {2, 3, 4}) {
    for (const Way& way : {Way{"asymmetric", "floor", factor}, Way{"half_pixel", "", factor},
                           Way{"half_pixel", "round_prefer_ceil", factor}})
      EXPECT_TRUE(IsReadRightly(way, "xnnpack")) << way.place << way.rounding << factor;
  }
  EXPECT_TRUE(IsReadRightly({"asymmetric", "", 2}, "xnnpack"));
  for (const Way& way :
       {Way{"half_pixel", "floor", 2}, Way{"half_pixel", "ceil", 2}, Way{"asymmetric", "ceil", 2},
        Way{"asymmetric", "round_prefer_ceil", 2}, Way{"asymmetric", "", 3}, Way{"asymmetric", "", 4}}) {
    for (const char* by : {"xnnpack", "opencv"})
      EXPECT_FALSE(IsReadRightly(way, by)) << way.place << way.rounding << way.factor;
  }
}

/// A map of six channels, of which 1 and 4 say where the others are read.
TestNetwork SparseNetwork() {
  TestNetwork net(48, 32);
  const std::string wide = net.Conv("images", 3, 20, 3, 1);
  const std::string part =
      net.Op("Slice", {wide, net.Whole({0}), net.Whole({13}), net.Whole({1})});  // pixels with gaps between them
  net.Output(net.Conv(part, 13, 6, 1, 1), {1, 6, 32, 48});
  net.Output(net.Conv(wide, 20, 6, 1, 1), {1, 6, 32, 48});
  return net;
}

constexpr size_t kNumPixels = 32 * 48;

/// `share` of the pixels are to be read: all that is read must be equal to the bit to what is given when all is
/// computed.
void ExpectReadAlike(double share) {
  const auto model = ReadOnnxBytes(SparseNetwork().Bytes(), "test.onnx");
  const auto whole = MakeXnnpackEngine(*model, InputOf(*model), 1);
  const auto sparse = MakeXnnpackEngine(*model, InputOf(*model), 1);
  const cv::Mat picture = TestPicture(48, 32);
  const auto all = (*whole)->Run(picture);
  const std::vector<float> wanted = Numbers((*all)[0]);
  std::vector<float> scores;
  for (size_t i = 0; i < kNumPixels; ++i)
    scores.push_back(std::max(wanted[kNumPixels + i], wanted[4 * kNumPixels + i]));
  std::vector<float> sorted = scores;
  std::sort(sorted.rbegin(), sorted.rend());
  const float least = share > 0 ? sorted[static_cast<size_t>(share * (kNumPixels - 1))] : sorted[0] + 1;
  cv::Mat other;
  cv::flip(picture, other, 1);
  ASSERT_TRUE((*sparse)->Run(other));  // what an earlier picture left behind must not show
  (*sparse)->ReadOnly({0, {1, 4}, least});
  const auto read = (*sparse)->Run(picture);
  const std::vector<float> given = Numbers((*read)[0]);
  EXPECT_EQ(Numbers((*read)[1]), Numbers((*all)[1]));
  for (size_t k = 0; k < given.size(); ++k) {
    const size_t channel = k / kNumPixels;
    const bool is_read = channel == 1 || channel == 4 || scores[k % kNumPixels] >= least;
    EXPECT_TRUE(!is_read || given[k] == wanted[k]) << k << ", " << share;
  }
}

TEST(NetConvolution, OfWhatIsReadInPartThePartIsEqualToTheBit) {
  for (const double share : {0.0, 1e-9, 0.02, 0.3, 0.7, 1.0}) ExpectReadAlike(share);
}

}  // namespace
}  // namespace yorb
