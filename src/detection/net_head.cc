// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/net_head.h"

#if defined(YORB_HAS_XNNPACK)
#include <xnnpack.h>

#include <algorithm>
#include <numeric>

namespace yorb {

namespace {

bool IsOfSinglePixels(const NetNode& node) {
  const auto all = [&node](const char* name, int64_t wanted) {
    const std::vector<int64_t> numbers = node.node.Integers(name, {});
    return std::all_of(numbers.begin(), numbers.end(), [wanted](int64_t number) { return number == wanted; });
  };
  if (node.node.op != "Conv" || !node.Has(0) || !node.Has(1)) return false;
  const NetValue &input = node.inputs[0], &weights = node.inputs[1];
  const bool has_sound_weights = weights.is_constant && weights.rank() == 4 && weights.dims[2] == 1 &&
                                 weights.dims[3] == 1 && input.rank() == 4 && weights.dims[1] == input.dims[1];
  const bool has_sound_bias =
      !node.Has(2) || (node.inputs[2].is_constant && has_sound_weights && node.inputs[2].size() == weights.dims[0]);
  return has_sound_weights && has_sound_bias && node.node.Integer("group", 1) == 1 && all("strides", 1) &&
         all("pads", 0) && node.least == -HUGE_VALF && node.most == HUGE_VALF;
}

}  // namespace

// Rows of XNNPACK's products do not depend on one another: what is computed is equal to the bit.
std::shared_ptr<NetHead> NetHead::Of(const NetNode& node) {
  if (!IsOfSinglePixels(node)) return nullptr;
  const NetValue &input = node.inputs[0], &weights = node.inputs[1];
  if (!IsChannelsLast(input) || input.dims[0] != 1 || input.dims[3] < 2) return nullptr;
  std::shared_ptr<NetHead> head(new NetHead());
  head->weights_ = NumbersOf(weights);
  head->in_ = weights.dims[1], head->out_ = weights.dims[0];
  head->bias_ = node.Has(2) ? NumbersOf(node.inputs[2]) : std::vector<float>(static_cast<size_t>(head->out_), 0.f);
  head->num_pixels_ = input.dims[2] * input.dims[3], head->pixel_step_ = input.strides[3];
  head->from_ = input.data.get(), head->threads_ = node.program.threads();
  head->output_ = node.New({1, head->out_, input.dims[2], input.dims[3]}, NetLayout::kChannelsLast);
  std::vector<int64_t> channels(static_cast<size_t>(head->out_));
  std::iota(channels.begin(), channels.end(), 0);
  head->all_ = head->ProductOf(channels, head->pixel_step_);
  head->some_ = head->ProductOf(channels, head->in_);
  return head->all_.op && head->some_.op ? head : nullptr;
}

NetHead::Product NetHead::ProductOf(const std::vector<int64_t>& channels, int64_t in_step) const {
  std::vector<float> weights, bias;
  for (const int64_t channel : channels) {
    const auto row = weights_.begin() + channel * in_;
    weights.insert(weights.end(), row, row + in_);
    bias.push_back(bias_[static_cast<size_t>(channel)]);
  }
  const size_t in = static_cast<size_t>(in_), out = channels.size();
  xnn_operator_t op = nullptr;
  const xnn_status made = xnn_create_fully_connected_nc_f32(in, out, static_cast<size_t>(in_step), out, weights.data(),
                                                            bias.data(), -HUGE_VALF, HUGE_VALF, 0, &op);
  if (made != xnn_status_success) return {};
  return {{op, [](xnn_operator_t gone) { xnn_delete_operator(gone); }}, in_step, static_cast<int64_t>(out)};
}

void NetHead::Multiply(const Product& product, int64_t rows, const float* from, float* to) const {
  xnn_setup_fully_connected_nc_f32(product.op.get(), static_cast<size_t>(rows), from, to, threads_);
  xnn_run_operator(product.op.get(), threads_);
}

void NetHead::ComputeWhere(const std::vector<int64_t>& channels, float least) {
  first_channels_ = channels;
  first_ = ProductOf(channels, pixel_step_);
  least_ = least;
  first_results_.resize(channels.size() * static_cast<size_t>(num_pixels_));
}

/// Writes the first channels to where they belong, and says where the others are wanted.
std::vector<int64_t> NetHead::PixelsToCompute() {
  std::vector<int64_t> pixels;
  const float* scores = first_results_.data();
  float* to = output_.data.get();
  for (int64_t pixel = 0; pixel < num_pixels_; ++pixel) {
    bool is_wanted = false;
    for (const int64_t channel : first_channels_) {
      is_wanted |= *scores >= least_;
      to[pixel * out_ + channel] = *scores++;
    }
    if (is_wanted) pixels.push_back(pixel);
  }
  return pixels;
}

void NetHead::Run() {
  float* to = output_.data.get();
  if (!first_.op) return Multiply(all_, num_pixels_, from_, to);
  Multiply(first_, num_pixels_, from_, first_results_.data());
  const std::vector<int64_t> pixels = PixelsToCompute();
  const auto count = static_cast<int64_t>(pixels.size());
  if (count == 0) return;
  if (count > num_pixels_ / 2) return Multiply(all_, num_pixels_, from_, to);
  some_inputs_.resize(static_cast<size_t>((count + 1) * in_));  // XNNPACK reads a little beyond the last row
  some_results_.resize(static_cast<size_t>((count + 1) * out_));
  for (int64_t i = 0; i < count; ++i)
    std::copy_n(from_ + pixels[static_cast<size_t>(i)] * pixel_step_, in_, some_inputs_.data() + i * in_);
  Multiply(some_, count, some_inputs_.data(), some_results_.data());
  for (int64_t i = 0; i < count; ++i)
    std::copy_n(some_results_.data() + i * out_, out_, to + pixels[static_cast<size_t>(i)] * out_);
}

}  // namespace yorb

#else

namespace yorb {

std::shared_ptr<NetHead> NetHead::Of(const NetNode&) { return nullptr; }
void NetHead::ComputeWhere(const std::vector<int64_t>&, float) {}
void NetHead::Run() {}

}  // namespace yorb

#endif
