// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/network.h"

#include <torch/script.h>

#include <cmath>

namespace yorb {
namespace {

using Kind = LayerSpec::Kind;

std::shared_ptr<RowImpl> MakeRow(const LayerSpec& spec, int in) {
  switch (spec.kind) {
    case Kind::kConv:
      return std::make_shared<ConvRow>(spec, in);
    case Kind::kMobileBlock:
      return std::make_shared<MobileBlock>(spec, in);
    case Kind::kC3:
      return std::make_shared<C3Row>(spec, in);
    case Kind::kSppf:
      return std::make_shared<SppfRow>(spec, in);
    case Kind::kUpsample:
      return std::make_shared<UpsampleRow>();
    case Kind::kConcat:
      return std::make_shared<ConcatRow>();
  }
  return nullptr;
}

/// Biases from which training begins: about eight things of 640 x 640 px, all classes rare.
void SetPriors(torch::nn::Conv2d& head, int stride, int num_classes) {
  const torch::NoGradGuard no_grad;
  torch::Tensor bias = head->bias.view({3, -1});
  bias.slice(1, 4, 5) += std::log(8.0 / ((640.0 / stride) * (640.0 / stride)));
  bias.slice(1, 5) += std::log(0.6 / (num_classes - 0.99));
}

/// Three values as a tensor that goes with pictures, or with the weights that read them.
torch::Tensor PerChannel(const std::array<float, 3>& values, const torch::TensorOptions& options) {
  return torch::tensor({values[0], values[1], values[2]}, options).view({1, 3, 1, 1});
}

}  // namespace

NetworkImpl::NetworkImpl(const Layout& network_layout) : layout(network_layout) {
  const std::vector<int> channels = OutChannels(layout);
  for (size_t i = 0; i < layout.rows.size(); ++i) {
    const int from = layout.rows[i].from.front();
    const int in = i == 0 ? 3 : channels[from < 0 ? i - 1 : static_cast<size_t>(from)];
    LayerSpec spec = layout.rows[i];
    if (i == 0) spec.padding = 0;  // the picture is padded before it is normalised, see forward
    rows.push_back(MakeRow(spec, in));
    register_module(std::to_string(i), std::static_pointer_cast<torch::nn::Module>(rows.back()));
  }
  for (size_t level = 0; level < 3; ++level) {
    const int in = channels[static_cast<size_t>(layout.detect_from[level])];
    heads[level] = torch::nn::Conv2d(torch::nn::Conv2dOptions(in, layout.NumHeadChannels(), 1));
    SetPriors(heads[level], layout.strides[level], layout.num_classes);
    register_module("detect" + std::to_string(level), heads[level]);
  }
}

std::array<torch::Tensor, 3> NetworkImpl::forward(const torch::Tensor& pictures) {
  // Padded with black, not with the mean, so that the normalisation can be folded into the first convolution exactly.
  const int64_t padding = layout.rows.front().padding;
  const torch::Tensor padded = torch::constant_pad_nd(pictures, {padding, padding, padding, padding});
  std::vector<torch::Tensor> outputs{rows.front()->Run({NormalizePictures(padded)})};
  for (size_t i = 1; i < rows.size(); ++i) {
    std::vector<torch::Tensor> inputs;
    for (const int from : layout.rows[i].from) inputs.push_back(outputs[from < 0 ? i - 1 : static_cast<size_t>(from)]);
    outputs.push_back(rows[i]->Run(inputs));
  }
  std::array<torch::Tensor, 3> maps;
  for (size_t level = 0; level < 3; ++level)
    maps[level] = heads[level](outputs[static_cast<size_t>(layout.detect_from[level])]);
  return maps;
}

std::vector<torch::Tensor> NetworkImpl::BackboneParameters() const {
  std::vector<torch::Tensor> parameters;
  for (int i = 0; i < layout.num_backbone_rows; ++i) {
    const std::vector<torch::Tensor> own = rows[static_cast<size_t>(i)]->parameters();
    parameters.insert(parameters.end(), own.begin(), own.end());
  }
  return parameters;
}

Status LoadBackbone(const std::string& path, Network network) {
  torch::OrderedDict<std::string, torch::Tensor> found;
  try {
    const torch::jit::Module archive = torch::jit::load(path);
    for (const auto& item : archive.named_parameters()) found.insert(item.name, item.value);
    for (const auto& item : archive.named_buffers()) found.insert(item.name, item.value);
  } catch (const std::exception&) {
    return BadInput(path + ": cannot be read as a TorchScript archive of weights; --backbone names the file");
  }
  const torch::NoGradGuard no_grad;
  auto own = network->named_parameters();
  for (const auto& item : network->named_buffers()) own.insert(item.key(), item.value());
  for (auto& item : own) {
    const std::string& name = item.key();
    const bool is_backbone = std::isdigit(static_cast<unsigned char>(name[0])) &&
                             std::stoi(name.substr(0, name.find('.'))) < network->layout.num_backbone_rows;
    if (!is_backbone || name.ends_with("num_batches_tracked")) continue;
    const torch::Tensor* tensor = found.find(name);
    if (tensor == nullptr || tensor->sizes() != item.value().sizes())
      return BadInput(path + ": the tensor " + name + " is missing or has another shape; " + network->layout.name +
                      " wants the weights of MobileNetV3-small");
    item.value().copy_(*tensor);
  }
  return Status::Ok();
}

std::array<float, 3> PictureMean() { return {0.485f, 0.456f, 0.406f}; }
std::array<float, 3> PictureDeviation() { return {0.229f, 0.224f, 0.225f}; }

torch::Tensor NormalizePictures(const torch::Tensor& pictures) {
  const torch::TensorOptions options = pictures.options();
  return (pictures - PerChannel(PictureMean(), options)) / PerChannel(PictureDeviation(), options);
}

void UnfoldNormalisation(Network network) {
  const torch::NoGradGuard no_grad;
  ConvNormImpl& first = *dynamic_cast<ConvRow&>(*network->rows.front()).conv_norm;
  torch::Tensor weight = first.conv->weight, bias = first.bn->bias;
  bias += (weight * PerChannel(PictureMean(), weight.options())).sum({1, 2, 3});
  weight *= PerChannel(PictureDeviation(), weight.options());
}

}  // namespace yorb
