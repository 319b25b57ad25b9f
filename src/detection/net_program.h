// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"
#include "detection/net_value.h"
#include "detection/onnx_model.h"

struct pthreadpool;

namespace yorb {

/// A network in the making: steps that are run one after the other, on buffers whose places are settled.
class NetProgram {
 public:
  /// A value for the result of a step. Constants stay, for the steps that read them.
  NetValue New(const std::vector<int64_t>& dims, NetLayout layout, bool is_constant);

  /// Adds a step, or takes it at once where all that it reads is constant.
  void Add(std::function<void()> step, bool is_constant);

  /// Threads for those steps that can use them; null: the caller's alone.
  void SetThreads(pthreadpool* threads) { threads_ = threads; }
  pthreadpool* threads() const { return threads_; }

  void Run() const {
    for (const auto& step : steps_) step();
  }

 private:
  BufferPool pool_;
  std::vector<NetValue> constants_;
  std::vector<std::function<void()>> steps_;
  pthreadpool* threads_ = nullptr;
};

/// One operator with its inputs at hand.
struct NetNode {
  const OnnxNode& node;
  std::vector<NetValue> inputs;  ///< `data` empty: left out
  NetProgram& program;
  int64_t opset = 0;
  bool is_constant = false;  ///< all inputs are
  float least = -HUGE_VALF,
        most = HUGE_VALF;  ///< limits that a convolution puts to what it gives (Relu, Clip behind it)

  bool Has(size_t input) const { return input < inputs.size() && inputs[input].data != nullptr; }
  NetValue New(const std::vector<int64_t>& dims, NetLayout layout = NetLayout::kDense) const {
    return program.New(dims, layout, is_constant);
  }
  void Add(std::function<void()> step) const { program.Add(std::move(step), is_constant); }

  /// Whole numbers of an attribute, or of an input that newer files have in its place.
  Result<std::vector<int64_t>> Integers(const char* attribute, size_t input) const;
};

/// What an operator gives; an error says why it is not read, in words that follow "operator X".
using NetOutputs = Result<std::vector<NetValue>>;

/// What an operator with one output gives.
inline NetOutputs One(NetValue value) { return std::vector<NetValue>{std::move(value)}; }

/// Adds the steps of one operator. The five families know which operators are theirs; the answer is an error without
/// a message for those that are not.
NetOutputs AddShapeOperator(const NetNode& node);    ///< Reshape, Transpose, Slice, Concat ...
NetOutputs AddSelection(const NetNode& node);        ///< TopK, GatherElements, Tile, Gather by what is computed ...
NetOutputs AddArithmetic(const NetNode& node);       ///< Add, Mul, Exp, Softmax, MatMul ...
NetOutputs AddQuantised(const NetNode& node);        ///< QuantizeLinear, DequantizeLinear, ConvInteger ...
NetOutputs AddPictureOperator(const NetNode& node);  ///< Conv, MaxPool, Resize ...: by XNNPACK where it has them

/// Gets the kernels ready, as often as one likes; false on processors that they are not made for.
bool PrepareKernels();

/// By how much Resize and Upsample enlarge pictures, along y and x; an error where pixels do not
/// become blocks of whole sizes.
Result<std::pair<int64_t, int64_t>> EnlargementOf(const NetNode& node);

/// An axis counted from the front; an error beyond the rank.
Result<size_t> AxisOf(int64_t axis, size_t rank);

/// The same numbers with others' layout: a copy, unless they lie so already.
NetValue WithLayout(const NetNode& node, const NetValue& value, NetLayout layout);

/// x * sigmoid(x), and x * clamp(x / 6 + 1/2, 0, 1); in the place of x where nobody else reads it.
NetValue AddSilu(const NetNode& node, const NetValue& value, bool is_in_place);
NetValue AddHardSwish(const NetNode& node, const NetValue& value, bool is_in_place);

/// For operators that another family knows.
inline Error NotMine() { return BadInput(""); }

}  // namespace yorb
