// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Operators on pictures, channels next to each other: XNNPACK's where it has them.
#include "detection/net_program.h"

#if defined(YORB_HAS_XNNPACK)
#include <xnnpack.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>

#include "detection/depthwise.h"
#include "detection/winograd.h"

namespace yorb {
namespace {

using Dims = std::vector<int64_t>;

std::shared_ptr<xnn_operator> Owned(xnn_operator_t op) {
  return {op, [](xnn_operator_t gone) { xnn_delete_operator(gone); }};
}

/// Adds an operator of XNNPACK that knows where its numbers lie.
void AddOperator(const NetNode& node, std::shared_ptr<xnn_operator> op) {
  node.Add([op = std::move(op), threads = node.program.threads()] { xnn_run_operator(op.get(), threads); });
}

/// A window that moves over a picture.
struct Window {
  int64_t kernel_y = 1, kernel_x = 1, stride_y = 1, stride_x = 1, dilation_y = 1, dilation_x = 1;
  int64_t top = 0, left = 0, bottom = 0, right = 0;  // padding

  int64_t Height(int64_t input) const {
    return (input + top + bottom - dilation_y * (kernel_y - 1) - 1) / stride_y + 1;
  }
  int64_t Width(int64_t input) const { return (input + left + right - dilation_x * (kernel_x - 1) - 1) / stride_x + 1; }
  bool HasPadding() const { return top > 0 || left > 0 || bottom > 0 || right > 0; }
};

/// Padding as the `auto_pad` of older files asks.
void PadForSame(const NetValue& input, bool is_upper, Window& window) {
  const auto total = [](int64_t size, int64_t stride, int64_t reach) {
    return std::max<int64_t>((((size + stride - 1) / stride) - 1) * stride + reach - size, 0);
  };
  const int64_t y = total(input.dims[2], window.stride_y, window.dilation_y * (window.kernel_y - 1) + 1);
  const int64_t x = total(input.dims[3], window.stride_x, window.dilation_x * (window.kernel_x - 1) + 1);
  window.top = is_upper ? y / 2 : y - y / 2, window.bottom = y - window.top;
  window.left = is_upper ? x / 2 : x - x / 2, window.right = x - window.left;
}

Result<Window> WindowOf(const NetNode& node, const Dims& kernel) {
  const NetValue& input = node.inputs[0];
  const Dims strides = node.node.Integers("strides", {1, 1}), dilations = node.node.Integers("dilations", {1, 1});
  const Dims pads = node.node.Integers("pads", {0, 0, 0, 0});
  if (input.rank() != 4 || kernel.size() != 2 || strides.size() != 2 || dilations.size() != 2 || pads.size() != 4)
    return BadInput(": only pictures of two axes are read");
  Window window{kernel[0],    kernel[1], strides[0], strides[1], dilations[0],
                dilations[1], pads[0],   pads[1],    pads[2],    pads[3]};
  const std::string padding = node.node.Text("auto_pad", "NOTSET");
  if (padding == "SAME_UPPER" || padding == "SAME_LOWER") PadForSame(input, padding == "SAME_UPPER", window);
  const auto are_within = [](int64_t least, const Dims& numbers) {
    constexpr int64_t kMost = 1 << 16;
    return std::all_of(numbers.begin(), numbers.end(), [&](int64_t n) { return n >= least && n <= kMost; });
  };
  const bool is_sound = are_within(1, kernel) && are_within(1, strides) && are_within(1, dilations) &&
                        are_within(0, {window.top, window.left, window.bottom, window.right}) &&
                        input.dims[2] + window.top + window.bottom > window.dilation_y * (window.kernel_y - 1) &&
                        input.dims[3] + window.left + window.right > window.dilation_x * (window.kernel_x - 1);
  if (!is_sound) return BadInput(": its window does not fit its input");
  return window;
}

size_t PixelStep(const NetValue& value) {
  return static_cast<size_t>(value.dims[3] > 1   ? value.strides[3]
                             : value.dims[2] > 1 ? value.strides[2]
                                                 : value.dims[1]);
}

uint32_t U(int64_t number) { return static_cast<uint32_t>(number); }

/// Weights from the order of the file (out, in, y, x) to XNNPACK's (out, y, x, in).
std::vector<float> KernelOf(const NetValue& weights) {
  const std::vector<float> from = NumbersOf(weights);
  const int64_t in = weights.dims[1], area = weights.dims[2] * weights.dims[3];
  std::vector<float> to(from.size());
  for (int64_t out = 0; out < weights.dims[0]; ++out) {
    for (int64_t channel = 0; channel < in; ++channel) {
      for (int64_t i = 0; i < area; ++i)
        to[static_cast<size_t>((out * area + i) * in + channel)] =
            from[static_cast<size_t>((out * in + channel) * area + i)];
    }
  }
  return to;
}

/// A product of a matrix of rows with weights, as XNNPACK makes it.
struct RowProduct {
  int64_t rows = 0, in = 0, out = 0;
};
std::shared_ptr<xnn_operator> ProductOf(const RowProduct& size, const float* weights, const float* from, float* to,
                                        pthreadpool* threads) {
  const auto in = static_cast<size_t>(size.in), out = static_cast<size_t>(size.out);
  xnn_operator_t op = nullptr;
  const xnn_status made =
      xnn_create_fully_connected_nc_f32(in, out, in, out, weights, nullptr, -HUGE_VALF, HUGE_VALF, 0, &op);
  if (made != xnn_status_success) return nullptr;
  auto owned = Owned(op);
  const xnn_status ready = xnn_setup_fully_connected_nc_f32(op, static_cast<size_t>(size.rows), from, to, threads);
  return ready == xnn_status_success ? owned : nullptr;
}

/// Whether a convolution is one for Winograd's way, and large enough to pay for the way there and back.
bool IsForWinograd(const NetNode& node, const NetValue& input, const Window& window) {
  constexpr int64_t kLeastChannels = 32;
  const bool is_plain = window.kernel_y == 3 && window.kernel_x == 3 && window.stride_y == 1 && window.stride_x == 1 &&
                        window.dilation_y == 1 && window.dilation_x == 1 && window.top == 1 && window.left == 1 &&
                        window.bottom == 1 && window.right == 1;
  return is_plain && input.dims[0] == 1 && node.node.Integer("group", 1) == 1 && input.dims[1] >= kLeastChannels &&
         node.inputs[1].dims[0] >= kLeastChannels;
}

NetOutputs WinogradConvolution(const NetNode& node, const NetValue& input) {
  const NetValue& weights = node.inputs[1];
  const WinogradSize size{input.dims[2],
                          input.dims[3],
                          input.dims[1],
                          weights.dims[0],
                          static_cast<int64_t>(PixelStep(input)),
                          BestWinogradTile(input.dims[2], input.dims[3])};
  const std::vector<float> turned = WinogradWeights(NumbersOf(weights), size);
  const NetValue patches = node.New({size.num_products(), size.num_tiles(), size.in_channels});
  const NetValue products = node.New({size.num_products(), size.num_tiles(), size.out_channels});
  NetValue output = node.New({1, size.out_channels, size.height, size.width}, NetLayout::kChannelsLast);
  const RowProduct product{size.num_tiles(), size.in_channels, size.out_channels};
  std::vector<std::shared_ptr<xnn_operator>> operators;
  for (int64_t k = 0; k < size.num_products(); ++k) {
    operators.push_back(ProductOf(product, turned.data() + k * product.in * product.out,
                                  patches.data.get() + k * product.rows * product.in,
                                  products.data.get() + k * product.rows * product.out, node.program.threads()));
    if (!operators.back()) return BadInput(": XNNPACK does not take its sizes");
  }
  const std::vector<float> bias =
      node.Has(2) ? NumbersOf(node.inputs[2]) : std::vector<float>(static_cast<size_t>(size.out_channels), 0.f);
  node.Add([=, least = node.least, most = node.most, threads = node.program.threads(), from = input.data.get(),
            to = output.data.get(), in_patches = patches.data.get(), in_products = products.data.get()] {
    WinogradInput(size, from, in_patches);
    for (const auto& op : operators) xnn_run_operator(op.get(), threads);
    WinogradOutput(size, in_products, {bias.data(), least, most}, to);
  });
  return One(std::move(output));
}

/// The size of a convolution of each channel by itself; nothing where it is another one.
std::optional<DepthwiseSize> DepthwiseSizeOf(const NetNode& node, const NetValue& input, const Window& window) {
  const NetValue& weights = node.inputs[1];
  const bool is_depthwise = weights.dims[1] == 1 && weights.dims[0] == input.dims[1] && input.dims[0] == 1 &&
                            window.kernel_y == window.kernel_x && window.stride_y == window.stride_x &&
                            window.dilation_y == 1 && window.dilation_x == 1;
  if (!is_depthwise) return std::nullopt;
  const DepthwiseSize size{input.dims[2],
                           input.dims[3],
                           input.dims[1],
                           static_cast<int64_t>(PixelStep(input)),
                           window.Height(input.dims[2]),
                           window.Width(input.dims[3]),
                           window.kernel_y,
                           window.stride_y,
                           window.top,
                           window.left};
  return IsForDepthwise(size) ? std::optional(size) : std::nullopt;
}

NetOutputs DepthwiseConvolution(const NetNode& node, const NetValue& input, const DepthwiseSize& size) {
  const std::vector<float> bias = node.Has(2) ? NumbersOf(node.inputs[2]) : std::vector<float>();
  const auto convolution = std::make_shared<Depthwise>(size, NumbersOf(node.inputs[1]), bias, node.least, node.most);
  NetValue output = node.New({1, size.channels, size.out_height, size.out_width}, NetLayout::kChannelsLast);
  node.Add([convolution, from = input.data.get(), to = output.data.get()] { convolution->Run(from, to); });
  return One(std::move(output));
}

NetOutputs Convolution(const NetNode& node) {
  if (!node.Has(1) || !node.inputs[1].is_constant || node.inputs[1].rank() != 4)
    return BadInput(": its weights are not known beforehand");
  if (node.Has(2) && !node.inputs[2].is_constant) return BadInput(": its bias is not known beforehand");
  const NetValue& weights = node.inputs[1];
  const auto window = WindowOf(node, {weights.dims[2], weights.dims[3]});
  if (!window) return window.error();
  const NetValue input = WithLayout(node, node.inputs[0], NetLayout::kChannelsLast);
  const int64_t groups = node.node.Integer("group", 1), num_out = weights.dims[0];
  if (groups < 1 || num_out % groups != 0 || weights.dims[1] * groups != input.dims[1])
    return BadInput(": its weights do not fit its input");
  const std::vector<float> bias = node.Has(2) ? NumbersOf(node.inputs[2]) : std::vector<float>();
  if (!bias.empty() && static_cast<int64_t>(bias.size()) != num_out)
    return BadInput(": its bias does not fit its weights");
  if (IsForWinograd(node, input, *window)) return WinogradConvolution(node, input);
  if (const auto size = DepthwiseSizeOf(node, input, *window)) return DepthwiseConvolution(node, input, *size);
  NetValue output = node.New({input.dims[0], num_out, window->Height(input.dims[2]), window->Width(input.dims[3])},
                             NetLayout::kChannelsLast);
  const std::vector<float> kernel = KernelOf(weights);
  xnn_operator_t op = nullptr;
  const xnn_status made = xnn_create_convolution2d_nhwc_f32(
      U(window->top), U(window->right), U(window->bottom), U(window->left), U(window->kernel_y), U(window->kernel_x),
      U(window->stride_y), U(window->stride_x), U(window->dilation_y), U(window->dilation_x), U(groups),
      static_cast<size_t>(weights.dims[1]), static_cast<size_t>(num_out / groups), PixelStep(input),
      static_cast<size_t>(num_out), kernel.data(), bias.empty() ? nullptr : bias.data(), node.least, node.most, 0, &op);
  if (made != xnn_status_success) return BadInput(": XNNPACK does not take its settings");
  const auto owned = Owned(op);
  const xnn_status ready = xnn_setup_convolution2d_nhwc_f32(
      op, static_cast<size_t>(input.dims[0]), static_cast<size_t>(input.dims[2]), static_cast<size_t>(input.dims[3]),
      input.data.get(), output.data.get(), node.program.threads());
  if (ready != xnn_status_success) return BadInput(": XNNPACK does not take its sizes");
  AddOperator(node, owned);
  return One(std::move(output));
}

/// The weights of a transposed convolution, from the order of the file (in, out, y, x) to XNNPACK's (out, y, x, in).
std::vector<float> TransposedKernelOf(const NetValue& weights) {
  const std::vector<float> from = NumbersOf(weights);
  const int64_t in = weights.dims[0], rest = weights.dims[1] * weights.dims[2] * weights.dims[3];
  std::vector<float> to(from.size());
  for (int64_t channel = 0; channel < in; ++channel) {
    for (int64_t i = 0; i < rest; ++i)
      to[static_cast<size_t>(i * in + channel)] = from[static_cast<size_t>(channel * rest + i)];
  }
  return to;
}

/// Convolutions that enlarge a picture: the masks of segmentation networks have one.
NetOutputs TransposedConvolution(const NetNode& node) {
  if (!node.Has(1) || !node.inputs[1].is_constant || node.inputs[1].rank() != 4 ||
      (node.Has(2) && !node.inputs[2].is_constant))
    return BadInput(": its weights are not known beforehand");
  const NetValue& weights = node.inputs[1];
  const auto window = WindowOf(node, {weights.dims[2], weights.dims[3]});
  if (!window) return window.error();
  const NetValue input = WithLayout(node, node.inputs[0], NetLayout::kChannelsLast);
  const Dims extra = node.node.Integers("output_padding", {0, 0});
  const bool is_plain = node.node.Integer("group", 1) == 1 && node.node.Find("output_shape") == nullptr &&
                        node.node.Text("auto_pad", "NOTSET") == "NOTSET" && extra == Dims{0, 0};
  if (!is_plain || weights.dims[0] != input.dims[1]) return BadInput(": it is of a kind that is not read");
  const auto enlarged = [](int64_t size, int64_t stride, int64_t reach, int64_t pads) {
    return (size - 1) * stride + reach - pads;
  };
  const int64_t height = enlarged(input.dims[2], window->stride_y, window->dilation_y * (window->kernel_y - 1) + 1,
                                  window->top + window->bottom),
                width = enlarged(input.dims[3], window->stride_x, window->dilation_x * (window->kernel_x - 1) + 1,
                                 window->left + window->right);
  if (height < 1 || width < 1) return BadInput(": nothing is left");
  NetValue output = node.New({input.dims[0], weights.dims[1], height, width}, NetLayout::kChannelsLast);
  const std::vector<float> kernel = TransposedKernelOf(weights),
                           bias = node.Has(2) ? NumbersOf(node.inputs[2]) : std::vector<float>();
  if (!bias.empty() && static_cast<int64_t>(bias.size()) != weights.dims[1])
    return BadInput(": its bias does not fit its weights");
  const auto in = static_cast<size_t>(weights.dims[0]), out = static_cast<size_t>(weights.dims[1]);
  xnn_operator_t op = nullptr;
  const xnn_status made = xnn_create_deconvolution2d_nhwc_f32(
      U(window->top), U(window->right), U(window->bottom), U(window->left), U(window->kernel_y), U(window->kernel_x),
      U(window->stride_y), U(window->stride_x), U(window->dilation_y), U(window->dilation_x), 1, in, out,
      PixelStep(input), out, kernel.data(), bias.empty() ? nullptr : bias.data(), node.least, node.most, 0, &op);
  if (made != xnn_status_success) return BadInput(": XNNPACK does not take its settings");
  const auto owned = Owned(op);
  const xnn_status ready = xnn_setup_deconvolution2d_nhwc_f32(
      op, static_cast<size_t>(input.dims[0]), static_cast<size_t>(input.dims[2]), static_cast<size_t>(input.dims[3]), 0,
      0, input.data.get(), output.data.get(), node.program.threads());
  if (ready != xnn_status_success) return BadInput(": XNNPACK does not take its sizes");
  AddOperator(node, owned);
  return One(std::move(output));
}

/// MaxPool and AveragePool.
NetOutputs Pooling(const NetNode& node) {
  const auto window = WindowOf(node, node.node.Integers("kernel_shape", {}));
  if (!window) return window.error();
  const NetValue input = WithLayout(node, node.inputs[0], NetLayout::kChannelsLast);
  const bool is_max = node.node.op == "MaxPool";
  const int64_t height = window->Height(input.dims[2]), width = window->Width(input.dims[3]);
  const auto leaves_rest = [](int64_t size, int64_t reach, int64_t stride) { return (size - reach) % stride != 0; };
  const bool has_rest = leaves_rest(input.dims[2] + window->top + window->bottom,
                                    window->dilation_y * (window->kernel_y - 1) + 1, window->stride_y) ||
                        leaves_rest(input.dims[3] + window->left + window->right,
                                    window->dilation_x * (window->kernel_x - 1) + 1, window->stride_x);
  if (node.node.Integer("ceil_mode", 0) != 0 && has_rest) return BadInput(": it rounds sizes up");
  if (!is_max && window->HasPadding() && node.node.Integer("count_include_pad", 0) != 0)
    return BadInput(": it counts its padding");
  if (window->kernel_y * window->kernel_x == 1 && window->stride_y * window->stride_x == 1) return One(input);
  NetValue output = node.New({input.dims[0], input.dims[1], height, width}, NetLayout::kChannelsLast);
  const auto channels = static_cast<size_t>(input.dims[1]), batch = static_cast<size_t>(input.dims[0]);
  const auto rows = static_cast<size_t>(input.dims[2]), columns = static_cast<size_t>(input.dims[3]);
  xnn_operator_t op = nullptr;
  xnn_status status =
      is_max ? xnn_create_max_pooling2d_nhwc_f32(U(window->top), U(window->right), U(window->bottom), U(window->left),
                                                 U(window->kernel_y), U(window->kernel_x), U(window->stride_y),
                                                 U(window->stride_x), U(window->dilation_y), U(window->dilation_x),
                                                 channels, PixelStep(input), channels, -HUGE_VALF, HUGE_VALF, 0, &op)
             : xnn_create_average_pooling2d_nhwc_f32(U(window->top), U(window->right), U(window->bottom),
                                                     U(window->left), U(window->kernel_y), U(window->kernel_x),
                                                     U(window->stride_y), U(window->stride_x), channels,
                                                     PixelStep(input), channels, -HUGE_VALF, HUGE_VALF, 0, &op);
  if (status != xnn_status_success) return BadInput(": XNNPACK does not take its settings");
  const auto owned = Owned(op);
  status = is_max ? xnn_setup_max_pooling2d_nhwc_f32(op, batch, rows, columns, input.data.get(), output.data.get(),
                                                     node.program.threads())
                  : xnn_setup_average_pooling2d_nhwc_f32(op, batch, rows, columns, input.data.get(), output.data.get(),
                                                         node.program.threads());
  if (status != xnn_status_success) return BadInput(": XNNPACK does not take its sizes");
  AddOperator(node, owned);
  return One(std::move(output));
}

/// The mean of each channel.
NetOutputs GlobalAverage(const NetNode& node) {
  const NetValue input = WithLayout(node, node.inputs[0], NetLayout::kChannelsLast);
  NetValue output = node.New({input.dims[0], input.dims[1], 1, 1}, NetLayout::kChannelsLast);
  const auto channels = static_cast<size_t>(input.dims[1]);
  xnn_operator_t op = nullptr;
  if (xnn_create_global_average_pooling_nwc_f32(channels, PixelStep(input), channels, -HUGE_VALF, HUGE_VALF, 0, &op) !=
      xnn_status_success)
    return BadInput(": XNNPACK does not take its settings");
  const auto owned = Owned(op);
  const xnn_status ready = xnn_setup_global_average_pooling_nwc_f32(
      op, static_cast<size_t>(input.dims[0]), static_cast<size_t>(input.dims[2] * input.dims[3]), input.data.get(),
      output.data.get(), node.program.threads());
  if (ready != xnn_status_success) return BadInput(": XNNPACK does not take its sizes");
  AddOperator(node, owned);
  return One(std::move(output));
}

/// Whether a mean is that of whole pictures, which keeps their axes.
bool IsGlobalMean(const NetNode& node) {
  if (node.node.op == "GlobalAveragePool") return node.Has(0) && node.inputs[0].rank() == 4;
  if (node.node.op != "ReduceMean" || !node.Has(0) || node.inputs[0].rank() != 4 ||
      node.node.Integer("keepdims", 1) == 0)
    return false;
  auto axes = node.Integers("axes", 1);
  if (!axes || axes->size() != 2) return false;
  for (int64_t& axis : *axes) axis += axis < 0 ? 4 : 0;
  std::sort(axes->begin(), axes->end());
  return *axes == Dims{2, 3};
}

/// Each pixel becomes a block.
NetOutputs Enlargement(const NetNode& node) {
  const auto factors = EnlargementOf(node);
  if (!factors) return factors.error();
  const auto [by_y, by_x] = *factors;
  const NetValue input = WithLayout(node, node.inputs[0], NetLayout::kChannelsLast);
  NetValue output =
      node.New({input.dims[0], input.dims[1], input.dims[2] * by_y, input.dims[3] * by_x}, NetLayout::kChannelsLast);
  const int64_t rows = input.dims[0] * input.dims[2], columns = input.dims[3], channels = input.dims[1];
  const auto pixel = static_cast<int64_t>(PixelStep(input));
  node.Add([=, to = output.data.get(), from = input.data.get(), up_y = by_y, up_x = by_x] {
    const int64_t row_size = columns * up_x * channels;
    for (int64_t y = 0; y < rows; ++y) {
      float* row = to + y * up_y * row_size;
      for (int64_t x = 0; x < columns * up_x; ++x)
        std::memcpy(row + x * channels, from + (y * columns + x / up_x) * pixel,
                    static_cast<size_t>(channels) * sizeof(float));
      for (int64_t again = 1; again < up_y; ++again)
        std::memcpy(row + again * row_size, row, static_cast<size_t>(row_size) * sizeof(float));
    }
  });
  return One(std::move(output));
}

}  // namespace

bool PrepareKernels() { return xnn_initialize(nullptr) == xnn_status_success; }

NetOutputs AddPictureOperator(const NetNode& node) {
  const std::string& op = node.node.op;
  if (!node.Has(0)) return NotMine();
  if (op == "Conv") return Convolution(node);
  if (op == "ConvTranspose") return TransposedConvolution(node);
  if (op == "MaxPool" || op == "AveragePool") return Pooling(node);
  if (op == "Resize" || op == "Upsample") return Enlargement(node);
  if (IsGlobalMean(node)) return GlobalAverage(node);
  return NotMine();
}

}  // namespace yorb

#else

namespace yorb {

bool PrepareKernels() { return true; }

NetOutputs AddPictureOperator(const NetNode&) { return NotMine(); }

}  // namespace yorb

#endif
