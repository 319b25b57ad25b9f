// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstring>
#include <string_view>

#include "detection/onnx_model.h"

namespace yorb {
namespace {

/// A message in the making.
class ProtoWriter {
 public:
  void Integer(uint32_t id, int64_t value) {
    Varint(static_cast<uint64_t>(id) << 3);
    Varint(static_cast<uint64_t>(value));
  }
  void Number(uint32_t id, float value) {
    Varint(static_cast<uint64_t>(id) << 3 | 5);
    char bytes[sizeof(value)];
    std::memcpy(bytes, &value, sizeof(value));
    bytes_.append(bytes, sizeof(value));
  }
  void Bytes(uint32_t id, std::string_view bytes) {
    Varint(static_cast<uint64_t>(id) << 3 | 2);
    Varint(bytes.size());
    bytes_.append(bytes);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  void Varint(uint64_t value) {
    for (; value >= 0x80; value >>= 7) bytes_ += static_cast<char>(value | 0x80);
    bytes_ += static_cast<char>(value);
  }

  std::string bytes_;
};

template <typename T>
std::string_view RawOf(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

std::string TensorBytes(const OnnxTensor& tensor) {
  ProtoWriter writer;
  for (const int64_t dim : tensor.dims) writer.Integer(1, dim);
  // Quantised numbers keep their type, which says how far they reach.
  const bool is_short = tensor.is_whole && tensor.type >= kOnnxUint8 && tensor.type <= kOnnxInt16;
  writer.Integer(2, is_short ? tensor.type : tensor.is_whole ? kOnnxInt64 : kOnnxFloat);
  writer.Bytes(8, tensor.name);
  if (is_short) {
    for (const int64_t number : tensor.ints) writer.Integer(5, number);
    return writer.bytes();
  }
  writer.Bytes(9, tensor.is_whole ? RawOf(tensor.ints) : RawOf(tensor.floats));
  return writer.bytes();
}

std::string AttributeBytes(const OnnxAttribute& attribute) {
  enum AttributeType { kFloat = 1, kInt = 2, kString = 3, kTensor = 4, kFloats = 6, kInts = 7 };
  ProtoWriter writer;
  writer.Bytes(1, attribute.name);
  if (attribute.type == kFloat) writer.Number(2, attribute.number);
  if (attribute.type == kInt) writer.Integer(3, attribute.integer);
  if (attribute.type == kString) writer.Bytes(4, attribute.text);
  if (attribute.type == kTensor && attribute.tensor) writer.Bytes(5, TensorBytes(*attribute.tensor));
  if (attribute.type == kFloats) {
    for (const float value : attribute.floats) writer.Number(7, value);
  }
  if (attribute.type == kInts) {
    for (const int64_t value : attribute.ints) writer.Integer(8, value);
  }
  writer.Integer(20, attribute.type);
  return writer.bytes();
}

std::string NodeBytes(const OnnxNode& node) {
  ProtoWriter writer;
  for (const std::string& name : node.inputs) writer.Bytes(1, name);
  for (const std::string& name : node.outputs) writer.Bytes(2, name);
  writer.Bytes(3, node.name);
  writer.Bytes(4, node.op);
  for (const OnnxAttribute& attribute : node.attributes) writer.Bytes(5, AttributeBytes(attribute));
  if (!node.domain.empty()) writer.Bytes(7, node.domain);
  return writer.bytes();
}

std::string ValueBytes(const OnnxValue& value) {
  ProtoWriter shape;
  for (size_t i = 0; i < value.dims.size(); ++i) {
    ProtoWriter dim;
    if (value.dims[i] >= 0) dim.Integer(1, value.dims[i]);
    if (value.dims[i] < 0) dim.Bytes(2, "size" + std::to_string(i));
    shape.Bytes(1, dim.bytes());
  }
  ProtoWriter tensor, type, writer;
  tensor.Integer(1, value.type == kOnnxUint8 ? kOnnxUint8 : kOnnxFloat);
  if (value.has_shape) tensor.Bytes(2, shape.bytes());
  type.Bytes(1, tensor.bytes());
  writer.Bytes(1, value.name);
  writer.Bytes(2, type.bytes());
  return writer.bytes();
}

}  // namespace

std::string OnnxBytes(const OnnxModel& model) {
  ProtoWriter graph, opset, writer;
  for (const OnnxNode& node : model.nodes) graph.Bytes(1, NodeBytes(node));
  graph.Bytes(2, "graph");
  for (const OnnxTensor& tensor : model.constants) graph.Bytes(5, TensorBytes(tensor));
  for (const OnnxValue& value : model.inputs) graph.Bytes(11, ValueBytes(value));
  for (const OnnxValue& value : model.outputs) graph.Bytes(12, ValueBytes(value));
  opset.Integer(2, model.opset);
  writer.Integer(1, model.ir_version);
  writer.Bytes(2, model.producer);
  writer.Bytes(7, graph.bytes());
  writer.Bytes(8, opset.bytes());
  for (const auto& [key, value] : model.metadata) {
    ProtoWriter entry;
    entry.Bytes(1, key);
    entry.Bytes(2, value);
    writer.Bytes(14, entry.bytes());
  }
  return writer.bytes();
}

}  // namespace yorb
