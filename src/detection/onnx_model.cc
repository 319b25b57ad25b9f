// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/onnx_model.h"

#include <algorithm>

namespace yorb {

const OnnxAttribute* OnnxNode::Find(const std::string& attribute) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const OnnxAttribute& candidate) { return candidate.name == attribute; });
  return found == attributes.end() ? nullptr : &*found;
}

int64_t OnnxNode::Integer(const std::string& attribute, int64_t otherwise) const {
  const OnnxAttribute* found = Find(attribute);
  return found == nullptr ? otherwise : found->integer;
}

float OnnxNode::Number(const std::string& attribute, float otherwise) const {
  const OnnxAttribute* found = Find(attribute);
  return found == nullptr ? otherwise : found->number;
}

std::string OnnxNode::Text(const std::string& attribute, const std::string& otherwise) const {
  const OnnxAttribute* found = Find(attribute);
  return found == nullptr ? otherwise : found->text;
}

std::vector<int64_t> OnnxNode::Integers(const std::string& attribute, const std::vector<int64_t>& otherwise) const {
  const OnnxAttribute* found = Find(attribute);
  return found == nullptr ? otherwise : found->ints;
}

}  // namespace yorb
