// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// For tests only: small networks made node by node.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/random.h"
#include "detection/onnx_model.h"

namespace yorb {

inline OnnxAttribute IntsAttribute(const std::string& name, std::vector<int64_t> ints) {
  OnnxAttribute attribute;
  attribute.name = name, attribute.ints = std::move(ints), attribute.type = 7;
  return attribute;
}
inline OnnxAttribute IntAttribute(const std::string& name, int64_t integer) {
  OnnxAttribute attribute;
  attribute.name = name, attribute.integer = integer, attribute.type = 2;
  return attribute;
}
inline OnnxAttribute FloatAttribute(const std::string& name, float number) {
  OnnxAttribute attribute;
  attribute.name = name, attribute.number = number, attribute.type = 1;
  return attribute;
}
inline OnnxAttribute TextAttribute(const std::string& name, const std::string& text) {
  OnnxAttribute attribute;
  attribute.name = name, attribute.text = text, attribute.type = 3;
  return attribute;
}

/// A network in the making; its input is "images", (1, 3, height, width).
class TestNetwork {
 public:
  TestNetwork(int width, int height, int64_t opset = 13) {
    model.ir_version = 7;
    model.opset = opset;
    model.producer = "test";
    model.inputs.push_back({"images", kOnnxFloat, {1, 3, height, width}, true});
  }

  std::string Constant(const std::vector<int64_t>& dims, const std::vector<float>& numbers) {
    OnnxTensor tensor;
    tensor.name = "c" + std::to_string(model.constants.size());
    tensor.dims = dims, tensor.floats = numbers;
    model.constants.push_back(tensor);
    return tensor.name;
  }
  std::string Whole(const std::vector<int64_t>& numbers) {
    OnnxTensor tensor;
    tensor.name = "c" + std::to_string(model.constants.size());
    tensor.dims = {static_cast<int64_t>(numbers.size())}, tensor.is_whole = true, tensor.ints = numbers;
    model.constants.push_back(tensor);
    return tensor.name;
  }
  std::string Random(const std::vector<int64_t>& dims, double scale = 1) {
    int64_t size = 1;
    for (const int64_t dim : dims) size *= dim;
    std::vector<float> numbers;
    for (int64_t i = 0; i < size; ++i) numbers.push_back(static_cast<float>(random.Uniform(-scale, scale)));
    return Constant(dims, numbers);
  }

  std::vector<std::string> Ops(const std::string& op, const std::vector<std::string>& inputs,
                               std::vector<OnnxAttribute> attributes, size_t num_outputs) {
    OnnxNode node;
    node.op = op, node.inputs = inputs, node.attributes = std::move(attributes);
    node.name = "n" + std::to_string(model.nodes.size());
    for (size_t i = 0; i < num_outputs; ++i) node.outputs.push_back(node.name + "_" + std::to_string(i));
    model.nodes.push_back(node);
    return node.outputs;
  }
  std::string Op(const std::string& op, const std::vector<std::string>& inputs,
                 std::vector<OnnxAttribute> attributes = {}) {
    return Ops(op, inputs, std::move(attributes), 1)[0];
  }

  /// A convolution with weights drawn by chance.
  std::string Conv(const std::string& input, int64_t in, int64_t out, int64_t kernel, int64_t stride,
                   int64_t group = 1) {
    const double scale = 1.7 / std::sqrt(static_cast<double>(in / group * kernel * kernel));
    return Op("Conv", {input, Random({out, in / group, kernel, kernel}, scale), Random({out}, 0.2)},
              {IntsAttribute("kernel_shape", {kernel, kernel}), IntsAttribute("strides", {stride, stride}),
               IntsAttribute("pads", {kernel / 2, kernel / 2, kernel / 2, kernel / 2}), IntAttribute("group", group)});
  }

  /// The mean of red minus green minus blue, and of green minus red minus blue, not below 0, in cells of 8x8: (1, 2, h,
  /// w).
  std::string Cells() {
    const std::string mixed = Op("Relu", {Op("Conv", {"images", Constant({2, 3, 1, 1}, {1, -1, -1, -1, 1, -1})},
                                             {IntsAttribute("kernel_shape", {1, 1})})});
    return Op("AveragePool", {mixed}, {IntsAttribute("kernel_shape", {8, 8}), IntsAttribute("strides", {8, 8})});
  }

  std::string Reshaped(const std::string& input, const std::vector<int64_t>& dims) {
    return Op("Reshape", {input, Whole(dims)});
  }

  void Output(const std::string& name, const std::vector<int64_t>& dims) {
    model.outputs.push_back({name, kOnnxFloat, dims, true});
  }
  std::string Bytes() const { return OnnxBytes(model); }

  OnnxModel model;
  yorb::Random random{7};
};

/// How the numbers of a network are changed.
struct TwoColourChange {
  float box_factor = 1, score_factor = 1, score_offset = 0;
};

/// YOLOv8's output for 64x64 px and two classes: a box of its own size for each cell of 8x8; person from red, cup from
/// green. (1, 6, 84), of which the first 64 columns are used.
inline TestNetwork TwoColourNetwork(bool has_names = true, const TwoColourChange& change = {}) {
  TestNetwork net(64, 64);
  std::vector<float> boxes;
  for (int row = 0; row < 4; ++row) {
    for (int i = 0; i < 64; ++i) boxes.push_back(row == 0 ? (i % 8 + .5f) * 8 : row == 1 ? (i / 8 + .5f) * 8 : 8.f);
  }
  for (float& number : boxes) number *= change.box_factor;
  const std::string places = net.Constant({1, 4, 64}, boxes);
  std::string scores = net.Reshaped(net.Cells(), {1, 2, 64});
  if (change.score_factor != 1) scores = net.Op("Mul", {scores, net.Constant({1}, {change.score_factor})});
  if (change.score_offset != 0) scores = net.Op("Add", {scores, net.Constant({1}, {change.score_offset})});
  const std::string used = net.Op("Concat", {places, scores}, {IntAttribute("axis", 1)});
  const std::string all =
      net.Op("Concat", {used, net.Constant({1, 6, 20}, std::vector<float>(120, 0))}, {IntAttribute("axis", 2)});
  net.Output(all, {1, 6, 84});
  if (has_names) net.model.metadata["names"] = "{0: 'person', 1: 'cup'}";
  return net;
}

}  // namespace yorb
