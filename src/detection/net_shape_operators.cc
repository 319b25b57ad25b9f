// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Operators that move numbers about without changing them. Most are views that cost nothing.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <utility>

#include "detection/engine.h"
#include "detection/net_loop.h"
#include "detection/net_program.h"

namespace yorb {
namespace {

using Dims = std::vector<int64_t>;

NetValue Moved(const NetValue& value, int64_t offset) {
  NetValue moved = value;
  moved.data = std::shared_ptr<float>(value.data, value.data.get() + offset);
  return moved;
}

/// Other axes over the same numbers in the same order.
NetOutputs Reshaped(const NetNode& node, const Dims& dims) {
  NetValue value = WithLayout(node, node.inputs[0], NetLayout::kDense);
  int64_t size = 1;
  for (const int64_t dim : dims) size *= dim;
  if (size != value.size()) return BadInput(": the new shape has another number of elements");
  value.dims = dims;
  value.strides = DenseStrides(dims);
  return One(std::move(value));
}

NetOutputs Reshape(const NetNode& node) {
  const auto wanted = node.Integers("shape", 1);
  if (!wanted) return wanted.error();
  Dims dims = *wanted;
  int64_t known = 1;
  for (size_t i = 0; i < dims.size(); ++i) {
    if (dims[i] == 0 && i < node.inputs[0].rank()) dims[i] = node.inputs[0].dims[i];
    if (dims[i] >= 0) known *= dims[i];
  }
  for (int64_t& dim : dims) {
    if (dim < 0) dim = known == 0 ? 0 : node.inputs[0].size() / known;
  }
  return Reshaped(node, dims);
}

NetOutputs Flatten(const NetNode& node) {
  const NetValue& value = node.inputs[0];
  const auto axis =
      static_cast<size_t>(std::clamp<int64_t>(node.node.Integer("axis", 1), 0, static_cast<int64_t>(value.rank())));
  int64_t outer = 1;
  for (size_t i = 0; i < axis; ++i) outer *= value.dims[i];
  return Reshaped(node, {outer, outer == 0 ? 0 : value.size() / outer});
}

NetOutputs Squeeze(const NetNode& node) {
  const auto axes = node.Integers("axes", 1);
  if (!axes) return axes.error();
  NetValue value = node.inputs[0];
  std::vector<bool> is_gone(value.rank(), false);
  for (size_t i = 0; i < value.rank(); ++i) is_gone[i] = axes->empty() && value.dims[i] == 1;
  for (const int64_t axis : *axes) {
    const auto index = AxisOf(axis, value.rank());
    if (!index) return index.error();
    is_gone[*index] = value.dims[*index] == 1;
  }
  NetValue squeezed = value;
  squeezed.dims.clear(), squeezed.strides.clear();
  for (size_t i = 0; i < value.rank(); ++i) {
    if (!is_gone[i]) squeezed.dims.push_back(value.dims[i]), squeezed.strides.push_back(value.strides[i]);
  }
  return One(std::move(squeezed));
}

NetOutputs Unsqueeze(const NetNode& node) {
  auto axes = node.Integers("axes", 1);
  if (!axes) return axes.error();
  NetValue value = node.inputs[0];
  const auto rank = static_cast<int64_t>(value.rank() + axes->size());
  for (int64_t& axis : *axes) axis += axis < 0 ? rank : 0;
  std::sort(axes->begin(), axes->end());
  for (const int64_t axis : *axes) {
    if (axis < 0 || axis > static_cast<int64_t>(value.rank())) return BadInput(": an axis does not exist");
    value.dims.insert(value.dims.begin() + axis, 1);
    value.strides.insert(value.strides.begin() + axis, 0);
  }
  return One(std::move(value));
}

NetOutputs Transpose(const NetNode& node) {
  const NetValue& value = node.inputs[0];
  Dims order = node.node.Integers("perm", {});
  if (order.empty()) {
    for (size_t i = value.rank(); i > 0; --i) order.push_back(static_cast<int64_t>(i - 1));
  }
  if (order.size() != value.rank()) return BadInput(": perm does not fit its input");
  NetValue turned = value;
  for (size_t i = 0; i < order.size(); ++i) {
    const auto axis = AxisOf(order[i], value.rank());
    if (!axis) return axis.error();
    turned.dims[i] = value.dims[*axis];
    turned.strides[i] = value.strides[*axis];
  }
  return One(std::move(turned));
}

NetOutputs Slice(const NetNode& node) {
  const auto starts = node.Integers("starts", 1), ends = node.Integers("ends", 2), steps = node.Integers("steps", 4);
  auto axes = node.Integers("axes", 3);
  if (!starts || !ends || !steps || !axes) return BadInput(": its limits are not known beforehand");
  for (size_t i = axes->size(); i < starts->size(); ++i) axes->push_back(static_cast<int64_t>(i));
  NetValue value = node.inputs[0];
  for (size_t i = 0; i < starts->size() && i < ends->size(); ++i) {
    const auto axis = AxisOf((*axes)[i], value.rank());
    if (!axis) return axis.error();
    const int64_t size = value.dims[*axis], step = i < steps->size() ? (*steps)[i] : 1;
    if (step == 0) return BadInput(": its steps are 0");
    const int64_t first = step > 0 ? 0 : -1;  // backwards it ends before the first
    const auto limit = [&](int64_t at, int64_t least) {
      return std::clamp<int64_t>(at < 0 ? at + size : at, least, size + first);
    };
    const int64_t start = limit((*starts)[i], 0), end = limit((*ends)[i], first);
    const int64_t reach = step > 0 ? end - start : start - end;
    value = Moved(value, start * value.strides[*axis]);
    value.dims[*axis] = std::max<int64_t>((reach + std::abs(step) - 1) / std::abs(step), 0);
    value.strides[*axis] *= step;
  }
  if (value.size() == 0) return BadInput(std::string(": nothing is left") + kNorByOpenCv);
  return One(std::move(value));
}

NetOutputs Split(const NetNode& node) {
  const NetValue& value = node.inputs[0];
  const auto axis = AxisOf(node.node.Integer("axis", 0), value.rank());
  if (!axis) return axis.error();
  auto sizes = node.Integers("split", 1);
  if (!sizes) return sizes.error();
  const auto count = static_cast<int64_t>(node.node.outputs.size());
  if (sizes->empty()) {
    const int64_t piece = (value.dims[*axis] + count - 1) / count;
    for (int64_t i = 0; i < count; ++i) sizes->push_back(std::min(piece, value.dims[*axis] - i * piece));
  }
  std::vector<NetValue> pieces;
  int64_t start = 0;
  for (const int64_t size : *sizes) {
    if (size < 1 || start + size > value.dims[*axis]) return BadInput(": its pieces do not fit");
    pieces.push_back(Moved(value, start * value.strides[*axis]));
    pieces.back().dims[*axis] = size;
    start += size;
  }
  return pieces;
}

NetOutputs Concat(const NetNode& node) {
  const size_t rank = node.inputs[0].rank();
  const auto axis = AxisOf(node.node.Integer("axis", 0), rank);
  if (!axis) return axis.error();
  Dims dims = node.inputs[0].dims;
  dims[*axis] = 0;
  bool is_channels_last = false, is_whole = true;
  for (const NetValue& input : node.inputs) {
    for (size_t i = 0; i < rank; ++i) {
      if (input.rank() != rank || (i != *axis && input.dims[i] != dims[i]))
        return BadInput(": its inputs do not fit together");
    }
    dims[*axis] += input.dims[*axis];
    is_channels_last |= !input.is_constant && IsChannelsLast(input);
    is_whole &= input.is_whole;
  }
  NetValue whole = node.New(dims, is_channels_last ? NetLayout::kChannelsLast : NetLayout::kDense);
  whole.is_whole = is_whole;
  int64_t start = 0;
  for (const NetValue& input : node.inputs) {
    const NetLoop<2> loop(input.dims, {whole.strides, input.strides});
    node.Add([loop, to = whole.data.get() + start * whole.strides[*axis], from = input.data.get()] {
      loop.Run([&](const auto& at, int64_t count, const auto& steps) {
        if (steps[0] == 1 && steps[1] == 1) {
          std::memcpy(to + at[0], from + at[1], static_cast<size_t>(count) * sizeof(float));
        } else {
          for (int64_t i = 0; i < count; ++i) to[at[0] + i * steps[0]] = from[at[1] + i * steps[1]];
        }
      });
    });
    start += input.dims[*axis];
  }
  return One(std::move(whole));
}

/// Rows of a value by number; the numbers must be known.
NetOutputs Gather(const NetNode& node) {
  const NetValue& value = node.inputs[0];
  const auto axis = AxisOf(node.node.Integer("axis", 0), value.rank());
  if (!axis) return axis.error();
  if (!node.Has(1)) return BadInput(": an input is missing");
  if (!node.inputs[1].is_constant) return NotMine();  // chosen while the network runs
  Dims dims(value.dims.begin(), value.dims.begin() + static_cast<int64_t>(*axis));
  dims.insert(dims.end(), node.inputs[1].dims.begin(), node.inputs[1].dims.end());
  dims.insert(dims.end(), value.dims.begin() + static_cast<int64_t>(*axis) + 1, value.dims.end());
  NetValue gathered = node.New(dims);
  gathered.is_whole = value.is_whole;
  const std::vector<int64_t> indices = WholeNumbersOf(node.inputs[1]);
  Dims rest = value.dims;
  rest[*axis] = 1;
  Dims to_strides(gathered.strides.begin(), gathered.strides.begin() + static_cast<int64_t>(*axis));
  to_strides.push_back(0);
  const size_t behind = *axis + node.inputs[1].rank();
  to_strides.insert(to_strides.end(), gathered.strides.begin() + static_cast<int64_t>(behind), gathered.strides.end());
  int64_t step = 1;  // between what neighbouring indices give
  for (size_t i = behind; i < dims.size(); ++i) step *= dims[i];
  for (size_t i = 0; i < indices.size(); ++i) {
    const int64_t index = indices[i] < 0 ? indices[i] + value.dims[*axis] : indices[i];
    if (index < 0 || index >= value.dims[*axis]) return BadInput(": an index is out of range");
    const NetLoop<2> loop(rest, {to_strides, value.strides});
    node.Add([loop, to = gathered.data.get() + static_cast<int64_t>(i) * step,
              from = value.data.get() + index * value.strides[*axis]] {
      loop.Run([&](const auto& at, int64_t count, const auto& steps) {
        for (int64_t k = 0; k < count; ++k) to[at[0] + k * steps[0]] = from[at[1] + k * steps[1]];
      });
    });
  }
  return One(std::move(gathered));
}

NetOutputs Expand(const NetNode& node) {
  if (!node.Has(1) || !node.inputs[1].is_constant) return BadInput(": its shape is not known beforehand");
  Dims dims = WholeNumbersOf(node.inputs[1]);
  NetValue value = node.inputs[0];
  while (dims.size() < value.rank()) dims.insert(dims.begin(), 1);
  while (value.rank() < dims.size())
    value.dims.insert(value.dims.begin(), 1), value.strides.insert(value.strides.begin(), 0);
  for (size_t i = 0; i < dims.size(); ++i) {
    if (dims[i] < 0 || dims[i] > 1 << 20) return BadInput(": its shape makes no sense");
    if (value.dims[i] == 1 && dims[i] != 1) value.dims[i] = dims[i], value.strides[i] = 0;
  }
  return One(std::move(value));
}

NetValue Known(const NetNode& node, const Dims& dims, const std::vector<float>& numbers, bool is_whole) {
  NetValue value = node.program.New(dims, NetLayout::kDense, true);
  std::copy(numbers.begin(), numbers.end(), value.data.get());
  value.is_whole = is_whole;
  return value;
}

NetOutputs Shape(const NetNode& node) {
  const Dims& all = node.inputs[0].dims;
  const auto rank = static_cast<int64_t>(all.size());
  const auto limit = [&](const char* name, int64_t otherwise) {
    const int64_t at = node.node.Integer(name, otherwise);
    return std::clamp<int64_t>(at < 0 ? at + rank : at, 0, rank);
  };
  const int64_t start = limit("start", 0), end = std::max(limit("end", rank), start);
  const Dims dims(all.begin() + start, all.begin() + end);
  return One(Known(node, {static_cast<int64_t>(dims.size())}, std::vector<float>(dims.begin(), dims.end()), true));
}

NetOutputs Constant(const NetNode& node) {
  const OnnxAttribute* value = node.node.Find("value");
  if (value != nullptr && value->tensor) {
    const OnnxTensor& tensor = *value->tensor;
    const std::vector<float> numbers =
        tensor.is_whole ? std::vector<float>(tensor.ints.begin(), tensor.ints.end()) : tensor.floats;
    NetValue known = Known(node, tensor.dims, numbers, tensor.is_whole);
    known.onnx_type = tensor.type;
    return One(std::move(known));
  }
  if (const OnnxAttribute* number = node.node.Find("value_float")) return One(Known(node, {}, {number->number}, false));
  if (const OnnxAttribute* number = node.node.Find("value_int"))
    return One(Known(node, {}, {static_cast<float>(number->integer)}, true));
  if (const OnnxAttribute* list = node.node.Find("value_ints")) {
    return One(Known(node, {static_cast<int64_t>(list->ints.size())},
                     std::vector<float>(list->ints.begin(), list->ints.end()), true));
  }
  if (const OnnxAttribute* list = node.node.Find("value_floats"))
    return One(Known(node, {static_cast<int64_t>(list->floats.size())}, list->floats, false));
  return BadInput(": its value is of a kind that is not read");
}

NetOutputs ConstantOfShape(const NetNode& node) {
  if (!node.inputs[0].is_constant) return BadInput(": its shape is not known beforehand");
  const Dims dims = WholeNumbersOf(node.inputs[0]);
  int64_t size = 1;
  for (const int64_t dim : dims) size *= dim;
  const OnnxAttribute* value = node.node.Find("value");
  const bool is_whole = value != nullptr && value->tensor && value->tensor->is_whole;
  float number = 0;
  if (is_whole && !value->tensor->ints.empty()) number = static_cast<float>(value->tensor->ints[0]);
  if (value != nullptr && value->tensor && !value->tensor->floats.empty()) number = value->tensor->floats[0];
  if (size < 0 || size > (1 << 26)) return BadInput(": its shape makes no sense");
  return One(Known(node, dims, std::vector<float>(static_cast<size_t>(size), number), is_whole));
}

NetOutputs RangeOf(const NetNode& node) {
  if (!node.is_constant) return BadInput(": its limits are not known beforehand");
  for (const size_t limit : {0, 1, 2}) {
    if (!node.Has(limit) || node.inputs[limit].size() != 1) return BadInput(": a limit is missing");
  }
  const float start = NumbersOf(node.inputs[0])[0], end = NumbersOf(node.inputs[1])[0],
              step = NumbersOf(node.inputs[2])[0];
  std::vector<float> numbers;
  if (step == 0 || std::abs((end - start) / step) > 1 << 24) return BadInput(": its limits make no sense");
  for (float at = start; step > 0 ? at < end : at > end; at += step) numbers.push_back(at);
  const auto count = static_cast<int64_t>(numbers.size());
  return One(Known(node, {count}, numbers, node.inputs[0].is_whole));
}

NetOutputs Identity(const NetNode& node) { return One(node.inputs[0]); }

/// Between floats and halves nothing changes, since all is kept as floats; whole numbers are cut.
NetOutputs Cast(const NetNode& node) {
  const int64_t to = node.node.Integer("to", kOnnxFloat);
  const bool is_float = IsFloatType(to);
  NetValue value = node.inputs[0];
  const bool is_truth = to == kOnnxBool;
  if (is_truth || (!is_float && !value.is_whole)) {
    NetValue whole = node.New(value.dims);
    whole.is_whole = true;
    const NetLoop<2> loop(value.dims, {whole.strides, value.strides});
    node.Add([loop, is_truth, to_whole = whole.data.get(), from = value.data.get()] {
      loop.Run([&](const auto& at, int64_t count, const auto& steps) {
        for (int64_t i = 0; i < count; ++i) {
          const float number = from[at[1] + i * steps[1]];
          to_whole[at[0] + i * steps[0]] = is_truth ? (number != 0 ? 1.f : 0.f) : std::trunc(number);
        }
      });
    });
    return One(std::move(whole));
  }
  value.is_whole = !is_float;
  return One(std::move(value));
}

}  // namespace

NetOutputs AddShapeOperator(const NetNode& node) {
  static const std::map<std::string, NetOutputs (*)(const NetNode&)> operators{{"Reshape", Reshape},
                                                                               {"Flatten", Flatten},
                                                                               {"Squeeze", Squeeze},
                                                                               {"Unsqueeze", Unsqueeze},
                                                                               {"Transpose", Transpose},
                                                                               {"Slice", Slice},
                                                                               {"Split", Split},
                                                                               {"Concat", Concat},
                                                                               {"Gather", Gather},
                                                                               {"Expand", Expand},
                                                                               {"Shape", Shape},
                                                                               {"Constant", Constant},
                                                                               {"ConstantOfShape", ConstantOfShape},
                                                                               {"Range", RangeOf},
                                                                               {"Identity", Identity},
                                                                               {"Dropout", Identity},
                                                                               {"Cast", Cast}};
  const auto found = operators.find(node.node.op);
  if (found == operators.end()) return NotMine();
  if (node.node.op != "Constant" && !node.Has(0)) return BadInput(": an input is missing");
  return found->second(node);
}

}  // namespace yorb
