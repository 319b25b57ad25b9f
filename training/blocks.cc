// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/blocks.h"

#include "training/half_width.h"

namespace yorb {
namespace {

namespace nn = torch::nn;

ConvSpec Pointwise(int in, int out, const LayerSpec& row, Activation activation) {
  return {.in = in, .out = out, .activation = activation, .norm_epsilon = row.norm_epsilon};
}

/// A convolution outside of autocast: oneDNN 2.6 differentiates wide depth-wise ones in bfloat16 two to three times
/// slower than in float.
torch::Tensor ConvolveInFloat(nn::Conv2d& conv, const torch::Tensor& x) {
  const HalfWidth full(torch::kCPU, false);
  return conv(x.to(torch::kFloat32)).to(torch::kBFloat16);
}

nn::Conv2d PlainConv(int in, int out) { return nn::Conv2d(nn::Conv2dOptions(in, out, 1)); }

}  // namespace

torch::Tensor Activate(const torch::Tensor& x, Activation activation) {
  switch (activation) {
    case Activation::kNone:
      return x;
    case Activation::kRelu:
      return torch::relu(x);
    case Activation::kHardSwish:
      return torch::hardswish(x);
    case Activation::kSilu:
      return torch::silu(x);
  }
  return x;
}

ConvNormImpl::ConvNormImpl(const ConvSpec& conv_spec) : spec(conv_spec) {
  auto options = nn::Conv2dOptions(spec.in, spec.out, spec.kernel);
  options.stride(spec.stride).padding(spec.padding).groups(spec.groups).bias(false);
  conv = register_module("conv", nn::Conv2d(options));
  bn = register_module("bn", nn::BatchNorm2d(nn::BatchNorm2dOptions(spec.out).eps(spec.norm_epsilon).momentum(0.03)));
}

torch::Tensor ConvNormImpl::forward(const torch::Tensor& x) {
  const bool is_slow_in_half = spec.groups > 1 && spec.kernel > 3 && x.is_cpu() && IsHalfWidth(torch::kCPU);
  const torch::Tensor y = is_slow_in_half ? ConvolveInFloat(conv, x) : conv(x);
  if (takes_statistics) TakeStatistics(y);
  return Activate(bn(y), spec.activation);
}

void ConvNormImpl::HoldFolded() {
  const torch::NoGradGuard no_grad;
  bn->weight.fill_(1);
  bn->bias.zero_();
  bn->running_mean.zero_();
  bn->running_var.fill_(1 - spec.norm_epsilon);
}

void ConvNormImpl::TakeStatistics(const torch::Tensor& y) {
  const torch::NoGradGuard no_grad;
  const auto deviation = [&](const torch::Tensor& variance) { return (variance + spec.norm_epsilon).sqrt(); };
  const torch::Tensor mean = y.mean({0, 2, 3}), variance = y.var(c10::IntArrayRef{0, 2, 3}, false);
  const torch::Tensor scale = bn->weight / deviation(bn->running_var);
  bn->bias += scale * (mean - bn->running_mean);
  bn->weight.copy_(scale * deviation(variance));
  bn->running_mean.copy_(mean);
  bn->running_var.copy_(variance);
}

SqueezeExciteImpl::SqueezeExciteImpl(int channels) {
  const int squeezed = MakeDivisible(channels / 4.0);
  fc1 = register_module("fc1", PlainConv(channels, squeezed));
  fc2 = register_module("fc2", PlainConv(squeezed, channels));
}

torch::Tensor SqueezeExciteImpl::forward(const torch::Tensor& x) {
  const torch::Tensor mean = x.mean({2, 3}, true);
  return x * torch::hardsigmoid(fc2(torch::relu(fc1(mean))));
}

ConvRow::ConvRow(const LayerSpec& spec, int in) {
  conv_norm = ConvNorm(ConvSpec{.in = in,
                                .out = spec.out,
                                .kernel = spec.kernel,
                                .stride = spec.stride,
                                .padding = spec.padding,
                                .activation = spec.activation,
                                .norm_epsilon = spec.norm_epsilon});
  // The convolution stands directly in the row ("0.conv.weight"), as in the ImageNet weights.
  register_module("conv", conv_norm->conv);
  register_module("bn", conv_norm->bn);
}

torch::Tensor ConvRow::Run(const std::vector<torch::Tensor>& inputs) { return conv_norm(inputs.front()); }

MobileBlock::MobileBlock(const LayerSpec& spec, int in) : has_shortcut(spec.stride == 1 && in == spec.out) {
  if (spec.hidden != in)
    expand = register_module("expand", ConvNorm(Pointwise(in, spec.hidden, spec, spec.activation)));
  dw = register_module("dw", ConvNorm(ConvSpec{.in = spec.hidden,
                                               .out = spec.hidden,
                                               .kernel = spec.kernel,
                                               .stride = spec.stride,
                                               .padding = spec.padding,
                                               .groups = spec.hidden,
                                               .activation = spec.activation,
                                               .norm_epsilon = spec.norm_epsilon}));
  if (spec.has_se) se = register_module("se", SqueezeExcite(spec.hidden));
  project = register_module("project", ConvNorm(Pointwise(spec.hidden, spec.out, spec, Activation::kNone)));
}

torch::Tensor MobileBlock::Run(const std::vector<torch::Tensor>& inputs) {
  torch::Tensor x = inputs.front();
  if (expand) x = expand(x);
  x = dw(x);
  if (se) x = se(x);
  x = project(x);
  return has_shortcut ? x + inputs.front() : x;
}

BottleneckImpl::BottleneckImpl(int channels, const LayerSpec& spec) : has_shortcut(spec.has_shortcut) {
  ConvSpec second = Pointwise(channels, channels, spec, spec.activation);
  second.kernel = 3;
  second.padding = 1;
  cv1 = register_module("cv1", ConvNorm(Pointwise(channels, channels, spec, spec.activation)));
  cv2 = register_module("cv2", ConvNorm(second));
}

torch::Tensor BottleneckImpl::forward(const torch::Tensor& x) {
  const torch::Tensor y = cv2(cv1(x));
  return has_shortcut ? x + y : y;
}

C3Row::C3Row(const LayerSpec& spec, int in) {
  const int half = spec.out / 2;
  cv1 = register_module("cv1", ConvNorm(Pointwise(in, half, spec, spec.activation)));
  cv2 = register_module("cv2", ConvNorm(Pointwise(in, half, spec, spec.activation)));
  cv3 = register_module("cv3", ConvNorm(Pointwise(2 * half, spec.out, spec, spec.activation)));
  for (int i = 0; i < spec.repeats; ++i)
    bottlenecks.push_back(register_module("bottleneck" + std::to_string(i), Bottleneck(half, spec)));
}

torch::Tensor C3Row::Run(const std::vector<torch::Tensor>& inputs) {
  torch::Tensor x = cv1(inputs.front());
  for (Bottleneck& bottleneck : bottlenecks) x = bottleneck(x);
  return cv3(torch::cat({x, cv2(inputs.front())}, 1));
}

SppfRow::SppfRow(const LayerSpec& spec, int in) : kernel(spec.kernel) {
  cv1 = register_module("cv1", ConvNorm(Pointwise(in, in / 2, spec, spec.activation)));
  cv2 = register_module("cv2", ConvNorm(Pointwise(in / 2 * 4, spec.out, spec, spec.activation)));
}

torch::Tensor SppfRow::Run(const std::vector<torch::Tensor>& inputs) {
  std::vector<torch::Tensor> parts{cv1(inputs.front())};
  for (int i = 0; i < 3; ++i) parts.push_back(torch::max_pool2d(parts.back(), kernel, 1, kernel / 2));
  return cv2(torch::cat(parts, 1));
}

torch::Tensor UpsampleRow::Run(const std::vector<torch::Tensor>& inputs) {
  return torch::upsample_nearest2d(inputs.front(), c10::nullopt, c10::ArrayRef<double>({2.0, 2.0}));
}

}  // namespace yorb
