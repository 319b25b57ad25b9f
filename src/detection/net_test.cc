// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// The compiled network against OpenCV's engine, and against what operators are defined as.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>

#include "detection/engine.h"
#include "detection/network.h"
#include "detection/sigmoid.h"
#include "detection/test_engines.h"
#include "detection/test_network.h"

namespace yorb {
namespace {

TEST(Net, ABlockOfMobileNetIsAsOpenCvs) {
  TestNetwork net(64, 64);
  const OnnxAttribute sixth = FloatAttribute("alpha", 1.f / 6), half = FloatAttribute("beta", 0.5f);
  const auto swish = [&](const std::string& x) {
    return net.Op("Mul", {x, net.Op("HardSigmoid", {x}, {sixth, half})});
  };
  const std::string stem = swish(net.Conv("images", 3, 16, 3, 2));
  const std::string wide = swish(net.Conv(stem, 16, 24, 1, 1)), deep = swish(net.Conv(wide, 24, 24, 5, 1, 24));
  const std::string squeezed = net.Op("Relu", {net.Conv(net.Op("GlobalAveragePool", {deep}), 24, 8, 1, 1)});
  const std::string gate = net.Op("HardSigmoid", {net.Conv(squeezed, 8, 24, 1, 1)}, {sixth, half});
  const std::string narrow = net.Conv(net.Op("Mul", {gate, deep}), 24, 16, 1, 1);
  net.Output(net.Op("Add", {stem, narrow}), {1, 16, 32, 32});
  ExpectAsOpenCv(net);
}

TEST(Net, AHeadOfYoloIsAsOpenCvs) {
  TestNetwork net(64, 64);
  const auto silu = [&](const std::string& x) { return net.Op("Mul", {x, net.Op("Sigmoid", {x})}); };
  const std::string fine = silu(net.Conv("images", 3, 8, 3, 2)), coarse = silu(net.Conv(fine, 8, 12, 3, 2));
  std::string pooled = coarse;
  std::vector<std::string> all{coarse};
  for (int i = 0; i < 2; ++i) {
    pooled = net.Op(
        "MaxPool", {pooled},
        {IntsAttribute("kernel_shape", {5, 5}), IntsAttribute("pads", {2, 2, 2, 2}), IntsAttribute("strides", {1, 1})});
    all.push_back(pooled);
  }
  const std::string joined = net.Op("Concat", all, {IntAttribute("axis", 1)});
  const std::string enlarged = net.Op("Resize", {joined, "", net.Constant({4}, {1, 1, 2, 2})},
                                      {TextAttribute("mode", "nearest"), TextAttribute("nearest_mode", "floor"),
                                       TextAttribute("coordinate_transformation_mode", "asymmetric")});
  const std::string both = net.Op("Concat", {enlarged, fine}, {IntAttribute("axis", 1)});
  net.Output(net.Conv(silu(net.Conv(both, 44, 16, 1, 1)), 16, 21, 1, 1), {1, 21, 32, 32});
  net.Output(net.Op("Sigmoid", {net.Conv(coarse, 12, 21, 1, 1)}), {1, 21, 16, 16});
  ExpectAsOpenCv(net);
}

TEST(Net, LimitsBehindAConvolutionAreKept) {
  const auto with_clip = [](bool has_attributes) {
    TestNetwork net(32, 32, has_attributes ? 9 : 13);
    const std::string x = net.Conv(net.Conv("images", 3, 4, 1, 1), 4, 4, 3, 1);
    const std::string low = net.Constant({}, {-0.1f}), high = net.Constant({}, {0.2f});
    const std::string clipped = has_attributes
                                    ? net.Op("Clip", {x}, {FloatAttribute("min", -0.1f), FloatAttribute("max", 0.2f)})
                                    : net.Op("Clip", {x, low, high});
    net.Output(clipped, {1, 4, 32, 32});
    net.Output(net.Op("Relu", {net.Conv(clipped, 4, 4, 3, 1)}), {1, 4, 32, 32});
    return net;
  };
  ExpectAsOpenCv(with_clip(true));
  EXPECT_EQ(Compiled(with_clip(false)), Compiled(with_clip(true)));
}

TEST(Net, AGateThatOthersReadStaysAsItIs) {
  TestNetwork net(32, 32);
  const std::string x = net.Conv("images", 3, 4, 1, 1), gate = net.Op("Sigmoid", {x});
  net.Output(net.Op("Mul", {x, gate}), {1, 4, 32, 32});
  net.Output(gate, {1, 4, 32, 32});
  net.Output(net.Op("Add", {x, gate}), {1, 4, 32, 32});
  ExpectAsOpenCv(net);
}

/// YOLOv8's head as its export writes it: distances to the four sides as mean of 4 bins, decoded within the graph.
TEST(Net, BoxesDecodedWithinTheGraphAreAsDefined) {
  TestNetwork net(32, 32);
  const int64_t cells = 16, bins = 4, classes = 3;
  const std::string map = net.Conv("images", 3, 4 * bins + classes, 8, 8);
  const std::string rows =
      net.Reshaped(net.Op("Slice", {map, net.Whole({0, 0}), net.Whole({4, 4}), net.Whole({2, 3})}), {1, -1, cells});
  const auto parts = net.Ops("Split", {rows, net.Whole({4 * bins, classes})}, {IntAttribute("axis", 1)}, 2);
  const std::string split =
      net.Op("Transpose", {net.Reshaped(parts[0], {1, 4, bins, cells})}, {IntsAttribute("perm", {0, 2, 1, 3})});
  const std::string soft = net.Op("Softmax", {split}, {IntAttribute("axis", 1)});
  const std::string mean = net.Reshaped(
      net.Op("Conv", {soft, net.Constant({1, bins, 1, 1}, {0, 1, 2, 3})}, {IntsAttribute("kernel_shape", {1, 1})}),
      {1, 4, cells});
  std::vector<float> centres;
  for (int i = 0; i < 2 * cells; ++i)
    centres.push_back(i < cells ? static_cast<float>(i % 4) + .5f : static_cast<float>((i - cells) / 4) + .5f);
  const std::string anchors = net.Constant({1, 2, cells}, centres);
  const auto sides = net.Ops("Split", {mean}, {IntAttribute("axis", 1)}, 2);
  const std::string low = net.Op("Sub", {anchors, sides[0]}), high = net.Op("Add", {anchors, sides[1]});
  const std::string middle = net.Op("Div", {net.Op("Add", {low, high}), net.Constant({}, {2})}),
                    size = net.Op("Sub", {high, low});
  const std::string box = net.Op("Mul", {net.Op("Concat", {middle, size}, {IntAttribute("axis", 1)}),
                                         net.Constant({1, cells}, std::vector<float>(16, 8.f))});
  net.Output(net.Op("Concat", {box, net.Op("Sigmoid", {parts[1]})}, {IntAttribute("axis", 1)}), {1, 7, cells});
  const std::vector<float> given = Compiled(net);

  TestNetwork raw(32, 32);
  raw.Output(raw.Conv("images", 3, 4 * bins + classes, 8, 8), {1, 19, 5, 5});
  const std::vector<float> map_numbers = Compiled(raw);  // the same weights: drawn from the same seed
  ASSERT_EQ(given.size(), 7u * 16);
  for (size_t cell = 0; cell < 16; ++cell) {
    const size_t place = cell / 4 * 5 + cell % 4;  // the map is 5x5 with its padding
    const auto value = [&](size_t channel) { return static_cast<double>(map_numbers[channel * 25 + place]); };
    double side[4];
    for (size_t s = 0; s < 4; ++s) {
      double sum = 0, weighted = 0;
      for (size_t bin = 0; bin < 4; ++bin)
        sum += std::exp(value(s * 4 + bin)), weighted += static_cast<double>(bin) * std::exp(value(s * 4 + bin));
      side[s] = weighted / sum;
    }
    const double x = static_cast<double>(cell % 4) + .5, y = static_cast<double>(cell / 4) + .5;
    EXPECT_NEAR(given[0 * 16 + cell], (x + (side[2] - side[0]) / 2) * 8, 1e-3);
    EXPECT_NEAR(given[1 * 16 + cell], (y + (side[3] - side[1]) / 2) * 8, 1e-3);
    EXPECT_NEAR(given[2 * 16 + cell], (side[0] + side[2]) * 8, 1e-3);
    EXPECT_NEAR(given[3 * 16 + cell], (side[1] + side[3]) * 8, 1e-3);
    for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(given[(4 + k) * 16 + cell], 1 / (1 + std::exp(-value(16 + k))), 1e-5);
  }
}

TEST(Net, ShapesThatTheGraphComputesAreKnownBeforehand) {
  TestNetwork net(32, 16);
  const std::string shape = net.Op("Shape", {"images"});
  const std::string height = net.Op("Gather", {shape, net.Whole({2})}, {IntAttribute("axis", 0)});
  const std::string half = net.Op("Div", {height, net.Whole({2})});
  const std::string target = net.Op("Concat", {net.Whole({1, 3}), half, net.Whole({-1})}, {IntAttribute("axis", 0)});
  net.Output(net.Op("Reshape", {"images", target}), {1, 3, 8, 64});
  const std::vector<float> given = Compiled(net);
  const cv::Mat picture = TestPicture(32, 16);
  ASSERT_EQ(given.size(), 3u * 16 * 32);
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < 16 * 32; ++i)
      ASSERT_FLOAT_EQ(given[static_cast<size_t>(c * 16 * 32 + i)],
                      static_cast<float>(picture.at<cv::Vec3b>(i / 32, i % 32)[c]) / 255);
  }
}

