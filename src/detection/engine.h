// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "core/result.h"
#include "detection/onnx_model.h"

namespace yorb {

/// Numbers that a network gave, in the order of axes that its file states, wherever they lie.
struct TensorView {
  const float* data = nullptr;
  std::vector<int64_t> dims, strides;  ///< strides in floats

  float At(int64_t i, int64_t j, int64_t k) const { return data[i * strides[0] + j * strides[1] + k * strides[2]]; }
};

/// What is read of one of the outputs: some channels everywhere, the others only where one of these reaches `least`.
struct SparseOutput {
  size_t output = 0;
  std::vector<int64_t> channels;
  float least = 0;
};

/// Runs one network on pictures of one size. Not for several threads at once.
class Engine {
 public:
  virtual ~Engine() = default;

  /// "OpenCV DNN", "XNNPACK", "ONNX Runtime": for messages.
  virtual std::string name() const = 0;

  /// The graph's outputs in its order, for a picture of the input's size: CV_8UC3 in the order that the network wants,
  /// R, G, B nearly always, or CV_8UC1. Pixels are handed to the network divided by 255, where it does not do that
  /// itself. The views are valid until the next call.
  virtual Result<std::vector<TensorView>> Run(const cv::Mat& picture) = 0;

  /// Promises that no more is read from the next run on; what is not read may hold anything then. Engines need not
  /// make use of it.
  virtual void ReadOnly(const SparseOutput&) {}
};

/// The input of a network once its size is settled.
struct EngineInput {
  std::string path;  ///< of the network's file, for complaints
  int batch = 1, channels = 3, width = 0, height = 0;
  bool are_bytes = false;         ///< pixels from 0 to 255: the network divides them itself
  bool is_channels_last = false;  ///< (1, height, width, 3)
  bool is_bgr = false;            ///< the colours are in the order B, G, R

  /// What pixels are multiplied by.
  double scale() const { return are_bytes ? 1.0 : 1.0 / 255; }
};

/// Stands in the error of an engine where OpenCV would run the network and give other numbers than its file means.
inline constexpr const char* kNorByOpenCv = ", nor by OpenCV";

/// Dense strides of a tensor whose last axis is next to itself.
std::vector<int64_t> DenseStrides(const std::vector<int64_t>& dims);

/// OpenCV's own engine, which is always there. Bad input where OpenCV cannot read the network; `because`: what XNNPACK
/// does not know of it, to be named then.
Result<std::unique_ptr<Engine>> MakeOpenCvEngine(const OnnxModel& model, const EngineInput& input,
                                                 const std::string& because = "");

/// XNNPACK's operators, on so many threads, in the order of the graph. The error is what the engine does not know, such
/// as "operator Gelu".
Result<std::unique_ptr<Engine>> MakeXnnpackEngine(const OnnxModel& model, const EngineInput& input, int threads);

/// ONNX Runtime, where the build found it; the error as above.
Result<std::unique_ptr<Engine>> MakeOnnxRuntimeEngine(const OnnxModel& model, const EngineInput& input, int threads);

}  // namespace yorb
