// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/net_compile.h"

#include <algorithm>
#include <map>
#include <new>
#include <optional>
#include <set>
#include <utility>

#include "detection/net_join.h"

namespace yorb {
namespace {

/// Compiles node by node, in the order of the file.
class NetCompiler {
 public:
  NetCompiler(const OnnxModel& model, CompiledNet& net) : model_(model), net_(net), put_off_(NodesToPutOff(model)) {
    CountReaders();
  }

  Status Compile(const EngineInput& input) {
    // Either way pixels lie next to their channels.
    net_.input = input.is_channels_last ? net_.program.New({input.batch, input.height, input.width, input.channels},
                                                           NetLayout::kDense, false)
                                        : net_.program.New({input.batch, input.channels, input.height, input.width},
                                                           NetLayout::kChannelsLast, false);
    net_.input.is_whole = input.are_bytes;
    values_[model_.inputs.front().name] = net_.input;
    for (const OnnxTensor& tensor : model_.constants) {
      if (IsForConvolutions(tensor.name)) {
        weights_[tensor.name] = &tensor;
      } else {
        values_[tensor.name] = Filled(net_.program.New(tensor.dims, NetLayout::kDense, true), tensor);
      }
    }
    for (size_t i = 0; i < model_.nodes.size(); ++i) {
      if (Status status = CompileNode(model_.nodes[i]); !status) return status;
      for (const std::string& name : model_.nodes[i].inputs) {
        if (last_reader_[name] == i) values_.erase(name), parts_.erase(name);  // its buffer may be used again
      }
    }
    for (const OnnxValue& output : model_.outputs) {
      net_.outputs.push_back(values_.at(output.name));
      net_.heads.push_back(heads_[output.name]);
    }
    return Status::Ok();
  }

 private:
  void CountReaders() {
    for (size_t i = 0; i < model_.nodes.size(); ++i) {
      for (const std::string& name : model_.nodes[i].inputs) {
        readers_[name].push_back(i);
        last_reader_[name] = i;
      }
    }
    for (const OnnxValue& output : model_.outputs) {
      last_reader_[output.name] = model_.nodes.size();
      readers_[output.name].push_back(model_.nodes.size());
    }
  }

  /// Whether a constant is read by convolutions alone, which make weights of their own of it.
  bool IsForConvolutions(const std::string& constant) {
    const std::vector<size_t>& readers = readers_[constant];
    return std::all_of(readers.begin(), readers.end(), [&](size_t i) {
      return i < model_.nodes.size() && model_.nodes[i].op == "Conv" && model_.nodes[i].inputs[0] != constant;
    });
  }

  /// The one node that reads a value; nothing where there are several, or the value is a result.
  const OnnxNode* OnlyReader(const std::string& value) const {
    const auto found = readers_.find(value);
    if (found == readers_.end() || found->second.empty()) return nullptr;
    const auto& readers = found->second;
    const bool is_one = std::all_of(readers.begin(), readers.end(), [&](size_t i) { return i == readers.front(); });
    return is_one && readers.front() < model_.nodes.size() ? &model_.nodes[readers.front()] : nullptr;
  }

  /// Weights are taken from the file when they are wanted, and not kept.
  NetValue ValueOf(const std::string& name) const {
    const auto weights = weights_.find(name);
    return weights == weights_.end() ? values_.at(name) : Filled(NewConstant(weights->second->dims), *weights->second);
  }

  NetNode NodeOf(const OnnxNode& node) {
    NetNode ready{node, {}, net_.program, model_.opset, !node.inputs.empty()};
    for (const std::string& name : node.inputs) {
      ready.inputs.push_back(name.empty() ? NetValue() : ValueOf(name));
      if (!name.empty()) ready.is_constant &= ready.inputs.back().is_constant;
    }
    return ready;
  }

