// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Operators that choose among numbers by what the network computes: what end-to-end networks have behind their heads.
// Indices are kept within their axis, so that no file makes them read elsewhere.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>
#include <utility>

#include "detection/engine.h"
#include "detection/net_loop.h"
#include "detection/net_program.h"

namespace yorb {
namespace {

using Dims = std::vector<int64_t>;

int64_t SizeOf(const Dims& dims, size_t first, size_t last) {
  return std::accumulate(dims.begin() + static_cast<int64_t>(first), dims.begin() + static_cast<int64_t>(last),
                         int64_t{1}, [](int64_t a, int64_t b) { return a * b; });
}

/// An index as it was computed: counted from the end where it is negative, and no other than there are.
int64_t Within(float index, int64_t size) {
  if (std::isnan(index)) return 0;
  const auto whole = static_cast<int64_t>(std::clamp(index, -1e9f, 1e9f));
  return std::clamp<int64_t>(whole < 0 ? whole + size : whole, 0, size - 1);
}

/// The largest or smallest along an axis and where they are; of equal ones the first comes first, and what is no number
/// is larger than all.
NetOutputs TopK(const NetNode& node) {
  const auto wanted = node.Integers("k", 1);
  if (!wanted) return wanted.error();
  const NetValue value = WithLayout(node, node.inputs[0], NetLayout::kDense);
  const auto axis = AxisOf(node.node.Integer("axis", -1), value.rank());
  if (!axis) return axis.error();
  const int64_t size = value.dims[*axis], count = wanted->size() == 1 ? (*wanted)[0] : -1;
  if (count < 1 || count > size) return BadInput(": it asks for more than there are");
  Dims dims = value.dims;
  dims[*axis] = count;
  NetValue best = node.New(dims), places = node.New(dims);
  best.is_whole = value.is_whole, places.is_whole = true;
  const int64_t outer = SizeOf(dims, 0, *axis), inner = SizeOf(dims, *axis + 1, dims.size());
  const bool is_largest = node.node.Integer("largest", 1) != 0;
  node.Add([=, from = value.data.get(), to = best.data.get(), at = places.data.get()] {
    std::vector<int64_t> order(static_cast<size_t>(size));
    for (int64_t row = 0; row < outer * inner; ++row) {
      const int64_t place = row / inner * inner * size + row % inner, out = row / inner * inner * count + row % inner;
      const auto comes_before = [&](int64_t a, int64_t b) {
        const float x = from[place + a * inner], y = from[place + b * inner];
        const bool is_above = std::isnan(x) ? !std::isnan(y) : x > y, is_below = std::isnan(y) ? !std::isnan(x) : x < y;
        return is_above || is_below ? is_above == is_largest : a < b;
      };
      std::iota(order.begin(), order.end(), int64_t{0});
      std::partial_sort(order.begin(), order.begin() + count, order.end(), comes_before);
      for (int64_t i = 0; i < count; ++i) {
        const int64_t chosen = order[static_cast<size_t>(i)];
        to[out + i * inner] = from[place + chosen * inner];
        at[out + i * inner] = static_cast<float>(chosen);
      }
    }
  });
  return std::vector<NetValue>{std::move(best), std::move(places)};
}

/// Where the largest is along an axis, the first of equal ones.
NetOutputs ArgMax(const NetNode& node) {
  const NetValue value = WithLayout(node, node.inputs[0], NetLayout::kDense);
  const auto axis = AxisOf(node.node.Integer("axis", 0), value.rank());
  if (!axis) return axis.error();
  if (node.node.Integer("select_last_index", 0) != 0) return BadInput(": it takes the last of equal ones");
  const int64_t size = value.dims[*axis], outer = SizeOf(value.dims, 0, *axis),
                inner = SizeOf(value.dims, *axis + 1, value.rank());
  Dims dims = value.dims;
  dims[*axis] = 1;
  if (node.node.Integer("keepdims", 1) == 0) dims.erase(dims.begin() + static_cast<int64_t>(*axis));
  NetValue places = node.New(dims);
  places.is_whole = true;
  node.Add([=, from = value.data.get(), to = places.data.get()] {
    for (int64_t row = 0; row < outer * inner; ++row) {
      const float* first = from + row / inner * inner * size + row % inner;
      int64_t best = 0;
      for (int64_t i = 1; i < size; ++i) best = first[i * inner] > first[best * inner] ? i : best;
      to[row] = static_cast<float>(best);
    }
  });
  return One(std::move(places));
}

/// Rows of a value by numbers that are computed.
NetOutputs GatherComputed(const NetNode& node) {
  const NetValue value = WithLayout(node, node.inputs[0], NetLayout::kDense),
                 indices = WithLayout(node, node.inputs[1], NetLayout::kDense);
  const auto axis = AxisOf(node.node.Integer("axis", 0), value.rank());
  if (!axis) return axis.error();
  const int64_t size = value.dims[*axis], outer = SizeOf(value.dims, 0, *axis),
                inner = SizeOf(value.dims, *axis + 1, value.rank()), count = indices.size();
  Dims dims = value.dims;
  dims.erase(dims.begin() + static_cast<int64_t>(*axis));
  dims.insert(dims.begin() + static_cast<int64_t>(*axis), indices.dims.begin(), indices.dims.end());
  NetValue gathered = node.New(dims);
  gathered.is_whole = value.is_whole;
  node.Add([=, from = value.data.get(), at = indices.data.get(), to = gathered.data.get()] {
    for (int64_t row = 0; row < outer * count; ++row) {
      const int64_t chosen = Within(at[row % count], size);
      std::copy_n(from + (row / count * size + chosen) * inner, inner, to + row * inner);
    }
  });
  return One(std::move(gathered));
}

/// Each number of the result is one of the same place, but along the axis of the one that its index names.
NetOutputs GatherElements(const NetNode& node) {
  const NetValue &value = node.inputs[0], &indices = node.inputs[1];
  const auto axis = AxisOf(node.node.Integer("axis", 0), value.rank());
  if (!axis) return axis.error();
  if (indices.rank() != value.rank()) return BadInput(": its inputs do not fit together");
  for (size_t i = 0; i < value.rank(); ++i) {
    if (i != *axis && indices.dims[i] > value.dims[i]) return BadInput(": its inputs do not fit together");
  }
  NetValue gathered = node.New(indices.dims);
  gathered.is_whole = value.is_whole;
  Dims strides = value.strides;
  strides[*axis] = 0;
  const NetLoop<3> loop(indices.dims, {gathered.strides, indices.strides, strides});
  node.Add([loop, size = value.dims[*axis], step = value.strides[*axis], to = gathered.data.get(),
            at_index = indices.data.get(), from = value.data.get()] {
    loop.Run([&](const auto& at, int64_t count, const auto& steps) {
      for (int64_t i = 0; i < count; ++i) {
        const int64_t chosen = Within(at_index[at[1] + i * steps[1]], size);
        to[at[0] + i * steps[0]] = from[at[2] + i * steps[2] + chosen * step];
      }
    });
  });
  return One(std::move(gathered));
}

/// Blocks of a value, each named by the numbers along the last axis of the indices.
struct Blocks {
  Dims dims, steps;  ///< of the axes that the numbers name
  int64_t num_numbers = 0, size = 0, count = 0;

