// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/teacher.h"

#include <map>

#include "detection/class_names.h"
#include "detection/onnx_model.h"

namespace yorb {
namespace {

/// A convolution as a file has it, its norm folded in.
struct FileConvolution {
  const OnnxTensor* weight = nullptr;
  const OnnxTensor* bias = nullptr;
};

std::vector<FileConvolution> ConvolutionsOf(const OnnxModel& model) {
  std::map<std::string, const OnnxTensor*> constants;
  for (const OnnxTensor& constant : model.constants) constants[constant.name] = &constant;
  std::vector<FileConvolution> convolutions;
  for (const OnnxNode& node : model.nodes) {
    if (node.op != "Conv" || node.inputs.size() != 3) continue;
    convolutions.push_back({constants[node.inputs[1]], constants[node.inputs[2]]});
  }
  return convolutions;
}

/// The convolutions of a row in the order in which they are computed.
std::vector<ConvNorm> ConvolutionsOf(RowImpl& row) {
  if (const auto* conv = dynamic_cast<const ConvRow*>(&row)) return {conv->conv_norm};
  if (const auto* sppf = dynamic_cast<const SppfRow*>(&row)) return {sppf->cv1, sppf->cv2};
  const auto* c3 = dynamic_cast<const C3Row*>(&row);
  if (c3 == nullptr) return {};
  std::vector<ConvNorm> all{c3->cv1};
  for (const Bottleneck& bottleneck : c3->bottlenecks) all.insert(all.end(), {bottleneck->cv1, bottleneck->cv2});
  all.insert(all.end(), {c3->cv2, c3->cv3});
  return all;
}

bool Copy(const OnnxTensor* from, torch::Tensor to) {
  if (from == nullptr || from->is_whole || to.sizes() != at::IntArrayRef(from->dims)) return false;
  to.copy_(torch::tensor(from->floats).view(to.sizes()));
  return true;
}

bool CopyWeights(const OnnxModel& model, Network& network) {
  const torch::NoGradGuard no_grad;
  std::vector<ConvNorm> own;
  for (const auto& row : network->rows) {
    for (const ConvNorm& conv : ConvolutionsOf(*row)) own.push_back(conv);
  }
  const std::vector<FileConvolution> found = ConvolutionsOf(model);
  if (found.size() != own.size() + network->heads.size()) return false;
  for (size_t i = 0; i < own.size(); ++i) {
    own[i]->HoldFolded();
    if (!Copy(found[i].weight, own[i]->conv->weight) || !Copy(found[i].bias, own[i]->bn->bias)) return false;
  }
  for (size_t i = 0; i < network->heads.size(); ++i) {
    const FileConvolution& head = found[own.size() + i];
    if (!Copy(head.weight, network->heads[i]->weight) || !Copy(head.bias, network->heads[i]->bias)) return false;
  }
  UnfoldNormalisation(network);
  return true;
}

/// Channels of the heads say how many classes there are; the metadata may name them.
ClassTable TableOf(const OnnxModel& model) {
  ClassTable table;
  const auto named = model.metadata.find("names");
  const auto names = named != model.metadata.end() ? ParseClassNames(named->second) : std::nullopt;
  table.names = names.value_or(CocoNames());
  table.motions.resize(table.names.size());
  return table;
}

}  // namespace

Result<Teacher> ReadTeacher(const std::string& path, const ClassTable& learner) {
  const Result<OnnxModel> model = ReadOnnxFile(path);
  if (!model) return model.error();
  Teacher teacher{.table = TableOf(*model)};
  for (int own = 0; own < teacher.table.size(); ++own) {
    const std::optional<int> other = learner.Find(teacher.table.names[static_cast<size_t>(own)]);
    if (!other) continue;
    teacher.own_class.push_back(own);
    teacher.learner_class.push_back(*other);
  }
  if (teacher.own_class.empty())
    return BadInput(path + ": knows none of the classes that are to be learnt; --teacher wants one that does");
  for (const char* name : {"yolov5n", "yolov5s"}) {
    teacher.network = Network(MakeLayout(name, teacher.table.size()));
    if (!CopyWeights(*model, teacher.network)) continue;
    teacher.network->eval();
    for (torch::Tensor& parameter : teacher.network->parameters()) parameter.set_requires_grad(false);
    return teacher;
  }
  return BadInput(path + ": is no YOLOv5n or YOLOv5s of " + std::to_string(teacher.table.size()) +
                  " classes with its norms folded; --teacher wants an ONNX export of one");
}

}  // namespace yorb
