// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Operators that compute number by number, and the few that sum up along an axis.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "detection/engine.h"
#include "detection/net_loop.h"
#include "detection/net_program.h"
#include "detection/sigmoid.h"

namespace yorb {
namespace {

using Dims = std::vector<int64_t>;

/// The strides of one operand along the axes of the result; 0 where it is repeated.
Dims BroadcastStrides(const NetValue& value, const Dims& dims) {
  Dims strides(dims.size(), 0);
  const size_t shift = dims.size() - value.rank();
  for (size_t i = 0; i < value.rank(); ++i) strides[i + shift] = value.dims[i] == 1 ? 0 : value.strides[i];
  return strides;
}

Result<Dims> BroadcastDims(const NetValue& a, const NetValue& b) {
  Dims dims(std::max(a.rank(), b.rank()), 1);
  for (const NetValue* value : {&a, &b}) {
    const size_t shift = dims.size() - value->rank();
    for (size_t i = 0; i < value->rank(); ++i) {
      int64_t& dim = dims[i + shift];
      if (dim != 1 && value->dims[i] != 1 && dim != value->dims[i]) return BadInput(": its inputs do not fit together");
      if (value->dims[i] != 1) dim = value->dims[i];
    }
  }
  return dims;
}

/// A new value that lies as `like` does, if that fills its memory.
NetValue NewLike(const NetNode& node, const Dims& dims, const NetValue& like) {
  if (like.dims == dims && IsFilled(like)) {
    NetValue value = node.New(dims);
    value.strides = like.strides;
    return value;
  }
  return node.New(dims, IsChannelsLast(like) ? NetLayout::kChannelsLast : NetLayout::kDense);
}

template <typename F>
NetOutputs Binary(const NetNode& node, const F& f) {
  if (!node.Has(0) || !node.Has(1)) return BadInput(": an input is missing");
  const NetValue &a = node.inputs[0], &b = node.inputs[1];
  const auto dims = BroadcastDims(a, b);
  if (!dims) return dims.error();
  NetValue result = NewLike(node, *dims, a.size() >= b.size() && a.dims == *dims ? a : b);
  result.is_whole = a.is_whole && b.is_whole;
  const NetLoop<3> loop(*dims, {result.strides, BroadcastStrides(a, *dims), BroadcastStrides(b, *dims)});
  node.Add([loop, f, to = result.data.get(), x = a.data.get(), y = b.data.get()] {
    loop.Run([&](const auto& at, int64_t count, const auto& steps) {
      float* out = to + at[0];
      const float *p = x + at[1], *q = y + at[2];
      if (steps[0] == 1 && steps[1] == 1 && steps[2] == 1) {
        for (int64_t i = 0; i < count; ++i) out[i] = f(p[i], q[i]);
      } else if (steps[0] == 1 && steps[1] == 1 && steps[2] == 0) {
        const float number = *q;
        for (int64_t i = 0; i < count; ++i) out[i] = f(p[i], number);
      } else {
        for (int64_t i = 0; i < count; ++i) out[i * steps[0]] = f(p[i * steps[1]], q[i * steps[2]]);
      }
    });
  });
  return One(std::move(result));
}

template <typename F>
NetOutputs Unary(const NetNode& node, const F& f) {
  const NetValue& value = node.inputs[0];
  NetValue result = NewLike(node, value.dims, value);
  result.is_whole = value.is_whole;
  const NetLoop<2> loop(value.dims, {result.strides, value.strides});
  node.Add([loop, f, to = result.data.get(), from = value.data.get()] {
    loop.Run([&](const auto& at, int64_t count, const auto& steps) {
      for (int64_t i = 0; i < count; ++i) to[at[0] + i * steps[0]] = f(from[at[1] + i * steps[1]]);
    });
  });
  return One(std::move(result));
}

using Kernel = void (*)(const float*, float*, size_t);

/// Operators with a vector kernel over numbers that lie in one piece.
NetValue Flat(const NetNode& node, const NetValue& value, Kernel kernel, bool is_in_place) {
  const NetLayout layout = IsChannelsLast(value) ? NetLayout::kChannelsLast : NetLayout::kDense;
  NetValue from = value;
  if (!IsFilled(value)) {  // a view: pixels or axes with gaps between them
    from = node.New(value.dims, layout);
    const NetLoop<2> loop(value.dims, {from.strides, value.strides});
    node.Add([loop, to = from.data.get(), x = value.data.get()] {
      loop.Run([&](const auto& at, int64_t count, const auto& steps) {
        for (int64_t i = 0; i < count; ++i) to[at[0] + i * steps[0]] = x[at[1] + i * steps[1]];
      });
    });
    is_in_place = true;
  }
  const NetValue result = is_in_place ? from : NewLike(node, from.dims, from);
  node.Add([kernel, to = result.data.get(), x = from.data.get(), size = static_cast<size_t>(from.size())] {
    kernel(x, to, size);
  });
  return result;
}

/// A limit of Clip: an attribute in older files, an input in newer ones.
float LimitOf(const NetNode& node, const char* name, size_t input, float otherwise) {
  if (node.node.Find(name) != nullptr) return node.node.Number(name, otherwise);
  return node.Has(input) && node.inputs[input].is_constant && node.inputs[input].size() == 1
             ? NumbersOf(node.inputs[input])[0]
             : otherwise;
}

/// The rest of a division with the sign of the divisor, or of what is divided (fmod).
float Rest(float a, float b, bool has_sign_of_first) {
  const float rest = b == 0 ? 0 : std::fmod(a, b);
  return has_sign_of_first || rest == 0 || (rest < 0) == (b < 0) ? rest : rest + b;
}

/// What comes out as 0 or 1.
NetOutputs Compare(const NetNode& node) {
  static const std::map<std::string, bool (*)(float, float)> tests{
      {"Equal", [](float a, float b) { return a == b; }},
      {"Greater", [](float a, float b) { return a > b; }},
      {"GreaterOrEqual", [](float a, float b) { return a >= b; }},
      {"Less", [](float a, float b) { return a < b; }},
      {"LessOrEqual", [](float a, float b) { return a <= b; }},
      {"And", [](float a, float b) { return a != 0 && b != 0; }},
      {"Or", [](float a, float b) { return a != 0 || b != 0; }},
      {"Xor", [](float a, float b) { return (a != 0) != (b != 0); }}};
  const auto found = tests.find(node.node.op);
  if (found == tests.end()) return NotMine();
  NetOutputs result = Binary(node, [is_so = found->second](float a, float b) { return is_so(a, b) ? 1.f : 0.f; });
  if (result) (*result)[0].is_whole = true;
  return result;
}

/// One of two, as a third says.
NetOutputs Where(const NetNode& node) {
  if (!node.Has(0) || !node.Has(1) || !node.Has(2)) return BadInput(": an input is missing");
  const NetValue &condition = node.inputs[0], &yes = node.inputs[1], &no = node.inputs[2];
  auto dims = BroadcastDims(yes, no);
  if (!dims) return dims.error();
  NetValue both = yes;
  both.dims = *dims;
  dims = BroadcastDims(condition, both);
  if (!dims) return dims.error();
  NetValue result = NewLike(node, *dims, yes.dims == *dims ? yes : no);
  result.is_whole = yes.is_whole && no.is_whole;
  const NetLoop<4> loop(*dims, {result.strides, BroadcastStrides(condition, *dims), BroadcastStrides(yes, *dims),
                                BroadcastStrides(no, *dims)});
  node.Add([loop, to = result.data.get(), is_yes = condition.data.get(), x = yes.data.get(), y = no.data.get()] {
    loop.Run([&](const auto& at, int64_t count, const auto& steps) {
      for (int64_t i = 0; i < count; ++i)
        to[at[0] + i * steps[0]] =
            is_yes[at[1] + i * steps[1]] != 0 ? x[at[2] + i * steps[2]] : y[at[3] + i * steps[3]];
    });
  });
  return One(std::move(result));
}

/// Numbers of the channels, by which all of a channel are multiplied, and to which they are added.
NetOutputs BatchNormalization(const NetNode& node) {
  const int64_t channels = node.inputs[0].rank() > 1 ? node.inputs[0].dims[1] : 0;
  for (size_t i = 1; i < 5; ++i) {
    if (!node.Has(i) || !node.inputs[i].is_constant || node.inputs[i].size() != channels)
      return BadInput(": its numbers are not known beforehand");
  }
  if (node.node.Integer("training_mode", 0) != 0) return BadInput(": it is still being trained");
  Dims dims(node.inputs[0].rank() - 1, 1);
  dims[0] = channels;
  const NetValue factor = node.program.New(dims, NetLayout::kDense, true),
                 offset = node.program.New(dims, NetLayout::kDense, true);
  const auto scale = NumbersOf(node.inputs[1]), shift = NumbersOf(node.inputs[2]), mean = NumbersOf(node.inputs[3]),
             variance = NumbersOf(node.inputs[4]);
  for (size_t i = 0; i < scale.size(); ++i) {
    const float by = scale[i] / std::sqrt(variance[i] + node.node.Number("epsilon", 1e-5f));
    factor.data.get()[i] = by, offset.data.get()[i] = shift[i] - mean[i] * by;
  }
  NetNode next = node;
  next.inputs = {node.inputs[0], factor};
  NetOutputs scaled = Binary(next, [](float a, float b) { return a * b; });
  if (!scaled) return scaled;
  next.inputs = {(*scaled)[0], offset};
  return Binary(next, [](float a, float b) { return a + b; });
}

/// Max and Min of any number of inputs, two by two.
template <typename F>
NetOutputs Folded(const NetNode& node, const F& f) {
  if (node.inputs.size() == 1) return One(node.inputs[0]);
  NetOutputs result = Binary(node, f);
  for (size_t i = 2; result && i < node.inputs.size(); ++i) {
    NetNode next = node;
    next.inputs = {(*result)[0], node.inputs[i]};
    result = Binary(next, f);
  }
  return result;
}

NetOutputs AddBinary(const NetNode& node) {
  const std::string& op = node.node.op;
  const bool is_whole =
      node.inputs.size() > 1 && node.Has(0) && node.Has(1) && node.inputs[0].is_whole && node.inputs[1].is_whole;
  if (op == "Add") return Binary(node, [](float a, float b) { return a + b; });
  if (op == "Sub") return Binary(node, [](float a, float b) { return a - b; });
  if (op == "Mul") return Binary(node, [](float a, float b) { return a * b; });
  if (op == "Div" && is_whole) return Binary(node, [](float a, float b) { return b == 0 ? 0 : std::trunc(a / b); });
  if (op == "Div") return Binary(node, [](float a, float b) { return a / b; });
  if (op == "Pow") return Binary(node, [](float a, float b) { return b == 2 ? a * a : std::pow(a, b); });
  if (op == "Max") return Folded(node, [](float a, float b) { return std::max(a, b); });
  if (op == "Mod") {
    const bool is_fmod = node.node.Integer("fmod", 0) != 0;
    return Binary(node, [is_fmod](float a, float b) { return Rest(a, b, is_fmod); });
  }
  if (op == "PRelu") return Binary(node, [](float x, float slope) { return x < 0 ? slope * x : x; });
  if (op == "Where") return Where(node);
  if (op == "Min") return Folded(node, [](float a, float b) { return std::min(a, b); });
  return NotMine();
}

NetOutputs AddUnary(const NetNode& node) {
  const std::string& op = node.node.op;
  if (op == "Sigmoid") return One(Flat(node, node.inputs[0], Sigmoids, false));
  if (op == "Relu") return Unary(node, [](float x) { return std::max(x, 0.f); });
  if (op == "Exp") return Unary(node, [](float x) { return std::exp(x); });
  if (op == "Log") return Unary(node, [](float x) { return std::log(x); });
  if (op == "Sqrt") return Unary(node, [](float x) { return std::sqrt(x); });
  if (op == "Neg") return Unary(node, [](float x) { return -x; });
  if (op == "Abs") return Unary(node, [](float x) { return std::abs(x); });
  if (op == "Floor") return Unary(node, [](float x) { return std::floor(x); });
  if (op == "Ceil") return Unary(node, [](float x) { return std::ceil(x); });
  if (op == "Tanh") return Unary(node, [](float x) { return std::tanh(x); });
  if (op == "Softplus") return Unary(node, [](float x) { return x > 20 ? x : std::log1p(std::exp(x)); });
  if (op == "HardSwish") return One(AddHardSwish(node, node.inputs[0], false));
  if (op == "LeakyRelu")
    return Unary(node, [slope = node.node.Number("alpha", 0.01f)](float x) { return x < 0 ? slope * x : x; });
  if (op == "HardSigmoid") {
    const float alpha = node.node.Number("alpha", 0.2f), beta = node.node.Number("beta", 0.5f);
    return Unary(node, [alpha, beta](float x) { return std::clamp(alpha * x + beta, 0.f, 1.f); });
  }
  if (op == "Not") return Unary(node, [](float x) { return x == 0 ? 1.f : 0.f; });
  if (op == "Sin") return Unary(node, [](float x) { return std::sin(x); });
  if (op == "Cos") return Unary(node, [](float x) { return std::cos(x); });
  if (op == "Erf") return Unary(node, [](float x) { return std::erf(x); });
  if (op == "Reciprocal") return Unary(node, [](float x) { return 1 / x; });
  if (op == "Mish") return Unary(node, [](float x) { return x * std::tanh(x > 20 ? x : std::log1p(std::exp(x))); });
  if (op == "Clip") {
    for (const size_t limit : {1, 2}) {
      if (node.Has(limit) && !node.inputs[limit].is_constant) return BadInput(": its limits are not known beforehand");
    }
    const float low = LimitOf(node, "min", 1, -HUGE_VALF), high = LimitOf(node, "max", 2, HUGE_VALF);
    return Unary(node, [low, high](float x) { return std::min(std::max(x, low), high); });
  }
  return NotMine();
}

/// The same numbers as a matrix: the axes before one, and those from it on.
NetValue AsMatrix(const NetNode& node, const NetValue& value, size_t axis) {
  NetValue matrix = WithLayout(node, value, NetLayout::kDense);
  matrix.dims = {1, 1};
  for (size_t i = 0; i < value.rank(); ++i) matrix.dims[i < axis ? 0 : 1] *= value.dims[i];
  matrix.strides = DenseStrides(matrix.dims);
  return matrix;
}

/// Softmax over one axis; before opset 13 over it and all behind it as if they were one.
NetOutputs Softmax(const NetNode& node) {
  NetValue value = node.inputs[0];
  const bool is_new = node.opset >= 13;
  const auto rank = static_cast<int64_t>(value.rank());
  int64_t axis = node.node.Integer("axis", is_new ? -1 : 1);
  axis += axis < 0 ? rank : 0;
  if (axis < 0 || axis >= rank) return BadInput(": its axis is not read");
  auto index = static_cast<size_t>(axis);
  if (!is_new && axis != rank - 1) value = AsMatrix(node, value, std::exchange(index, 1));
  NetValue result = node.New(value.dims);
  Dims rest = value.dims;
  rest[index] = 1;
  const NetLoop<2> loop(rest, {result.strides, value.strides});
  const int64_t size = value.dims[index], to_step = result.strides[index], from_step = value.strides[index];
  node.Add([loop, size, to_step, from_step, to = result.data.get(), from = value.data.get()] {
    loop.Run([&](const auto& at, int64_t count, const auto& steps) {
      for (int64_t i = 0; i < count; ++i) {
        float* out = to + at[0] + i * steps[0];
        const float* in = from + at[1] + i * steps[1];
        float most = in[0], sum = 0;
        for (int64_t k = 1; k < size; ++k) most = std::max(most, in[k * from_step]);
        for (int64_t k = 0; k < size; ++k) sum += out[k * to_step] = std::exp(in[k * from_step] - most);
        for (int64_t k = 0; k < size; ++k) out[k * to_step] /= sum;
      }
    });
  });
  result.dims = node.inputs[0].dims, result.strides = DenseStrides(result.dims);
  return One(std::move(result));
}

/// (..., n, k) x (..., k, m); the axes before the last two are repeated where one side has none of them.
NetOutputs MatMul(const NetNode& node) {
  const NetValue a = WithLayout(node, node.inputs[0], NetLayout::kDense),
                 b = WithLayout(node, node.inputs[1], NetLayout::kDense);
  if (a.rank() < 2 || b.rank() < 2 || a.dims.back() != b.dims[b.rank() - 2])
    return BadInput(": its inputs do not fit together");
  NetValue outer_a = a, outer_b = b;
  for (NetValue* outer : {&outer_a, &outer_b})
    outer->dims.resize(outer->rank() - 2), outer->strides.resize(outer->dims.size());
  auto dims = BroadcastDims(outer_a, outer_b);
  if (!dims) return dims.error();
  const int64_t n = a.dims[a.rank() - 2], k = a.dims.back(), m = b.dims.back();
  Dims all = *dims;
  all.push_back(n), all.push_back(m);
  NetValue result = node.New(all);
  const Dims to_strides(result.strides.begin(), result.strides.end() - 2);
  const NetLoop<3> loop(*dims, {to_strides, BroadcastStrides(outer_a, *dims), BroadcastStrides(outer_b, *dims)});
  node.Add([loop, n, k, m, to = result.data.get(), x = a.data.get(), y = b.data.get()] {
    loop.Run([&](const auto& at, int64_t count, const auto& steps) {
      for (int64_t i = 0; i < count * n; ++i) {
        const int64_t matrix = i / n, row = i % n;
        float* out = to + at[0] + matrix * steps[0] + row * m;
        const float *left = x + at[1] + matrix * steps[1] + row * k, *right = y + at[2] + matrix * steps[2];
        std::fill(out, out + m, 0.f);
        for (int64_t j = 0; j < k; ++j) {
          for (int64_t column = 0; column < m; ++column) out[column] += left[j] * right[j * m + column];
        }
      }
    });
  });
  return One(std::move(result));
}

/// Mean, sum or maximum along axes.
NetOutputs Reduce(const NetNode& node) {
  auto axes = node.Integers("axes", 1);
  if (!axes) return axes.error();
  const NetValue& value = node.inputs[0];
  const auto rank = static_cast<int64_t>(value.rank());
  std::vector<bool> is_reduced(value.rank(), axes->empty());
  for (const int64_t axis : *axes) {
    if (axis < -rank || axis >= rank) return BadInput(": an axis does not exist");
    is_reduced[static_cast<size_t>(axis < 0 ? axis + rank : axis)] = true;
  }
  Dims kept = value.dims;
  for (size_t i = 0; i < kept.size(); ++i) kept[i] = is_reduced[i] ? 1 : kept[i];
  NetValue result = node.New(kept, IsChannelsLast(value) ? NetLayout::kChannelsLast : NetLayout::kDense);
  const NetLoop<2> loop(value.dims, {BroadcastStrides(result, value.dims), value.strides});
  const bool is_max = node.node.op == "ReduceMax", is_mean = node.node.op == "ReduceMean";
  const float factor = is_mean ? static_cast<float>(result.size()) / static_cast<float>(value.size()) : 1.f;
  node.Add([loop, is_max, factor, size = result.size(), to = result.data.get(), from = value.data.get()] {
    std::fill(to, to + size, is_max ? -HUGE_VALF : 0.f);
    loop.Run([&](const auto& at, int64_t count, const auto& steps) {
      for (int64_t i = 0; i < count; ++i) {
        float& out = to[at[0] + i * steps[0]];
        const float number = from[at[1] + i * steps[1]];
        out = is_max ? std::max(out, number) : out + number;
      }
    });
    for (int64_t i = 0; i < size; ++i) to[i] *= factor;
  });
  if (node.node.Integer("keepdims", 1) != 0) return One(std::move(result));
  NetValue squeezed = result;
  squeezed.dims.clear(), squeezed.strides.clear();
  for (size_t i = 0; i < kept.size(); ++i) {
    if (!is_reduced[i]) squeezed.dims.push_back(result.dims[i]), squeezed.strides.push_back(result.strides[i]);
  }
  return One(std::move(squeezed));
}

}  // namespace

NetValue AddSilu(const NetNode& node, const NetValue& value, bool is_in_place) {
  return Flat(node, value, Silus, is_in_place);
}

NetValue AddHardSwish(const NetNode& node, const NetValue& value, bool is_in_place) {
  return Flat(node, value, HardSwishes, is_in_place);
}

NetOutputs AddArithmetic(const NetNode& node) {
  if (!node.Has(0)) return BadInput(": an input is missing");
  const std::string& op = node.node.op;
  if (op == "Softmax") return Softmax(node);
  if (op == "MatMul" && node.Has(1)) return MatMul(node);
  if (op == "ReduceMean" || op == "ReduceMax" || op == "ReduceSum") return Reduce(node);
  if (op == "BatchNormalization") return BatchNormalization(node);
  NetOutputs outputs = AddUnary(node);
  for (const auto family : {AddBinary, Compare}) {
    if (outputs.ok() || !outputs.error().message.empty()) break;
    outputs = family(node);
  }
  return outputs;
}

}  // namespace yorb
