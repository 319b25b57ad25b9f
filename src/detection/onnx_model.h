// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"

namespace yorb {

/// The element types of ONNX that are met here.
enum OnnxType : int {
  kOnnxFloat = 1,
  kOnnxUint8 = 2,
  kOnnxInt8 = 3,
  kOnnxUint16 = 4,
  kOnnxInt16 = 5,
  kOnnxInt32 = 6,
  kOnnxInt64 = 7,
  kOnnxText = 8,
  kOnnxBool = 9,
  kOnnxFloat16 = 10,
  kOnnxDouble = 11,
  kOnnxUint32 = 12,
  kOnnxUint64 = 13,
  kOnnxBfloat16 = 16,
};

/// Whether numbers of a type have fractions.
inline bool IsFloatType(int64_t type) {
  return type == kOnnxFloat || type == kOnnxFloat16 || type == kOnnxDouble || type == kOnnxBfloat16;
}

/// A constant: weights, shapes. Halves and doubles are read as floats, all whole numbers and booleans as int64.
struct OnnxTensor {
  std::string name;
  std::vector<int64_t> dims;  ///< none: a single number
  bool is_whole = false;      ///< its numbers stand in `ints`, else in `floats`
  int type = 0;               ///< as the file has it; 0: not said
  std::vector<float> floats;
  std::vector<int64_t> ints;

  size_t size() const { return is_whole ? ints.size() : floats.size(); }
};

/// A setting of a node; which of the fields counts is a matter of its name.
struct OnnxAttribute {
  std::string name;
  float number = 0;
  int64_t integer = 0;
  std::string text;
  std::vector<float> floats;
  std::vector<int64_t> ints;
  std::optional<OnnxTensor> tensor;
  int type = 0;  ///< as the file has it; 0: left out
};

/// One operator.
struct OnnxNode {
  std::string op, name, domain;
  std::vector<std::string> inputs, outputs;
  std::vector<OnnxAttribute> attributes;

  const OnnxAttribute* Find(const std::string& attribute) const;
  int64_t Integer(const std::string& attribute, int64_t otherwise) const;
  float Number(const std::string& attribute, float otherwise) const;
  std::string Text(const std::string& attribute, const std::string& otherwise) const;
  std::vector<int64_t> Integers(const std::string& attribute, const std::vector<int64_t>& otherwise) const;
};

/// An input or output of the graph.
struct OnnxValue {
  std::string name;
  int type = 0;
  std::vector<int64_t> dims;  ///< -1 where the file leaves the size open
  bool has_shape = false;
};

/// A network as its file has it, in the order of the file.
struct OnnxModel {
  int64_t ir_version = 0;
  int64_t opset = 0;
  std::string producer;
  std::vector<OnnxNode> nodes;
  std::vector<OnnxTensor> constants;
  std::vector<OnnxValue> inputs;  ///< those that are no constants
  std::vector<OnnxValue> outputs;
  std::map<std::string, std::string> metadata;
};

/// Reads a network; bad input says why not, in words that follow the file's name. Weights in other files are read from
/// beside `path`. The graph is sound: every node reads constants, inputs of the graph or outputs of nodes before it.
Result<OnnxModel> ReadOnnxFile(const std::string& path);
Result<OnnxModel> ReadOnnxBytes(const std::string& bytes, const std::string& path);

/// The network as the bytes of a file, with weights as floats within it.
std::string OnnxBytes(const OnnxModel& model);

}  // namespace yorb
