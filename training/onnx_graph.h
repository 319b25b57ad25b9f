// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <torch/torch.h>

#include <memory>
#include <string>
#include <vector>

#include "training/blocks.h"

namespace yorb {

/// A convolution with what follows it folded in: y = weight * x + bias.
struct FoldedConv {
  torch::Tensor weight, bias;
  int stride = 1, padding = 0, groups = 1;
};

/// Folds the batch norm of evaluation mode into its convolution.
FoldedConv Fold(const ConvNormImpl& conv_norm);

/// Writes an ONNX graph (operator set 13: an enlargement need not say what it looks at), node by node. Values go by
/// name; each call gives the name of its output. Only operators that OpenCV 4.6 and ONNX Runtime both read are used.
class OnnxGraph {
 public:
  OnnxGraph();
  ~OnnxGraph();

  std::string Input(const std::string& name, const std::vector<int64_t>& shape);
  void Output(const std::string& value, const std::vector<int64_t>& shape);
  void Metadata(const std::string& key, const std::string& value);

  /// `name` is that of the node and its output, and the beginning of its weights' names.
  std::string Conv(const std::string& name, const std::string& in, const FoldedConv& conv);
  std::string Activate(const std::string& in, Activation activation);
  std::string Binary(const std::string& op, const std::string& a, const std::string& b);
  std::string Unary(const std::string& op, const std::string& in);
  std::string HardSigmoid(const std::string& in);
  std::string Concat(const std::vector<std::string>& ins);
  std::string UpsampleTwice(const std::string& in);
  std::string MaxPool(const std::string& in, int kernel);

  /// The file's bytes.
  std::string Bytes(const std::string& graph_name) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace yorb