TEST(Net, ConstantsThatStepsReadStayWhileOthersAreComputed) {
  const auto network = [](bool computes) {
    TestNetwork net(8, 8);
    const std::string first = net.Random({1, 3, 8, 8}), sum = net.Op("Add", {"images", first});
    const std::string two = net.Constant({1, 3, 8, 8}, std::vector<float>(192, 2.f));
    const std::string minus_two = net.Constant({1, 3, 8, 8}, std::vector<float>(192, -2.f));
    net.Output(net.Op("Add", {sum, computes ? net.Op("Neg", {two}) : minus_two}), {1, 3, 8, 8});
    return net;
  };
  EXPECT_EQ(Compiled(network(true)), Compiled(network(false)));
}

TEST(Net, ConvolutionsMayShareTheirWeights) {
  TestNetwork net(16, 16);
  const std::string weights = net.Random({3, 3, 3, 3}), bias = net.Random({3});
  const auto convolved = [&](const std::string& x) {
    return net.Op("Conv", {x, weights, bias},
                  {IntsAttribute("kernel_shape", {3, 3}), IntsAttribute("pads", {1, 1, 1, 1})});
  };
  net.Output(convolved(convolved("images")), {1, 3, 16, 16});
  ExpectAsOpenCv(net);
}

TEST(Net, MatricesAndMeansAreAsDefined) {
  TestNetwork net(4, 2);
  const std::string flat = net.Reshaped("images", {3, 8});
  const std::string squared = net.Op("MatMul", {flat, net.Op("Transpose", {flat})});
  const std::string means = net.Op("ReduceMean", {flat}, {IntsAttribute("axes", {1}), IntAttribute("keepdims", 1)});
  net.Output(
      net.Op("Concat",
             {squared, means, net.Op("ReduceMax", {flat}, {IntsAttribute("axes", {-1}), IntAttribute("keepdims", 1)})},
             {IntAttribute("axis", 1)}),
      {3, 5});
  const std::vector<float> given = Compiled(net);
  const cv::Mat picture = TestPicture(4, 2);
  const auto value = [&](int c, int i) { return picture.at<cv::Vec3b>(i / 4, i % 4)[c] / 255.0; };
  for (int a = 0; a < 3; ++a) {
    double mean = 0, most = 0;
    for (int i = 0; i < 8; ++i) mean += value(a, i) / 8, most = std::max(most, value(a, i));
    EXPECT_NEAR(given[static_cast<size_t>(a * 5 + 3)], mean, 1e-6);
    EXPECT_NEAR(given[static_cast<size_t>(a * 5 + 4)], most, 1e-6);
    for (int b = 0; b < 3; ++b) {
      double sum = 0;
      for (int i = 0; i < 8; ++i) sum += value(a, i) * value(b, i);
      EXPECT_NEAR(given[static_cast<size_t>(a * 5 + b)], sum, 1e-5);
    }
  }
}

