// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

namespace yorb {

/// Walks over the numbers of N values at once, in the order in which those of the first lie in memory. Axes that lie
/// behind each other in all of them become one, so that most loops are a single run over all numbers.
template <size_t N>
class NetLoop {
 public:
  using Steps = std::array<int64_t, N>;

  /// `strides`: of each value, an axis of `dims` each; 0 where a value is the same along it.
  NetLoop(const std::vector<int64_t>& dims, const std::array<std::vector<int64_t>, N>& strides) {
    std::vector<size_t> axes;
    for (size_t i = 0; i < dims.size(); ++i) {
      if (dims[i] != 1) axes.push_back(i);
    }
    std::stable_sort(axes.begin(), axes.end(), [&](size_t a, size_t b) { return strides[0][a] > strides[0][b]; });
    for (const size_t axis : axes) Add(dims[axis], StepsOf(strides, axis));
    if (counts_.empty()) Add(1, {});
  }

  /// Calls row(offsets, count, steps) for every innermost run.
  template <typename Row>
  void Run(const Row& row) const {
    const size_t inner = counts_.size() - 1;
    std::vector<int64_t> at(inner, 0);
    Steps offsets{};
    while (true) {
      row(offsets, counts_[inner], steps_[inner]);
      size_t axis = inner;
      while (axis > 0 && ++at[axis - 1] == counts_[axis - 1]) {
        at[axis - 1] = 0;
        for (size_t i = 0; i < N; ++i) offsets[i] -= steps_[axis - 1][i] * (counts_[axis - 1] - 1);
        --axis;
      }
      if (axis == 0) return;
      for (size_t i = 0; i < N; ++i) offsets[i] += steps_[axis - 1][i];
    }
  }

 private:
  static Steps StepsOf(const std::array<std::vector<int64_t>, N>& strides, size_t axis) {
    Steps steps;
    for (size_t i = 0; i < N; ++i) steps[i] = strides[i][axis];
    return steps;
  }

  void Add(int64_t count, const Steps& steps) {
    const auto continues = [&] {
      for (size_t i = 0; i < N; ++i) {
        if (steps_.back()[i] != steps[i] * count) return false;
      }
      return true;
    };
    if (!counts_.empty() && continues()) {
      counts_.back() *= count;
      steps_.back() = steps;
    } else {
      counts_.push_back(count);
      steps_.push_back(steps);
    }
  }

  std::vector<int64_t> counts_;
  std::vector<Steps> steps_;
};

}  // namespace yorb
