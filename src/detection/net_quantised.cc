// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Operators of networks that were quantised to 8 bits. Their whole numbers are kept as floats here, which hold them
// exactly, so that quantised weights are weights like all others.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "detection/engine.h"
#include "detection/net_loop.h"
#include "detection/net_program.h"

namespace yorb {
namespace {

using Dims = std::vector<int64_t>;

/// The numbers that a type has.
struct Range {
  float least, most;
};

std::optional<Range> RangeOfType(int type) {
  static const std::map<int, Range> ranges{
      {kOnnxUint8, {0, 255}}, {kOnnxInt8, {-128, 127}}, {kOnnxUint16, {0, 65535}}, {kOnnxInt16, {-32768, 32767}}};
  const auto found = ranges.find(type);
  return found == ranges.end() ? std::nullopt : std::optional(found->second);
}

/// To the nearest whole number, halves to the even one, for what has less than 23 bits: in one piece, so that
/// compilers take several numbers at once.
float Rounded(float number) {
  constexpr float kOnlyWhole = 12582912.f;  // 1.5 * 2^23: beyond it there are no fractions
  return number + kOnlyWhole - kOnlyWhole;
}

/// One scale, or zero point, for all numbers, or one for each place along an axis.
Result<Dims> StepsOf(const NetNode& node, size_t input) {
  const NetValue &value = node.inputs[0], &scale = node.inputs[input];
  Dims steps(value.rank(), 0);
  if (scale.size() == 1) return steps;
  const auto axis = AxisOf(node.node.Integer("axis", 1), value.rank());
  if (!axis) return axis.error();
  if (scale.rank() != 1 || scale.size() != value.dims[*axis] || node.node.Integer("block_size", 0) != 0)
    return BadInput(": its scales do not fit its input");
  steps[*axis] = scale.strides[0];
  return steps;
}

NetValue LikeFirst(const NetNode& node) {
  const NetValue& value = node.inputs[0];
  return node.New(value.dims, IsChannelsLast(value) ? NetLayout::kChannelsLast : NetLayout::kDense);
}

/// f(number, scale, zero point) for each number.
template <typename F>
NetOutputs ByScale(const NetNode& node, const NetValue& zero, bool is_whole, const F& f) {
  NetNode all = node;
  all.inputs.resize(2), all.inputs.push_back(zero);
  const auto scales = StepsOf(all, 1), zeros = StepsOf(all, 2);
  if (!scales) return scales.error();
  if (!zeros) return zeros.error();
  NetValue result = LikeFirst(node);
  result.is_whole = is_whole;
  const NetLoop<4> loop(node.inputs[0].dims, {result.strides, node.inputs[0].strides, *scales, *zeros});
  node.Add([loop, f, to = result.data.get(), x = node.inputs[0].data.get(), scale = node.inputs[1].data.get(),
            offset = zero.data.get()] {
    loop.Run([&](const auto& at, int64_t count, const auto& steps) {
      float* out = to + at[0];
      const float *in = x + at[1], *by = scale + at[2], *from = offset + at[3];
      if (steps[0] == 1 && steps[1] == 1 && steps[2] == 0 && steps[3] == 0) {
        const float one_scale = *by, one_zero = *from;
        for (int64_t i = 0; i < count; ++i) out[i] = f(in[i], one_scale, one_zero);
      } else {
        for (int64_t i = 0; i < count; ++i)
          out[i * steps[0]] = f(in[i * steps[1]], by[i * steps[2]], from[i * steps[3]]);
      }
    });
  });
  return One(std::move(result));
}

NetValue ZeroPointOf(const NetNode& node) {
  if (node.Has(2)) return node.inputs[2];
  NetValue zero = node.program.New({}, NetLayout::kDense, true);
  zero.onnx_type = kOnnxUint8;
  return zero;
}

NetOutputs QuantizeLinear(const NetNode& node) {
  const NetValue zero = ZeroPointOf(node);
  const auto stated = static_cast<int>(node.node.Integer("output_dtype", 0));
  const auto range = RangeOfType(node.Has(2) || stated == 0 ? zero.onnx_type : stated);
  if (!range) return BadInput(": it is to a type that is not read");
  const std::vector<float> scales = node.inputs[1].is_constant ? NumbersOf(node.inputs[1]) : std::vector<float>();
  if (std::any_of(scales.begin(), scales.end(), [](float scale) { return !(scale > 0) || std::isinf(scale); }))
    return BadInput(std::string(": it divides by a scale that is not above 0") + kNorByOpenCv);
  return ByScale(node, zero, true, [range = *range](float number, float scale, float offset) {
    return Rounded(std::min(std::max(number / scale, range.least - offset), range.most - offset)) + offset;
  });
}

NetOutputs DequantizeLinear(const NetNode& node) {
  return ByScale(node, ZeroPointOf(node), false,
                 [](float number, float scale, float offset) { return (number - offset) * scale; });
}

/// The scale and zero point come from the numbers of the picture at hand: quantize_dynamic writes it.
NetOutputs DynamicQuantizeLinear(const NetNode& node) {
  static constexpr float kMost = 255;
  const NetValue& value = node.inputs[0];
  NetValue result = LikeFirst(node), scale = node.New({}), zero = node.New({});
  result.is_whole = zero.is_whole = true;
  const NetLoop<2> loop(value.dims, {result.strides, value.strides});
  node.Add(
      [loop, to = result.data.get(), from = value.data.get(), to_scale = scale.data.get(), to_zero = zero.data.get()] {
        float least = 0, most = 0;
        loop.Run([&](const auto& at, int64_t count, const auto& steps) {
          for (int64_t i = 0; i < count; ++i) {
            const float number = from[at[1] + i * steps[1]];
            least = std::min(least, number), most = std::max(most, number);
          }
        });
        const float by = most > least ? (most - least) / kMost : 1.f;
        const float offset = Rounded(std::clamp(-least / by, 0.f, kMost));
        *to_scale = by, *to_zero = offset;
        loop.Run([&](const auto& at, int64_t count, const auto& steps) {
          for (int64_t i = 0; i < count; ++i)
            to[at[0] + i * steps[0]] = std::clamp(Rounded(from[at[1] + i * steps[1]] / by) + offset, 0.f, kMost);
        });
      });
  return std::vector<NetValue>{std::move(result), std::move(scale), std::move(zero)};
}

/// An input less its zero point.
NetOutputs LessZeroPoint(const NetNode& node, size_t input, size_t zero) {
  if (!node.Has(zero)) return One(node.inputs[input]);
  OnnxNode difference;
  difference.op = "Sub";
  NetValue offset = node.inputs[zero];
  if (offset.rank() == 1 && offset.size() > 1) {  // one for each output of the weights
    if (input == 0 || offset.size() != node.inputs[input].dims[0]) return BadInput(": its zero points are not read");
    offset.dims.resize(node.inputs[input].rank(), 1);
    offset.strides.resize(node.inputs[input].rank(), 1);
  }
  const bool is_constant = node.inputs[input].is_constant && offset.is_constant;
  return AddArithmetic({difference, {node.inputs[input], offset}, node.program, node.opset, is_constant});
}

/// ConvInteger and MatMulInteger: the same on floats once the zero points are taken off.
NetOutputs OfWholeNumbers(const NetNode& node, const char* op) {
  if (!node.Has(1)) return BadInput(": an input is missing");
  const NetOutputs first = LessZeroPoint(node, 0, 2), second = LessZeroPoint(node, 1, 3);
  if (!first) return first;
  if (!second) return second;
  OnnxNode plain = node.node;
  plain.op = op;
  const NetNode ready{plain, {(*first)[0], (*second)[0]}, node.program, node.opset, node.is_constant};
  NetOutputs result = plain.op == "Conv" ? AddPictureOperator(ready) : AddArithmetic(ready);
  if (result) (*result)[0].is_whole = true;
  return result;
}

}  // namespace

NetOutputs AddQuantised(const NetNode& node) {
  const std::string& op = node.node.op;
  if (!node.Has(0)) return NotMine();
  if (op == "DynamicQuantizeLinear") return DynamicQuantizeLinear(node);
  if (op == "ConvInteger") return OfWholeNumbers(node, "Conv");
  if (op == "MatMulInteger") return OfWholeNumbers(node, "MatMul");
  if (op != "QuantizeLinear" && op != "DequantizeLinear") return NotMine();
  if (!node.Has(1)) return BadInput(": an input is missing");
  return op == "QuantizeLinear" ? QuantizeLinear(node) : DequantizeLinear(node);
}

}  // namespace yorb