  int64_t PlaceOf(const float* numbers) const {
    int64_t place = 0;
    for (size_t i = 0; i < dims.size(); ++i) place += Within(numbers[i], dims[i]) * steps[i];
    return place;
  }
};

Result<Blocks> BlocksOf(const NetValue& value, const NetValue& indices) {
  const int64_t num_numbers = indices.rank() == 0 ? 0 : indices.dims.back();
  if (num_numbers < 1 || num_numbers > static_cast<int64_t>(value.rank()) || value.size() == 0)
    return BadInput(": its inputs do not fit together");
  Blocks blocks;
  const auto split = static_cast<size_t>(num_numbers);
  const Dims steps = DenseStrides(value.dims);
  blocks.dims.assign(value.dims.begin(), value.dims.begin() + num_numbers);
  blocks.steps.assign(steps.begin(), steps.begin() + num_numbers);
  blocks.num_numbers = num_numbers, blocks.size = SizeOf(value.dims, split, value.rank());
  blocks.count = indices.size() / num_numbers;
  return blocks;
}

NetOutputs GatherND(const NetNode& node) {
  if (node.node.Integer("batch_dims", 0) != 0) return BadInput(": it gathers picture by picture (batch_dims)");
  const NetValue value = WithLayout(node, node.inputs[0], NetLayout::kDense),
                 indices = WithLayout(node, node.inputs[1], NetLayout::kDense);
  const auto blocks = BlocksOf(value, indices);
  if (!blocks) return blocks.error();
  Dims dims(indices.dims.begin(), indices.dims.end() - 1);
  dims.insert(dims.end(), value.dims.begin() + blocks->num_numbers, value.dims.end());
  NetValue gathered = node.New(dims);
  gathered.is_whole = value.is_whole;
  node.Add([blocks = *blocks, from = value.data.get(), at = indices.data.get(), to = gathered.data.get()] {
    for (int64_t i = 0; i < blocks.count; ++i)
      std::copy_n(from + blocks.PlaceOf(at + i * blocks.num_numbers), blocks.size, to + i * blocks.size);
  });
  return One(std::move(gathered));
}

/// A copy with some blocks replaced, as heads have it that write into slices.
NetOutputs ScatterND(const NetNode& node) {
  if (!node.Has(2) || node.node.Text("reduction", "none") != "none") return BadInput(": it adds up what it writes");
  const NetValue value = WithLayout(node, node.inputs[0], NetLayout::kDense),
                 indices = WithLayout(node, node.inputs[1], NetLayout::kDense),
                 updates = WithLayout(node, node.inputs[2], NetLayout::kDense);
  const auto blocks = BlocksOf(value, indices);
  if (!blocks) return blocks.error();
  if (updates.size() != blocks->count * blocks->size) return BadInput(": its inputs do not fit together");
  NetValue result = node.New(value.dims);
  result.is_whole = value.is_whole;
  node.Add([blocks = *blocks, size = value.size(), from = value.data.get(), at = indices.data.get(),
            with = updates.data.get(), to = result.data.get()] {
    std::copy_n(from, size, to);
    for (int64_t i = 0; i < blocks.count; ++i)
      std::copy_n(with + i * blocks.size, blocks.size, to + blocks.PlaceOf(at + i * blocks.num_numbers));
  });
  return One(std::move(result));
}

/// Copies one value to where another's strides say.
void AddCopy(const NetNode& node, const Dims& dims, const Dims& to_strides, float* to, const NetValue& value,
             const Dims& from_strides) {
  const NetLoop<2> loop(dims, {to_strides, from_strides});
  node.Add([loop, to, from = value.data.get()] {
    loop.Run([&](const auto& at, int64_t count, const auto& steps) {
      for (int64_t i = 0; i < count; ++i) to[at[0] + i * steps[0]] = from[at[1] + i * steps[1]];
    });
  });
}

NetOutputs Tile(const NetNode& node) {
  constexpr int64_t kMost = 1 << 26;
  const NetValue& value = node.inputs[0];
  const auto repeats = node.Integers("repeats", 1);
  if (!repeats) return repeats.error();
  if (repeats->size() != value.rank()) return BadInput(": its inputs do not fit together");
  Dims dims = value.dims, loop_dims, from_strides, to_strides;
  for (size_t i = 0; i < dims.size(); ++i) {
    if ((*repeats)[i] < 1 || (*repeats)[i] > kMost) return BadInput(": its shape makes no sense");
    dims[i] *= (*repeats)[i];
    if (SizeOf(dims, 0, dims.size()) > kMost) return BadInput(": its shape makes no sense");
  }
  NetValue tiled = node.New(dims);
  tiled.is_whole = value.is_whole;
  for (size_t i = 0; i < dims.size(); ++i) {
    loop_dims.insert(loop_dims.end(), {(*repeats)[i], value.dims[i]});
    from_strides.insert(from_strides.end(), {0, value.strides[i]});
    to_strides.insert(to_strides.end(), {tiled.strides[i] * value.dims[i], tiled.strides[i]});
  }
  AddCopy(node, loop_dims, to_strides, tiled.data.get(), value, from_strides);
  return One(std::move(tiled));
}

/// A frame of one number about a value.
NetOutputs Pad(const NetNode& node) {
  const NetValue& value = node.inputs[0];
  auto pads = node.Integers("pads", 1);
  if (!pads) return pads.error();
  const size_t rank = value.rank();
  const bool has_axes = node.Has(3),
             is_known = !node.Has(2) || (node.inputs[2].is_constant && node.inputs[2].size() == 1);
  if (node.node.Text("mode", "constant") != "constant" || has_axes || !is_known || pads->size() != 2 * rank)
    return BadInput(": it is of a kind that is not read");
  const float number = node.Has(2) ? NumbersOf(node.inputs[2])[0] : node.node.Number("value", 0);
  Dims dims = value.dims;
  for (size_t i = 0; i < rank; ++i) {
    if ((*pads)[i] < 0 || (*pads)[i] > 4096 || (*pads)[i + rank] < 0 || (*pads)[i + rank] > 4096)
      return BadInput(": it cuts pixels off");
    dims[i] += (*pads)[i] + (*pads)[i + rank];
  }
  NetValue padded = node.New(dims, IsChannelsLast(value) ? NetLayout::kChannelsLast : NetLayout::kDense);
  padded.is_whole = value.is_whole;
  node.Add([number, size = padded.size(), to = padded.data.get()] { std::fill_n(to, size, number); });
  int64_t start = 0;
  for (size_t i = 0; i < rank; ++i) start += (*pads)[i] * padded.strides[i];
  AddCopy(node, value.dims, padded.strides, padded.data.get() + start, value, value.strides);
  return One(std::move(padded));
}

}  // namespace

NetOutputs AddSelection(const NetNode& node) {
  static const std::map<std::string, std::pair<NetOutputs (*)(const NetNode&), size_t>> operators{
      {"TopK", {TopK, 1}},
      {"ArgMax", {ArgMax, 1}},
      {"Gather", {GatherComputed, 2}},
      {"GatherElements", {GatherElements, 2}},
      {"GatherND", {GatherND, 2}},
      {"ScatterND", {ScatterND, 2}},
      {"Tile", {Tile, 2}},
      {"Pad", {Pad, 1}}};
  const auto found = operators.find(node.node.op);
  if (found == operators.end()) return NotMine();
  for (size_t i = 0; i < found->second.second; ++i) {
    if (!node.Has(i)) return BadInput(": an input is missing");
  }
  if (node.inputs[0].rank() == 0 || node.inputs[0].size() == 0) return BadInput(": it has nothing to choose from");
  return found->second.first(node);
}

}  // namespace yorb
