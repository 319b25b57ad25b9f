// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Convolutions, whichever way they are done, against OpenCV's.
#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

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
