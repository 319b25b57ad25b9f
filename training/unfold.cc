// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/unfold.h"

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "detection/class_names.h"
#include "detection/onnx_model.h"

namespace yorb {
namespace {

/// The weights of a file, by name.
class FileWeights {
 public:
  FileWeights(const OnnxModel& model, std::string path) : path_(std::move(path)) {
    for (const OnnxTensor& constant : model.constants) constants_[constant.name] = &constant;
  }

  Result<torch::Tensor> Read(const std::string& name) const {
    const auto found = constants_.find(name);
    if (found == constants_.end() || found->second->is_whole)
      return BadInput(path_ + ": has no weights '" + name +
                      "'; --weights takes a checkpoint, or an ONNX file that yorb-train export wrote, of --network");
    return torch::tensor(found->second->floats).view(found->second->dims);
  }

  Status CopyTo(torch::Tensor to, const std::string& name) const {
    const Result<torch::Tensor> from = Read(name);
    if (!from) return from.error();
    if (from->sizes() != to.sizes())
      return BadInput(path_ + ": '" + name + "' has another shape than in the network that --network names");
    to.copy_(*from);
    return Status::Ok();
  }

  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::map<std::string, const OnnxTensor*> constants_;
};

/// Where `ExportOnnx` puts a parameter of the network: "1.dw.weight" for "1.dw.conv.weight", its bias for that of the
/// norm.
std::string NameInFile(std::string name) {
  for (const std::string part : {"conv.", "bn."}) {
    if (const size_t at = name.rfind(part); at != std::string::npos) name.erase(at, part.size());
  }
  return name;
}

/// Weights or biases of a head: of every anchor the box and its objectness, and the classes that both know.
Status CopyHead(const FileWeights& weights, const std::string& name, const std::vector<std::string>& file_classes,
                const ClassTable& table, torch::Tensor to) {
  const Result<torch::Tensor> read = weights.Read(name);
  if (!read) return read.error();
  const auto per_anchor = [](const torch::Tensor& all, size_t num_classes) {
    return all.view({3, 5 + static_cast<int64_t>(num_classes), all.dim() > 1 ? all.size(1) : 1});
  };
  if (read->size(0) != 3 * (5 + static_cast<int64_t>(file_classes.size())) ||
      (to.dim() > 1 && read->size(1) != to.size(1)))
    return BadInput(weights.path() + ": '" + name +
                    "' has another shape than its names of classes, or --network, want");
  const torch::Tensor from = per_anchor(*read, file_classes.size());
  torch::Tensor own = per_anchor(to, static_cast<size_t>(table.size()));
  own.slice(1, 0, 5).copy_(from.slice(1, 0, 5));
  for (size_t i = 0; i < file_classes.size(); ++i) {
    if (const std::optional<int> number = table.Find(file_classes[i]))
      own.select(1, 5 + *number).copy_(from.select(1, 5 + static_cast<int64_t>(i)));
  }
  return Status::Ok();
}

/// All convolutions that a norm follows.
std::vector<ConvNormImpl*> ConvNormsOf(Network& network) {
  std::vector<ConvNormImpl*> all;
  for (const auto& row : network->rows) {
    if (auto* conv = dynamic_cast<ConvRow*>(row.get())) all.push_back(conv->conv_norm.get());
    for (const auto& module : row->modules()) {
      if (auto* conv_norm = dynamic_cast<ConvNormImpl*>(module.get())) all.push_back(conv_norm);
    }
  }
  return all;
}

}  // namespace

Status ReadFoldedWeights(const std::string& path, const ClassTable& table, const torch::Tensor& pictures,
                         Network network) {
  const torch::NoGradGuard no_grad;
  const Result<OnnxModel> model = ReadOnnxFile(path);
  if (!model) return model.error();
  const auto named = model->metadata.find("names");
  const auto classes = named != model->metadata.end() ? ParseClassNames(named->second) : std::nullopt;
  if (!classes) return BadInput(path + ": names no classes; --weights takes an ONNX file that yorb-train export wrote");
  const FileWeights weights(*model, path);
  const std::vector<ConvNormImpl*> conv_norms = ConvNormsOf(network);
  for (ConvNormImpl* conv_norm : conv_norms) conv_norm->HoldFolded();
  for (const auto& parameter : network->named_parameters()) {
    if (parameter.key().ends_with("bn.weight") || parameter.key().starts_with("detect")) continue;
    if (const Status copied = weights.CopyTo(parameter.value(), NameInFile(parameter.key())); !copied) return copied;
  }
  for (size_t level = 0; level < network->heads.size(); ++level) {
    const auto& head = network->heads[level];
    const std::string name = "stride" + std::to_string(network->layout.strides[level]);
    Status copied = CopyHead(weights, name + ".weight", *classes, table, head->weight);
    if (copied) copied = CopyHead(weights, name + ".bias", *classes, table, head->bias);
    if (!copied) return copied;
  }
  UnfoldNormalisation(network);
  const bool was_training = network->is_training();
  network->eval();
  for (ConvNormImpl* conv_norm : conv_norms) conv_norm->takes_statistics = true;
  network->forward(pictures);
  for (ConvNormImpl* conv_norm : conv_norms) conv_norm->takes_statistics = false;
  network->train(was_training);
  return Status::Ok();
}

}  // namespace yorb
