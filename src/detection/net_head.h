// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "detection/net_program.h"

struct xnn_operator;

namespace yorb {

/// A convolution of single pixels of whose result little is read: where a few of its channels all stay below a limit,
/// the others need not be computed. Nearly all cells of a detector's map are so.
class NetHead {
 public:
  /// Null where the node is no such convolution.
  static std::shared_ptr<NetHead> Of(const NetNode& node);

  const NetValue& output() const { return output_; }

  /// From the next run on: these channels are computed everywhere, the others where one of these reaches `least`.
  void ComputeWhere(const std::vector<int64_t>& channels, float least);

  void Run();

 private:
  /// A product of rows of `in` numbers with weights, for any number of rows.
  struct Product {
    std::shared_ptr<xnn_operator> op;
    int64_t in_step = 0, out = 0;
  };

  NetHead() = default;
  Product ProductOf(const std::vector<int64_t>& channels, int64_t in_step) const;
  void Multiply(const Product& product, int64_t rows, const float* from, float* to) const;
  std::vector<int64_t> PixelsToCompute();

  std::vector<float> weights_, bias_;  ///< (out, in); (out)
  int64_t in_ = 0, out_ = 0, num_pixels_ = 0, pixel_step_ = 0;
  const float* from_ = nullptr;
  NetValue output_;
  pthreadpool* threads_ = nullptr;

  Product all_, first_, some_;
  std::vector<int64_t> first_channels_;
  float least_ = 0;
  std::vector<float> first_results_, some_inputs_, some_results_;
};

}  // namespace yorb
