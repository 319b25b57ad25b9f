// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// For tests only: what engines give for a network and a picture of noise.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "detection/engine.h"
#include "detection/test_network.h"

namespace yorb {

inline cv::Mat TestPicture(int width, int height) {
  cv::Mat picture(height, width, CV_8UC3);
  cv::RNG(17).fill(picture, cv::RNG::UNIFORM, 0, 256);
  return picture;
}

inline EngineInput InputOf(const OnnxModel& model) {
  const auto& dims = model.inputs[0].dims;
  return {"test.onnx", 1, static_cast<int>(dims[1]), static_cast<int>(dims[3]), static_cast<int>(dims[2])};
}

/// The numbers of a view in the order of its axes.
inline std::vector<float> Numbers(const TensorView& view) {
  std::vector<float> numbers;
  const std::function<void(size_t, int64_t)> walk = [&](size_t axis, int64_t at) {
    if (axis == view.dims.size()) return numbers.push_back(view.data[at]);
    for (int64_t i = 0; i < view.dims[axis]; ++i) walk(axis + 1, at + i * view.strides[axis]);
  };
  walk(0, 0);
  return numbers;
}

inline std::vector<std::vector<float>> RunBy(Result<std::unique_ptr<Engine>> engine, const cv::Mat& picture,
                                             int times = 1) {
  EXPECT_TRUE(engine) << engine.error().message;
  std::vector<std::vector<float>> all;
  if (!engine) return all;
  for (int i = 1; i < times; ++i) EXPECT_TRUE((*engine)->Run(picture));
  const auto outputs = (*engine)->Run(picture);
  EXPECT_TRUE(outputs) << outputs.error().message;
  for (const TensorView& view : *outputs) all.push_back(Numbers(view));
  return all;
}

/// Both engines give the same, and XNNPACK again when it runs again on its shared buffers.
inline void ExpectAsOpenCv(const TestNetwork& net, double tolerance = 1e-5) {
  const auto model = ReadOnnxBytes(net.Bytes(), "test.onnx");
  ASSERT_TRUE(model) << model.error().message;
  const EngineInput input = InputOf(*model);
  const cv::Mat picture = TestPicture(input.width, input.height);
  const auto wanted = RunBy(MakeOpenCvEngine(*model, input), picture);
  for (const int times : {1, 3}) {
    const auto given = RunBy(MakeXnnpackEngine(*model, input, 1), picture, times);
    ASSERT_EQ(given.size(), wanted.size());
    for (size_t i = 0; i < given.size(); ++i) {
      ASSERT_EQ(given[i].size(), wanted[i].size());
      double scale = 1;
      for (const float number : wanted[i]) scale = std::max<double>(scale, std::abs(number));
      for (size_t k = 0; k < given[i].size(); ++k)
        ASSERT_NEAR(given[i][k], wanted[i][k], tolerance * scale) << i << " " << k;
    }
  }
}

/// What the compiled network gives for one output.
inline std::vector<float> Compiled(const TestNetwork& net) {
  const auto model = ReadOnnxBytes(net.Bytes(), "test.onnx");
  EXPECT_TRUE(model) << model.error().message;
  return RunBy(MakeXnnpackEngine(*model, InputOf(*model), 1),
               TestPicture(InputOf(*model).width, InputOf(*model).height), 2)[0];
}

}  // namespace yorb