TEST(Net, TheLargestAndTheSmallestAreOfAllInputs) {
  TestNetwork net(4, 2);
  const auto number = [&](float value) { return net.Constant({1}, {value}); };
  net.Output(net.Op("Max", {number(.4f), number(.45f), "images"}), {1, 3, 2, 4});
  net.Output(net.Op("Min", {"images", number(.6f), number(.55f), number(.7f)}), {1, 3, 2, 4});
  net.Output(net.Op("Max", {net.Op("Neg", {"images"})}), {1, 3, 2, 4});
  const auto model = ReadOnnxBytes(net.Bytes(), "test.onnx");
  const cv::Mat picture = TestPicture(4, 2);
  const auto given = RunBy(MakeXnnpackEngine(*model, InputOf(*model), 1), picture, 2);
  ASSERT_EQ(given.size(), 3u);
  for (int i = 0; i < 24; ++i) {
    const float value = static_cast<float>(picture.at<cv::Vec3b>(i % 8 / 4, i % 4)[i / 8]) / 255;
    const auto place = static_cast<size_t>(i);
    EXPECT_FLOAT_EQ(given[0][place], std::max(value, .45f));
    EXPECT_FLOAT_EQ(given[1][place], std::min(value, .55f));
    EXPECT_FLOAT_EQ(given[2][place], -value);
  }
}

