// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/people_onnx.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "training/people_cells.h"

namespace yorb {
namespace {

const char* const kPeopleOutput = "people";
constexpr int kAttributeInt = 2, kAttributeInts = 7;  // as ONNX counts

const OnnxTensor* FindConstant(const OnnxModel& model, const std::string& name) {
  const auto found = std::find_if(model.constants.begin(), model.constants.end(),
                                  [&](const OnnxTensor& constant) { return constant.name == name; });
  return found != model.constants.end() ? &*found : nullptr;
}

/// What a head reads, and how many channels that has.
struct HeadInput {
  std::string value;
  int64_t channels = 0;
};

std::optional<HeadInput> FindHeadInput(const OnnxModel& model, const std::string& output) {
  for (const OnnxNode& node : model.nodes) {
    if (node.op != "Conv" || node.outputs.front() != output || node.inputs.size() < 2) continue;
    const OnnxTensor* weight = FindConstant(model, node.inputs[1]);
    if (weight != nullptr && weight->dims.size() == 4) return HeadInput{node.inputs[0], weight->dims[1]};
  }
  return std::nullopt;
}

OnnxAttribute IntsAttribute(const std::string& name, const std::vector<int64_t>& values) {
  OnnxAttribute attribute;
  attribute.name = name;
  attribute.ints = values;
  attribute.type = kAttributeInts;
  return attribute;
}

OnnxNode MakeNode(const std::string& op, const std::string& name, std::vector<std::string> inputs) {
  OnnxNode node;
  node.op = op;
  node.name = name;
  node.inputs = std::move(inputs);
  node.outputs = {name};
  return node;
}

/// Adds nodes at the end of a graph; each call gives the name of what the node computes.
class GraphEnd {
 public:
  explicit GraphEnd(OnnxModel& model) : model_(model) {}

  std::string Simple(const std::string& op, const std::string& name, const std::vector<std::string>& inputs) {
    model_.nodes.push_back(MakeNode(op, name, inputs));
    return name;
  }

  std::string Conv(const std::string& name, const std::string& in, const torch::nn::Conv2d& conv) {
    OnnxNode node = MakeNode("Conv", name, {in, Weights(name + ".weight", conv->weight)});
    if (conv->bias.defined()) node.inputs.push_back(Weights(name + ".bias", conv->bias));
    const int64_t kernel = conv->weight.size(2), padding = kernel / 2;
    node.attributes = {IntsAttribute("kernel_shape", {kernel, kernel}), IntsAttribute("strides", {1, 1}),
                       IntsAttribute("pads", {padding, padding, padding, padding}), IntsAttribute("dilations", {1, 1})};
    OnnxAttribute group;
    group.name = "group";
    group.integer = 1;
    group.type = kAttributeInt;
    node.attributes.push_back(group);
    model_.nodes.push_back(node);
    return name;
  }

  /// As the network itself enlarges, so that whoever runs that runs this, too. Nothing where it does not.
  std::optional<std::string> Twice(const std::string& name, const std::string& in) {
    for (const OnnxNode& node : model_.nodes) {
      const OnnxTensor* scales =
          node.op == "Resize" && node.inputs.size() == 3 ? FindConstant(model_, node.inputs[2]) : nullptr;
      if (scales == nullptr || scales->floats != std::vector<float>{1, 1, 2, 2}) continue;
      OnnxNode twice = node;
      twice.name = name;
      twice.inputs[0] = in;
      twice.outputs = {name};
      model_.nodes.push_back(twice);
      return name;
    }
    return std::nullopt;
  }

 private:
  std::string Weights(const std::string& name, const torch::Tensor& values) {
    const torch::Tensor plain = values.detach().to(torch::kCPU, torch::kFloat32).contiguous();
    OnnxTensor tensor;
    tensor.name = name;
    tensor.dims = plain.sizes().vec();
    tensor.floats.assign(plain.data_ptr<float>(), plain.data_ptr<float>() + plain.numel());
    model_.constants.push_back(tensor);
    return name;
  }

