// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/net_value.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>

#include "detection/engine.h"

namespace yorb {
namespace {

std::shared_ptr<float> NewBuffer(int64_t size) {
  static constexpr std::align_val_t kAlignment{64};
  static constexpr int64_t kSlack = 64;  // floats behind the end that vector kernels may read
  const auto count = static_cast<size_t>(size + kSlack);
  auto* data = static_cast<float*>(::operator new(count * sizeof(float), kAlignment));
  std::fill(data, data + count, 0.f);
  return {data, [](float* gone) { ::operator delete(gone, kAlignment); }};
}

}  // namespace

NetValue NewConstant(const std::vector<int64_t>& dims, NetLayout layout) {
  NetValue value;
  value.dims = dims;
  value.strides = StridesOf(dims, layout);
  value.data = NewBuffer(value.size());
  value.is_constant = true;
  return value;
}

NetValue Filled(NetValue value, const OnnxTensor& tensor) {
  value.is_whole = tensor.is_whole, value.onnx_type = tensor.type;
  if (tensor.is_whole) {
    std::transform(tensor.ints.begin(), tensor.ints.end(), value.data.get(),
                   [](int64_t number) { return static_cast<float>(number); });
  } else {
    std::copy(tensor.floats.begin(), tensor.floats.end(), value.data.get());
  }
  return value;
}

std::shared_ptr<float> BufferPool::Take(int64_t size) {
  std::shared_ptr<Buffer> best;
  for (const auto& buffer : buffers_) {
    if (!buffer->is_free || buffer->size < size) continue;
    if (!best || buffer->size < best->size) best = buffer;
  }
  if (!best) {
    best = std::make_shared<Buffer>(Buffer{NewBuffer(size), size});
    buffers_.push_back(best);
  }
  best->is_free = false;
  return {best->data.get(), [best](float*) { best->is_free = true; }};
}

int64_t NetValue::size() const {
  return std::accumulate(dims.begin(), dims.end(), int64_t{1}, [](int64_t a, int64_t b) { return a * b; });
}

bool IsDense(const NetValue& value) {
  int64_t step = 1;
  for (size_t i = value.rank(); i > 0; --i) {
    if (value.dims[i - 1] != 1 && value.strides[i - 1] != step) return false;
    step *= value.dims[i - 1];
  }
  return true;
}

bool IsFilled(const NetValue& value) {
  int64_t last = 0;
  for (size_t i = 0; i < value.rank(); ++i) {
    if (value.dims[i] > 1 && value.strides[i] == 0) return false;
    last += (value.dims[i] - 1) * value.strides[i];
  }
  return last + 1 == value.size();
}

bool IsChannelsLast(const NetValue& value) {
  if (value.rank() != 4) return false;
  const int64_t pixel = value.dims[3] > 1 ? value.strides[3] : value.dims[2] > 1 ? value.strides[2] : value.dims[1];
  const bool has_channels = value.dims[1] == 1 || value.strides[1] == 1;
  const bool has_rows = value.dims[2] == 1 || value.strides[2] == value.dims[3] * pixel;
  const bool has_pictures = value.dims[0] == 1 || value.strides[0] == value.dims[2] * value.dims[3] * pixel;
  return has_channels && pixel >= value.dims[1] && has_rows && has_pictures;
}

std::vector<float> NumbersOf(const NetValue& value) {
  if (IsDense(value)) return {value.data.get(), value.data.get() + value.size()};
  std::vector<float> numbers;
  const std::vector<int64_t> order = DenseStrides(value.dims);
  for (int64_t i = 0; i < value.size(); ++i) {
    int64_t rest = i, at = 0;
    for (size_t axis = 0; axis < value.rank(); ++axis) {
      at += rest / order[axis] * value.strides[axis];
      rest %= order[axis];
    }
    numbers.push_back(value.data.get()[at]);
  }
  return numbers;
}

std::vector<int64_t> WholeNumbersOf(const NetValue& value) {
  constexpr float kMost = 1e15f;  // beyond: "to the end"
  std::vector<int64_t> numbers;
  for (const float number : NumbersOf(value))
    numbers.push_back(static_cast<int64_t>(std::llround(std::clamp(number, -kMost, kMost))));
  return numbers;
}

std::vector<int64_t> StridesOf(const std::vector<int64_t>& dims, NetLayout layout) {
  if (layout == NetLayout::kDense || dims.size() != 4) return DenseStrides(dims);
  const int64_t pixel = dims[1], row = pixel * dims[3];
  return {row * dims[2], 1, row, pixel};
}

}  // namespace yorb
