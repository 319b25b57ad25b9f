// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/train_state.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <unordered_set>

#include "core/text.h"

namespace yorb {
namespace {

using torch::optim::AdamW;
using torch::optim::AdamWOptions;
using torch::optim::OptimizerParamGroup;

/// Four groups: backbone and head, each with and without decay.
std::vector<OptimizerParamGroup> GroupsOf(Network& network, const OptimizerOptions& options) {
  std::unordered_set<const void*> backbone;
  for (const torch::Tensor& parameter : network->BackboneParameters()) backbone.insert(parameter.unsafeGetTensorImpl());
  std::array<std::vector<torch::Tensor>, 4> parts;
  for (const torch::Tensor& parameter : network->parameters()) {
    const bool is_backbone = backbone.count(parameter.unsafeGetTensorImpl()) > 0;
    parts[(is_backbone ? 0u : 2u) + (parameter.dim() > 1 ? 0u : 1u)].push_back(parameter);
  }
  std::vector<OptimizerParamGroup> groups;
  for (size_t i = 0; i < parts.size(); ++i) {
    const double decay = i % 2 == 0 ? options.weight_decay : 0;
    groups.emplace_back(parts[i], std::make_unique<AdamWOptions>(AdamWOptions(options.rate).weight_decay(decay)));
  }
  return groups;
}

std::string NamesText(const ClassTable& table) {
  std::string text;
  for (int i = 0; i < table.size(); ++i) {
    const auto n = static_cast<size_t>(i);
    text += table.names[n] + " " + (table.motions[n].empty() ? "-" : table.motions[n]) + "\n";
  }
  return text;
}

ClassTable TableOf(const std::string& text) {
  ClassTable table;
  for (const std::string_view line : SplitAt(text, '\n')) {
    const std::vector<std::string_view> words = SplitAtBlanks(line);
    if (words.size() != 2) continue;
    table.names.emplace_back(words[0]);
    table.motions.emplace_back(words[1] == "-" ? "" : words[1]);
  }
  return table;
}

/// The network becomes `kept` of itself and the rest of the other, which may be on another device; counters are copied.
void MoveTowards(const Network& other, double kept, Network& network) {
  const torch::NoGradGuard no_grad;
  std::vector<torch::Tensor> moved, goals;
  const auto move = [&](torch::Tensor to, const torch::Tensor& from) {
    if (to.is_floating_point()) {
      moved.push_back(to);
      goals.push_back(from.to(to.device()));
    } else {
      to.copy_(from);
    }
  };
  const auto from_parameters = other->parameters(), to_parameters = network->parameters();
  for (size_t i = 0; i < to_parameters.size(); ++i) move(to_parameters[i], from_parameters[i]);
  const auto from_buffers = other->buffers(), to_buffers = network->buffers();
  for (size_t i = 0; i < to_buffers.size(); ++i) move(to_buffers[i], from_buffers[i]);
  torch::_foreach_mul_(moved, kept);  // hundreds of small tensors: two calls of a GPU in place of two each
  torch::_foreach_add_(moved, goals, 1 - kept);
}

torch::Device DeviceOf(const Network& network) { return network->heads.front()->weight.device(); }

Error NoCheckpoint(const std::string& path) {
  return BadInput(path + ": cannot be read as a checkpoint of yorb-train; it writes last.pt into its --out folder");
}

}  // namespace

TrainState::TrainState(const Layout& layout, const ClassTable& class_table, const OptimizerOptions& optimizer_options)
    : table(class_table), options(optimizer_options), network(layout), average(layout) {
  optimizer = std::make_unique<AdamW>(GroupsOf(network, options), AdamWOptions(options.rate));
  for (torch::Tensor& parameter : average->parameters()) parameter.set_requires_grad(false);
  average->eval();
}

void SetRate(TrainState& state, double rate) {
  auto& groups = state.optimizer->param_groups();
  for (size_t i = 0; i < groups.size(); ++i) {
    const double part = i < 2 ? state.options.backbone_part : 1;
    static_cast<AdamWOptions&>(groups[i].options()).lr(state.options.rate * rate * part);
  }
}

void UpdateAverage(TrainState& state) {
  // Short at first, so that the random beginning is soon forgotten.
  const double step = static_cast<double>(state.step + 1);
  MoveTowards(state.network, std::min(state.options.averaging, step / (step + 10)), state.average);
}

Status SaveCheckpoint(const std::string& path, TrainState& state) {
  try {
    torch::serialize::OutputArchive archive, network, average, optimizer;
    state.network->save(network);
    state.average->save(average);
    state.optimizer->save(optimizer);
    archive.write("network", network);
    archive.write("average", average);
    archive.write("optimizer", optimizer);
    archive.write("step", c10::IValue(state.step));
    archive.write("seconds", c10::IValue(state.seconds));
    archive.write("layout", c10::IValue(state.network->layout.name));
    archive.write("classes", c10::IValue(NamesText(state.table)));
    archive.save_to(path + ".part");
    std::filesystem::rename(path + ".part", path);
  } catch (const std::exception&) {
    return Failure(path + ": the checkpoint cannot be written; is the disk full?");
  }
  return Status::Ok();
}

Result<CheckpointKind> ReadCheckpointKind(const std::string& path) {
  try {
    torch::serialize::InputArchive archive;
    archive.load_from(path, torch::kCPU);
    c10::IValue layout, classes;
    archive.read("layout", layout);
    archive.read("classes", classes);
    CheckpointKind kind{layout.toStringRef(), TableOf(classes.toStringRef())};
    const std::vector<std::string>& known = LayoutNames();
    if (std::find(known.begin(), known.end(), kind.layout) == known.end()) return NoCheckpoint(path);
    return kind;
  } catch (const std::exception&) {
    return NoCheckpoint(path);
  }
}

Status LoadCheckpoint(const std::string& path, TrainState& state) {
  const Result<CheckpointKind> kind = ReadCheckpointKind(path);
  if (!kind) return kind.error();
  if (kind->layout != state.network->layout.name || kind->table.names != state.table.names)
    return BadInput(path + ": is a checkpoint of " + kind->layout + " with " + std::to_string(kind->table.size()) +
                    " classes, and another network or list of classes was asked for");
  try {
    torch::serialize::InputArchive archive, network, average, optimizer;
    archive.load_from(path, DeviceOf(state.network));  // wherever it was written
    archive.read("network", network);
    archive.read("average", average);
    archive.read("optimizer", optimizer);
    state.network->load(network);
    state.average->load(average);
    state.optimizer->load(optimizer);
    c10::IValue step, seconds;
    archive.read("step", step);
    archive.read("seconds", seconds);
    state.step = step.toInt();
    state.seconds = seconds.toDouble();
  } catch (const std::exception&) {
    return NoCheckpoint(path);
  }
  return Status::Ok();
}

Status BeginFrom(const std::string& path, TrainState& state) {
  TrainState other(state.network->layout, state.table, state.options);
  if (const Status loaded = LoadCheckpoint(path, other); !loaded) return loaded;
  MoveTowards(other.average, 0, state.network);
  MoveTowards(other.average, 0, state.average);
  return Status::Ok();
}

Status AverageWith(const std::vector<std::string>& paths, TrainState& state) {
  double count = 1;
  for (const std::string& path : paths) {
    TrainState other(state.network->layout, state.table, state.options);
    if (const Status loaded = LoadCheckpoint(path, other); !loaded) return loaded;
    MoveTowards(other.average, count / (count + 1), state.average);
    ++count;
  }
  return Status::Ok();
}

}  // namespace yorb