  OnnxModel& model_;
};

/// An output with floats whose shape is left to the graph where none is given.
OnnxValue MakeOutput(const std::string& name, const std::vector<int64_t>& dims) {
  OnnxValue value;
  value.name = name;
  value.type = kOnnxFloat;
  value.dims = dims;
  value.has_shape = !dims.empty();
  return value;
}

std::string AddTap(const std::string& name, const std::string& value, OnnxModel& model) {
  OnnxNode node = MakeNode("MaxPool", name, {value});
  node.attributes = {IntsAttribute("kernel_shape", {1, 1}), IntsAttribute("strides", {1, 1}),
                     IntsAttribute("pads", {0, 0, 0, 0})};
  model.nodes.push_back(node);
  return name;
}

/// Whether WithPeopleHead gave something its name.
bool IsOfPeople(const std::string& name) {
  return name == kPeopleOutput || name.starts_with(std::string(kPeopleOutput) + ".");
}

}  // namespace

OnnxModel WithoutPeopleHead(OnnxModel model) {
  const auto is_of_people = [](const auto& part) { return IsOfPeople(part.name); };
  std::erase_if(model.nodes, is_of_people);
  std::erase_if(model.constants, is_of_people);
  std::erase_if(model.outputs, is_of_people);
  model.metadata.erase(kPeopleOutput);
  return model;
}

Result<FeatureTaps> FindFeatureTaps(const OnnxModel& model, const std::string& path) {
  const auto fine = FindHeadInput(model, "stride8"), coarse = FindHeadInput(model, "stride16");
  if (!fine || !coarse)
    return BadInput(path + ": has no convolutions that give stride8 and stride16, as a file of yorb-train export has");
  const bool has_people = std::any_of(model.outputs.begin(), model.outputs.end(),
                                      [](const OnnxValue& output) { return output.name == kPeopleOutput; });
  if (has_people) return BadInput(path + ": has a map of people already; begin from the file without it");
  const std::vector<int64_t> dims = model.inputs.size() == 1 ? model.inputs[0].dims : std::vector<int64_t>();
  const bool is_fixed = dims.size() == 4 && dims[0] == 1 && dims[1] == 3 && dims[2] > 0 && dims[3] > 0;
  if (!is_fixed || dims[2] % 32 != 0 || dims[3] % 32 != 0)
    return BadInput(path + ": its input is not of the shape (1, 3, height, width) in multiples of 32");
  return FeatureTaps{fine->value, coarse->value, fine->channels, coarse->channels,
                     cv::Size(static_cast<int>(dims[3]), static_cast<int>(dims[2]))};
}

OnnxModel WithTapsForOutputs(OnnxModel model, const FeatureTaps& taps) {
  // Engines that melt operators together hold no values between them; what an operator of its own gives, they must.
  const std::string fine = AddTap("people.fine_map", taps.fine, model);
  const std::string coarse = AddTap("people.coarse_map", taps.coarse, model);
  model.outputs = {MakeOutput(fine, {1, taps.fine_channels, taps.input.height / 8, taps.input.width / 8}),
                   MakeOutput(coarse, {1, taps.coarse_channels, taps.input.height / 16, taps.input.width / 16})};
  return model;
}

Result<OnnxModel> WithPeopleHead(OnnxModel model, const FeatureTaps& taps, const PeopleHead& head,
                                 const std::string& path) {
  GraphEnd end(model);
  const std::string coarse = end.Conv("people.coarse", taps.coarse, head->coarse);
  const auto enlarged = end.Twice("people.twice", coarse);
  if (!enlarged) return BadInput(path + ": has no Resize that doubles a map, after which that of the head is made");
  const std::string fine = end.Conv("people.fine", taps.fine, head->fine);
  const std::string both = end.Simple("Relu", "people.both", {end.Simple("Add", "people.sum", {fine, *enlarged})});
  const std::string mixed = end.Simple("Relu", "people.mixed", {end.Conv("people.mix", both, head->mix)});
  end.Conv(kPeopleOutput, mixed, head->out);
  const int64_t cell = kPeopleCellPx;
  model.outputs.push_back(MakeOutput(kPeopleOutput, {1, 1, taps.input.height / cell, taps.input.width / cell}));
  model.metadata[kPeopleOutput] = std::to_string(cell);
  return model;
}

}  // namespace yorb