/// A softmax of (1, 3, 2, 4) along an axis; in older files along all from it on.
std::vector<double> SlowSoftmax(const cv::Mat& picture, size_t axis, bool is_old) {
  const size_t dims[] = {1, 3, 2, 4};
  size_t behind = 1;
  for (size_t i = axis + 1; i < 4; ++i) behind *= dims[i];
  const size_t block = behind * dims[axis];
  const auto group = [&](size_t i) { return i / block * behind + (is_old ? 0 : i % behind); };
  std::vector<double> results, sums(24, 0);
  for (size_t i = 0; i < 24; ++i) {
    const auto pixel = picture.at<cv::Vec3b>(static_cast<int>(i % 8 / 4), static_cast<int>(i % 4));
    results.push_back(std::exp(pixel[static_cast<int>(i / 8)] / 255.0));
    sums[group(i)] += results.back();
  }
  for (size_t i = 0; i < 24; ++i) results[i] /= sums[group(i)];
  return results;
}

TEST(Net, SoftmaxOfOlderFilesIsOverAllAxesFromItsOwnOn) {
  const auto network = [](int64_t opset, std::vector<OnnxAttribute> attributes) {
    TestNetwork net(4, 2, opset);
    net.Output(net.Op("Softmax", {"images"}, std::move(attributes)), {1, 3, 2, 4});
    return net;
  };
  for (const int64_t opset : {9, 11, 12, 13}) {
    for (const int64_t axis : {0, 1, 2, 3, -1, -2}) {
      const std::vector<float> given = Compiled(network(opset, {IntAttribute("axis", axis)}));
      const auto wanted = SlowSoftmax(TestPicture(4, 2), static_cast<size_t>(axis < 0 ? axis + 4 : axis), opset < 13);
      ASSERT_EQ(given.size(), wanted.size());
      for (size_t i = 0; i < given.size(); ++i) ASSERT_NEAR(given[i], wanted[i], 1e-6) << opset << " " << axis;
    }
  }
  EXPECT_EQ(Compiled(network(12, {})), Compiled(network(12, {IntAttribute("axis", 1)})));
  EXPECT_EQ(Compiled(network(13, {})), Compiled(network(13, {IntAttribute("axis", 3)})));
}

TEST(Net, WindowsBeyondThePictureAndMissingLimitsAreRefused) {
  const auto complaint = [](const TestNetwork& net) {
    const auto engine = MakeXnnpackEngine(*ReadOnnxBytes(net.Bytes(), "a.onnx"), InputOf(net.model), 1);
    return engine ? "" : engine.error().message;
  };
  for (const int64_t side : {5, 9, 1 << 20}) {  // 5: larger than the picture by less than a step
    TestNetwork net(4, 4);
    net.Output(net.Op("AveragePool", {"images"},
                      {IntsAttribute("kernel_shape", {side, side}), IntsAttribute("strides", {8, 8})}),
               {1, 3, 1, 1});
    EXPECT_THAT(complaint(net), testing::HasSubstr("does not fit")) << side;
  }
  TestNetwork range(4, 4);
  range.Output(range.Op("Range", {range.Whole({0}), range.Whole({4})}), {4});
  EXPECT_THAT(complaint(range), testing::HasSubstr("a limit is missing"));
  TestNetwork slice(4, 4);
  slice.Output(slice.Op("Slice", {"images", slice.Whole({4}), slice.Whole({9}), slice.Whole({3})}), {1, 3, 4, 0});
  EXPECT_THAT(complaint(slice), testing::HasSubstr("nothing is left, nor by OpenCV"));
}

TEST(Net, AnOperatorThatIsNotKnownIsNamed) {
  TestNetwork net(32, 32);
  net.Output(net.Op("Gelu", {"images"}), {1, 3, 32, 32});
  const auto engine = MakeXnnpackEngine(*ReadOnnxBytes(net.Bytes(), "a.onnx"), InputOf(net.model), 1);
  ASSERT_FALSE(engine);
  EXPECT_THAT(engine.error().message, testing::HasSubstr("Gelu"));
}