  /// ONNX's own; ONNX Runtime writes 16-bit quantisation, which is the same, under its own.
  static bool IsOfKnownDomain(const OnnxNode& node) {
    const bool is_quantising = node.op == "QuantizeLinear" || node.op == "DequantizeLinear";
    return node.domain.empty() || node.domain == "ai.onnx" || (is_quantising && node.domain == "com.microsoft");
  }

  Status CompileNode(const OnnxNode& node) {
    const std::string unknown = "operator " + node.op;
    if (!IsOfKnownDomain(node)) return BadInput(unknown + " of " + node.domain);
    const NetNode ready = NodeOf(node);
    auto outputs = put_off_.count(&node) > 0 ? std::optional(PutOff(ready)) : Fused(ready);
    if (!outputs) {
      outputs = PictureOperator(ready);
      for (const auto family : {AddShapeOperator, AddSelection, AddQuantised, AddArithmetic}) {
        if (outputs->ok() || !outputs->error().message.empty()) break;
        outputs = family(ready);
      }
    }
    if (!*outputs) return BadInput(unknown + outputs->error().message);
    net_.shapes.push_back((*outputs)->empty() ? std::vector<int64_t>() : (**outputs)[0].dims);
    if ((*outputs)->size() < node.outputs.size()) return BadInput(unknown + ": more outputs than are known");
    if (node.op == "Conv") convolved_.insert(node.outputs[0]);
    for (size_t i = 0; i < node.outputs.size(); ++i) {
      if (!node.outputs[i].empty()) values_[node.outputs[i]] = (**outputs)[i];
    }
    return Status::Ok();
  }

  NetOutputs PictureOperator(const NetNode& ready) {
    const auto parts = ready.node.inputs.empty() ? parts_.end() : parts_.find(ready.node.inputs[0]);
    if (parts != parts_.end()) return AddConvolutionOfParts(ready, parts->second);
    const auto head = IsOutput(ready.node.outputs[0]) ? NetHead::Of(ready) : nullptr;
    if (!head) return AddPictureOperator(ready);
    ready.Add([head] { head->Run(); });
    heads_[ready.node.outputs[0]] = head;
    return std::vector<NetValue>{head->output()};
  }

  /// Whether a value goes out of the network and nowhere else.
  bool IsOutput(const std::string& value) const {
    const auto found = readers_.find(value);
    return found != readers_.end() && found->second == std::vector<size_t>{model_.nodes.size()};
  }

  /// Remembers the parts of a picture in place of making it. What is given has the picture's shape and is not read.
  NetOutputs PutOff(const NetNode& ready) {
    std::vector<NetPart> parts;
    if (ready.node.op != "Concat") {
      const auto factors = EnlargementOf(ready);
      if (!factors) return factors.error();
      parts.push_back({ready.inputs[0], factors->first, factors->second});
    }
    for (size_t i = 0; ready.node.op == "Concat" && i < ready.inputs.size(); ++i) {
      const auto found = parts_.find(ready.node.inputs[i]);
      parts.push_back(found == parts_.end() ? NetPart{ready.inputs[i]} : found->second.front());
    }
    auto dims = JoinedDims(parts);
    if (!dims) return dims.error();
    NetValue unmade = parts.front().picture;
    unmade.dims = *std::move(dims);
    parts_[ready.node.outputs[0]] = std::move(parts);
    return std::vector<NetValue>{std::move(unmade)};
  }

