// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/result.h"
#include "detection/onnx_model.h"

namespace yorb {

/// One value of a compiled network: where its numbers lie, in the axes that the ONNX file means. Pictures lie with
/// their channels next to each other (N, H, W, C in memory, N, C, H, W in `dims`), so that views, transposed or cut,
/// cost nothing.
struct NetValue {
  std::vector<int64_t> dims, strides;  ///< strides in floats
  std::shared_ptr<float> data;         ///< keeps its buffer from being used again while the network is compiled
  bool is_constant = false;            ///< known when the network is compiled
  bool is_whole = false;               ///< whole numbers: shapes and indices, kept as floats
  int onnx_type = 0;  ///< of a constant, as the file has it: how far zero points of quantised numbers reach

  int64_t size() const;
  size_t rank() const { return dims.size(); }
  int64_t dim(size_t axis) const { return dims[axis]; }
};

/// Whether the numbers lie in the order of the axes without gaps.
bool IsDense(const NetValue& value);

/// Whether they fill their piece of memory without gaps, in whatever order of axes.
bool IsFilled(const NetValue& value);

/// Whether it is a picture with its channels next to each other and its rows without gaps between them; pixels may be
/// farther apart than the channels are many.
bool IsChannelsLast(const NetValue& value);

/// Numbers in the order of the axes, for values that are known while the network is compiled.
std::vector<float> NumbersOf(const NetValue& value);
std::vector<int64_t> WholeNumbersOf(const NetValue& value);

/// How the numbers of a new value are to lie.
enum class NetLayout { kDense, kChannelsLast };

/// The strides of a layout; channels last is for four axes.
std::vector<int64_t> StridesOf(const std::vector<int64_t>& dims, NetLayout layout);

/// A constant of zeros, to be filled; its buffer is freed with the last value in it.
NetValue NewConstant(const std::vector<int64_t>& dims, NetLayout layout = NetLayout::kDense);

/// A dense value with the numbers of a tensor in it.
NetValue Filled(NetValue value, const OnnxTensor& tensor);

/// Buffers that values share when their times do not meet. A buffer is free again when the last value in it is gone.
class BufferPool {
 public:
  std::shared_ptr<float> Take(int64_t size);

 private:
  struct Buffer {
    std::shared_ptr<float> data;
    int64_t size = 0;
    bool is_free = false;
  };
  std::vector<std::shared_ptr<Buffer>> buffers_;
};

}  // namespace yorb
