// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/net_program.h"

#include <algorithm>
#include <utility>

#include "detection/net_loop.h"

namespace yorb {

NetValue NetProgram::New(const std::vector<int64_t>& dims, NetLayout layout, bool is_constant) {
  if (is_constant) return constants_.emplace_back(NewConstant(dims, layout));
  NetValue value;
  value.dims = dims;
  value.strides = StridesOf(dims, layout);
  value.data = pool_.Take(std::max<int64_t>(value.size(), 1));
  return value;
}

void NetProgram::Add(std::function<void()> step, bool is_constant) {
  if (is_constant) {
    step();
  } else {
    steps_.push_back(std::move(step));
  }
}

Result<std::vector<int64_t>> NetNode::Integers(const char* attribute, size_t input) const {
  if (const OnnxAttribute* found = node.Find(attribute)) return found->ints;
  if (!Has(input)) return std::vector<int64_t>{};
  if (!inputs[input].is_constant) return BadInput(std::string(": ") + attribute + " is not known beforehand");
  return WholeNumbersOf(inputs[input]);
}

Result<size_t> AxisOf(int64_t axis, size_t rank) {
  const int64_t from_front = axis < 0 ? axis + static_cast<int64_t>(rank) : axis;
  if (from_front < 0 || from_front >= static_cast<int64_t>(rank)) return BadInput(": an axis does not exist");
  return static_cast<size_t>(from_front);
}

NetValue WithLayout(const NetNode& node, const NetValue& value, NetLayout layout) {
  const bool is_fine = layout == NetLayout::kDense ? IsDense(value) : IsChannelsLast(value);
  if (is_fine) return value;
  NetValue copy = node.program.New(value.dims, layout, value.is_constant);
  copy.is_whole = value.is_whole;
  const NetLoop<2> loop(value.dims, {copy.strides, value.strides});
  node.program.Add(
      [loop, to = copy.data.get(), from = value.data.get()] {
        loop.Run([&](const auto& at, int64_t count, const auto& steps) {
          for (int64_t i = 0; i < count; ++i) to[at[0] + i * steps[0]] = from[at[1] + i * steps[1]];
        });
      },
      value.is_constant);
  return copy;
}

}  // namespace yorb