  /// Pairs of operators that are one step: x * sigmoid(x), x * hardsigmoid(x), and a convolution with its limits.
  std::optional<NetOutputs> Fused(const NetNode& ready) {
    const OnnxNode& node = ready.node;
    if (done_before_.count(&node) > 0) return NetOutputs(std::vector<NetValue>{ready.inputs[0]});
    if (const auto gate = gates_.find(&node); gate != gates_.end()) {
      const NetValue& x = values_.at(gate->second.input);
      return NetOutputs(std::vector<NetValue>{gate->second.is_hard ? AddHardSwish(ready, x, gate->second.is_in_place)
                                                                   : AddSilu(ready, x, gate->second.is_in_place)});
    }
    if (ready.is_constant || node.outputs.size() != 1) return std::nullopt;
    const OnnxNode* next = OnlyReader(node.outputs[0]);
    if (next == nullptr) return std::nullopt;
    if (node.op == "Conv") return WithLimits(ready, *next);
    if (IsGate(node) && next->op == "Mul" && next->inputs.size() == 2) {
      const std::string& other = next->inputs[next->inputs[0] == node.outputs[0] ? 1 : 0];
      if (other != node.inputs[0] || other == node.outputs[0]) return std::nullopt;
      gates_[next] = {other, node.op == "HardSigmoid", IsOfConvolution(other) && readers_[other].size() == 2};
      return NetOutputs(std::vector<NetValue>{ready.inputs[0]});  // its reader takes the two in one
    }
    return std::nullopt;
  }

  /// Whether a value lies in a place of its own, of which there are no views.
  bool IsOfConvolution(const std::string& value) const { return convolved_.count(value) > 0; }

  static bool IsGate(const OnnxNode& node) {
    const bool is_sixth = std::abs(node.Number("alpha", 0.2f) - 1.f / 6) < 1e-5f && node.Number("beta", 0.5f) == 0.5f;
    return node.op == "Sigmoid" || (node.op == "HardSigmoid" && is_sixth);
  }

  std::optional<NetOutputs> WithLimits(NetNode ready, const OnnxNode& next) {
    if (next.op == "Relu") {
      ready.least = 0;
    } else if (next.op == "Clip") {
      const auto limit = [&](const char* name, size_t input, float otherwise) {
        if (next.Find(name) != nullptr) return next.Number(name, otherwise);
        const auto found = next.inputs.size() > input ? values_.find(next.inputs[input]) : values_.end();
        return found != values_.end() && found->second.is_constant && found->second.size() == 1
                   ? NumbersOf(found->second)[0]
                   : otherwise;
      };
      ready.least = limit("min", 1, -HUGE_VALF), ready.most = limit("max", 2, HUGE_VALF);
      const bool is_known = ready.least > -HUGE_VALF && ready.most < HUGE_VALF && ready.least < ready.most;
      if (!is_known) return std::nullopt;
    } else {
      return std::nullopt;
    }
    auto outputs = PictureOperator(ready);
    if (outputs) done_before_.insert(&next);
    return outputs;
  }

  struct Gate {
    std::string input;
    bool is_hard = false;
    bool is_in_place = false;
  };

  const OnnxModel& model_;
  CompiledNet& net_;
  std::map<std::string, NetValue> values_;
  std::map<std::string, const OnnxTensor*> weights_;  // of convolutions
  const std::set<const OnnxNode*> put_off_;
  std::map<std::string, std::vector<NetPart>> parts_;  // of pictures that are put off
  std::map<std::string, std::shared_ptr<NetHead>> heads_;
  std::map<std::string, std::vector<size_t>> readers_;
  std::map<std::string, size_t> last_reader_;
  std::set<std::string> convolved_;        // what convolutions gave
  std::set<const OnnxNode*> done_before_;  // limits that the convolution before them has taken over
  std::map<const OnnxNode*, Gate> gates_;  // products that are one step with the gate before them
};

}  // namespace

Result<CompiledNet> CompileNet(const OnnxModel& model, const EngineInput& input, pthreadpool* threads) {
  if (!PrepareKernels()) return BadInput("instructions on this processor");
  CompiledNet net;
  net.program.SetThreads(threads);
  try {
    if (Status status = NetCompiler(model, net).Compile(input); !status) return status.error();
  } catch (const std::bad_alloc&) {
    return BadInput("shapes: they need more memory than there is");
  }
  return net;
}

}  // namespace yorb
