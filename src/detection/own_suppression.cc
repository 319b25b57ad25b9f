// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/own_suppression.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/log.h"
#include "detection/class_names.h"
#include "detection/head_layout.h"
#include "detection/net_compile.h"

namespace yorb {
namespace {

/// ONNX's own operator, and TensorRT's, which are written into files that only TensorRT runs whole.
bool IsSuppression(const OnnxNode& node) {
  return node.op == "NonMaxSuppression" || node.op.find("NMS_TRT") != std::string::npos ||
         node.op.find("NMSDynamic_TRT") != std::string::npos;
}

/// Who reads whom.
class Ancestry {
 public:
  explicit Ancestry(const OnnxModel& model) : model_(model) {
    for (size_t i = 0; i < model.nodes.size(); ++i) {
      for (const std::string& output : model.nodes[i].outputs) makers_[output] = i;
    }
  }

  /// The nodes that some values are made of, in the order of the file.
  std::set<size_t> Behind(std::vector<std::string> values) const {
    std::set<size_t> nodes;
    while (!values.empty()) {
      const auto maker = makers_.find(values.back());
      values.pop_back();
      if (maker == makers_.end() || !nodes.insert(maker->second).second) continue;
      const std::vector<std::string>& read = model_.nodes[maker->second].inputs;
      values.insert(values.end(), read.begin(), read.end());
    }
    return nodes;
  }

 private:
  const OnnxModel& model_;
  std::map<std::string, size_t> makers_;
};

/// The network up to some values, which become its outputs.
OnnxModel PartBefore(const OnnxModel& model, const Ancestry& ancestry, const std::vector<std::string>& values) {
  OnnxModel part;
  part.ir_version = model.ir_version, part.opset = model.opset, part.producer = model.producer;
  part.inputs = model.inputs, part.metadata = model.metadata;
  std::set<std::string> read(values.begin(), values.end());
  for (const size_t i : ancestry.Behind(values)) {
    part.nodes.push_back(model.nodes[i]);
    read.insert(model.nodes[i].inputs.begin(), model.nodes[i].inputs.end());
  }
  for (const OnnxTensor& constant : model.constants) {
    if (read.count(constant.name) > 0) part.constants.push_back(constant);
  }
  for (const std::string& value : values) part.outputs.push_back({value, kOnnxFloat, {}, false});
  return part;
}

/// Whether the first output holds all boxes, by the shapes alone. What lies before the decoding, 64 numbers for the
/// edges and those of the classes, would pass for more classes where there are no names.
bool HasAllBoxes(const Network& network, const OnnxModel& part) {
  const auto net = CompileNet(part, network.input, nullptr);
  if (!net) return false;
  HeadFacts facts;
  for (const NetValue& output : net->outputs) facts.shapes.push_back(output.dims);
  facts.width = network.input.width, facts.height = network.input.height;
  facts.num_names = static_cast<int>(network.names.size());
  facts.num_keypoint_values = network.num_keypoint_values;
  const auto layout = RecogniseLayout(facts);
  if (!layout || layout->kind == LayoutKind::kRawMaps || layout->output != 0) return false;
  const bool is_named = facts.num_names > 0 || layout->num_classes == static_cast<int>(CocoNames().size());
  return layout->kind == LayoutKind::kAnchorRows || (is_named && layout->kind != LayoutKind::kCornerRows);
}

/// The last value before the suppression that holds all boxes, put together by the head from places and scores; where
/// there is none, the boxes and scores that it reads.
std::optional<OnnxModel> PartWithAllBoxes(const Network& network, const OnnxNode& suppression) {
  constexpr size_t kMostTries = 12;  // each compiles the network
  const OnnxModel& model = network.model;
  const Ancestry ancestry(model);
  std::vector<std::string> apart;  // outputs that have nothing to do with it: the maps of segmentation networks
  for (const OnnxValue& output : model.outputs) {
    const std::set<size_t> behind = ancestry.Behind({output.name});
    const bool is_apart =
        std::none_of(behind.begin(), behind.end(), [&](size_t i) { return IsSuppression(model.nodes[i]); });
    if (is_apart) apart.push_back(output.name);
  }
  std::vector<std::vector<std::string>> candidates;
  const std::set<size_t> before = ancestry.Behind(suppression.inputs);
  for (auto i = before.rbegin(); i != before.rend() && candidates.size() < kMostTries; ++i) {
    if (model.nodes[*i].op == "Concat") candidates.push_back({model.nodes[*i].outputs[0]});
  }
  if (suppression.inputs.size() > 1) candidates.push_back({suppression.inputs[0], suppression.inputs[1]});
  for (std::vector<std::string>& values : candidates) {
    std::copy_if(apart.begin(), apart.end(), std::back_inserter(values),
                 [&](const std::string& output) { return output != values[0]; });
    OnnxModel part = PartBefore(model, ancestry, values);
    if (HasAllBoxes(network, part)) return part;
  }
  return std::nullopt;
}

}  // namespace

void LeaveOutOwnSuppression(Network& network) {
  const std::vector<OnnxNode>& nodes = network.model.nodes;
  const auto suppression = std::find_if(nodes.begin(), nodes.end(), IsSuppression);
  if (suppression == nodes.end()) return;
  auto part = PartWithAllBoxes(network, *suppression);
  if (!part) return;
  LogInfo(network.input.path + ": its own choice among boxes (" + suppression->op +
          ") is left out; doubles are taken out by the limits of this program");
  network.model = *std::move(part);
}

}  // namespace yorb
