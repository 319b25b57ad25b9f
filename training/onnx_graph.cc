// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/onnx_graph.h"

#include <onnx/onnx_pb.h>

#include "core/check.h"

namespace yorb {
namespace {

using onnx::AttributeProto;
using onnx::NodeProto;
using onnx::TensorProto;

constexpr int kIrVersion = 7, kOperatorSet = 13;

void SetInts(NodeProto& node, const std::string& name, const std::vector<int64_t>& values) {
  AttributeProto& attribute = *node.add_attribute();
  attribute.set_name(name);
  attribute.set_type(AttributeProto::INTS);
  for (const int64_t value : values) attribute.add_ints(value);
}

void SetInt(NodeProto& node, const std::string& name, int64_t value) {
  AttributeProto& attribute = *node.add_attribute();
  attribute.set_name(name);
  attribute.set_type(AttributeProto::INT);
  attribute.set_i(value);
}

void SetFloat(NodeProto& node, const std::string& name, float value) {
  AttributeProto& attribute = *node.add_attribute();
  attribute.set_name(name);
  attribute.set_type(AttributeProto::FLOAT);
  attribute.set_f(value);
}

void SetText(NodeProto& node, const std::string& name, const std::string& value) {
  AttributeProto& attribute = *node.add_attribute();
  attribute.set_name(name);
  attribute.set_type(AttributeProto::STRING);
  attribute.set_s(value);
}

void SetShape(onnx::ValueInfoProto& value, const std::string& name, const std::vector<int64_t>& shape) {
  value.set_name(name);
  auto& type = *value.mutable_type()->mutable_tensor_type();
  type.set_elem_type(TensorProto::FLOAT);
  for (const int64_t size : shape) type.mutable_shape()->add_dim()->set_dim_value(size);
}

}  // namespace

FoldedConv Fold(const ConvNormImpl& conv_norm) {
  const torch::NoGradGuard no_grad;
  const auto& norm = *conv_norm.bn;
  const torch::Tensor scale = norm.weight / (norm.running_var + conv_norm.spec.norm_epsilon).sqrt();
  return {conv_norm.conv->weight * scale.view({-1, 1, 1, 1}), norm.bias - norm.running_mean * scale,
          conv_norm.spec.stride, conv_norm.spec.padding, conv_norm.spec.groups};
}

struct OnnxGraph::State {
  onnx::ModelProto model;
  int num_unnamed = 0;

  onnx::GraphProto& graph() { return *model.mutable_graph(); }

  /// A node whose output has its name.
  NodeProto& Add(const std::string& op, const std::string& name, const std::vector<std::string>& inputs) {
    NodeProto& node = *graph().add_node();
    node.set_op_type(op);
    node.set_name(name);
    for (const std::string& input : inputs) node.add_input(input);
    node.add_output(name);
    return node;
  }

  NodeProto& AddUnnamed(const std::string& op, const std::vector<std::string>& inputs) {
    return Add(op, op + "_" + std::to_string(num_unnamed++), inputs);
  }

  std::string AddWeights(const std::string& name, const torch::Tensor& values) {
    const torch::Tensor plain = values.detach().to(torch::kCPU, torch::kFloat32).contiguous();
    TensorProto& tensor = *graph().add_initializer();
    tensor.set_name(name);
    tensor.set_data_type(TensorProto::FLOAT);
    for (const int64_t size : plain.sizes()) tensor.add_dims(size);
    tensor.set_raw_data(plain.data_ptr<float>(), static_cast<size_t>(plain.numel()) * sizeof(float));
    return name;
  }
};

OnnxGraph::OnnxGraph() : state_(std::make_unique<State>()) {
  state_->model.set_ir_version(kIrVersion);
  state_->model.set_producer_name("yorb-train");
  onnx::OperatorSetIdProto& operators = *state_->model.add_opset_import();
  operators.set_domain("");
  operators.set_version(kOperatorSet);
}

OnnxGraph::~OnnxGraph() = default;

std::string OnnxGraph::Input(const std::string& name, const std::vector<int64_t>& shape) {
  SetShape(*state_->graph().add_input(), name, shape);
  return name;
}

void OnnxGraph::Output(const std::string& value, const std::vector<int64_t>& shape) {
  SetShape(*state_->graph().add_output(), value, shape);
}

void OnnxGraph::Metadata(const std::string& key, const std::string& value) {
  onnx::StringStringEntryProto& entry = *state_->model.add_metadata_props();
  entry.set_key(key);
  entry.set_value(value);
}

std::string OnnxGraph::Conv(const std::string& name, const std::string& in, const FoldedConv& conv) {
  const std::string weight = state_->AddWeights(name + ".weight", conv.weight);
  const std::string bias = state_->AddWeights(name + ".bias", conv.bias);
  NodeProto& node = state_->Add("Conv", name, {in, weight, bias});
  const int64_t padding = conv.padding;
  SetInts(node, "kernel_shape", {conv.weight.size(2), conv.weight.size(3)});
  SetInts(node, "strides", {conv.stride, conv.stride});
  SetInts(node, "pads", {padding, padding, padding, padding});
  SetInts(node, "dilations", {1, 1});
  SetInt(node, "group", conv.groups);
  return name;
}

std::string OnnxGraph::HardSigmoid(const std::string& in) {
  NodeProto& node = state_->AddUnnamed("HardSigmoid", {in});
  SetFloat(node, "alpha", 1.0f / 6.0f);
  SetFloat(node, "beta", 0.5f);
  return node.name();
}

std::string OnnxGraph::Activate(const std::string& in, Activation activation) {
  switch (activation) {
    case Activation::kNone:
      return in;
    case Activation::kRelu:
      return Unary("Relu", in);
    case Activation::kHardSwish:
      return Binary("Mul", in, HardSigmoid(in));
    case Activation::kSilu:
      return Binary("Mul", in, Unary("Sigmoid", in));
  }
  return in;
}

std::string OnnxGraph::Binary(const std::string& op, const std::string& a, const std::string& b) {
  return state_->AddUnnamed(op, {a, b}).name();
}

std::string OnnxGraph::Unary(const std::string& op, const std::string& in) {
  return state_->AddUnnamed(op, {in}).name();
}

std::string OnnxGraph::Concat(const std::vector<std::string>& ins) {
  NodeProto& node = state_->AddUnnamed("Concat", ins);
  SetInt(node, "axis", 1);
  return node.name();
}

std::string OnnxGraph::UpsampleTwice(const std::string& in) {
  const std::string name = "Resize_" + std::to_string(state_->num_unnamed);
  const std::string scales = state_->AddWeights(name + ".scales", torch::tensor({1.0f, 1.0f, 2.0f, 2.0f}));
  NodeProto& node = state_->AddUnnamed("Resize", {in, "", scales});
  SetText(node, "mode", "nearest");
  SetText(node, "nearest_mode", "floor");
  SetText(node, "coordinate_transformation_mode", "asymmetric");
  return node.name();
}

std::string OnnxGraph::MaxPool(const std::string& in, int kernel) {
  NodeProto& node = state_->AddUnnamed("MaxPool", {in});
  const int64_t padding = kernel / 2;
  SetInts(node, "kernel_shape", {kernel, kernel});
  SetInts(node, "strides", {1, 1});
  SetInts(node, "pads", {padding, padding, padding, padding});
  return node.name();
}

std::string OnnxGraph::Bytes(const std::string& graph_name) const {
  state_->graph().set_name(graph_name);
  std::string bytes;
  YORB_CHECK(state_->model.SerializeToString(&bytes), "an ONNX model of a few megabytes can be serialised");
  return bytes;
}

}  // namespace yorb