TEST(Net, DamagedNetworksAreRefusedOrRunWithinTheirBuffers) {
  TestNetwork net(64, 64);
  const std::string x = net.Conv("images", 3, 8, 3, 2);
  const std::string pooled =
      net.Op("MaxPool", {x}, {IntsAttribute("kernel_shape", {5, 5}), IntsAttribute("pads", {2, 2, 2, 2})});
  const auto parts = net.Ops("Split", {pooled, net.Whole({3, 5})}, {IntAttribute("axis", 1)}, 2);
  const std::string cut = net.Op("Slice", {parts[1], net.Whole({1}), net.Whole({9}), net.Whole({2}), net.Whole({2})});
  const std::string turned = net.Op("Transpose", {net.Reshaped(cut, {5, -1})}, {IntsAttribute("perm", {1, 0})});
  net.Output(net.Op("Softmax", {net.Op("MatMul", {turned, net.Random({5, 3})})}, {IntAttribute("axis", -1)}), {128, 3});
  const std::string bytes = net.Bytes();
  const cv::Mat picture = TestPicture(64, 64);
  Random random(5);
  int num_run = 0;
  for (int round = 0; round < 1500; ++round) {
    std::string damaged = bytes;
    for (int i = 0; i < 2; ++i)
      damaged[random.Below(static_cast<uint32_t>(bytes.size()))] = static_cast<char>(random.Below(256));
    const auto model = ReadOnnxBytes(damaged, "damaged.onnx");
    if (!model || model->inputs[0].dims != net.model.inputs[0].dims) continue;
    const auto engine = MakeXnnpackEngine(*model, InputOf(*model), 1);
    if (engine && (*engine)->Run(picture)) ++num_run;
  }
  EXPECT_GT(num_run, 100);
}

TEST(Net, SeveralThreadsGiveTheSame) {
  TestNetwork net(64, 64);
  const std::string x = net.Conv("images", 3, 32, 3, 2);
  net.Output(net.Conv(net.Op("Mul", {x, net.Op("Sigmoid", {x})}), 32, 64, 3, 1), {1, 64, 32, 32});
  const auto model = ReadOnnxBytes(net.Bytes(), "a.onnx");
  const cv::Mat picture = TestPicture(64, 64);
  EXPECT_EQ(RunBy(MakeXnnpackEngine(*model, InputOf(*model), 1), picture),
            RunBy(MakeXnnpackEngine(*model, InputOf(*model), 3), picture));
}

TEST(Sigmoid, VectorKernelsAreAsTheFormula) {
  std::vector<float> x, y(4099);
  for (size_t i = 0; i < y.size(); ++i) x.push_back(static_cast<float>(i) * 0.05f - 102.f);
  Sigmoids(x.data(), y.data(), x.size());
  for (size_t i = 0; i < x.size(); ++i) {
    const double wanted = 1 / (1 + std::exp(-static_cast<double>(x[i])));
    EXPECT_NEAR(y[i], wanted, 4e-7 * wanted + 1e-37) << x[i];
  }
  Silus(x.data(), y.data(), x.size());
  for (size_t i = 0; i < x.size(); ++i)
    EXPECT_NEAR(y[i], x[i] / (1 + std::exp(-static_cast<double>(x[i]))), 4e-7 * std::abs(x[i])) << x[i];
  HardSwishes(x.data(), x.data(), x.size());
  for (size_t i = 0; i < x.size(); ++i) {
    const float before = static_cast<float>(i) * 0.05f - 102.f;
    EXPECT_NEAR(x[i], before * std::min(std::max(before / 6 + 0.5f, 0.f), 1.f), 1e-5f * std::abs(before)) << before;
  }
}

/// The folder of real data; empty where there is none.
std::string DataFolder() {
  const char* named = std::getenv("YORB_DATA");
  const std::string folder = named != nullptr ? named : YORB_SOURCE_DIR "/../shared/data";
  std::error_code ignored;
  return std::filesystem::is_directory(folder, ignored) ? folder : "";
}

TEST(Net, ARealNetworkIsAsOpenCvs) {
  const std::string path = DataFolder() + "/weights/yolov5n_416.onnx";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "skipped: no data";
  const auto network = OpenNetwork(path, {});
  ASSERT_TRUE(network) << network.error().message;
  const cv::Mat picture = TestPicture(416, 416);
  const auto wanted = RunBy(MakeOpenCvEngine(network->model, network->input), picture);
  const auto given = RunBy(MakeXnnpackEngine(network->model, network->input, 1), picture);
  for (size_t i = 0; i < wanted.size(); ++i) {
    for (size_t k = 0; k < wanted[i].size(); ++k) ASSERT_NEAR(given[i][k], wanted[i][k], 1e-4);
  }
}

}  // namespace
}  // namespace yorb
