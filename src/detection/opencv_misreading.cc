// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Each rule was found by comparing OpenCV 4.6 with the formulas of ONNX.
#include "detection/opencv_misreading.h"

#include <algorithm>
#include <map>

#include "detection/engine.h"
#include "detection/net_program.h"

namespace yorb {
namespace {

using Dims = std::vector<int64_t>;

int64_t SizeOf(const Dims& dims) {
  int64_t size = 1;
  for (const int64_t dim : dims) size *= dim;
  return size;
}

bool AreAll(const Dims& numbers, int64_t value) {
  return std::all_of(numbers.begin(), numbers.end(), [&](int64_t number) { return number == value; });
}

/// The nodes of a network, and where what they read comes from.
class Graph {
 public:
  explicit Graph(const OnnxModel& model) : opset(model.opset) {
    for (const OnnxTensor& tensor : model.constants) constants_[tensor.name] = &tensor;
    for (const OnnxNode& node : model.nodes) {
      for (const std::string& output : node.outputs) makers_[output] = &node;
      const OnnxAttribute* value = node.op == "Constant" ? node.Find("value") : nullptr;
      if (value != nullptr && value->tensor && !node.outputs.empty()) constants_[node.outputs[0]] = &*value->tensor;
    }
  }

  /// Null for what is computed, and where the input is left out.
  const OnnxTensor* Constant(const OnnxNode& node, size_t input) const {
    const auto found = input < node.inputs.size() ? constants_.find(node.inputs[input]) : constants_.end();
    return found == constants_.end() ? nullptr : found->second;
  }

  /// The operator that makes an input; empty for constants and the picture.
  std::string MakerOf(const OnnxNode& node, size_t input) const {
    const auto found = input < node.inputs.size() ? makers_.find(node.inputs[input]) : makers_.end();
    return found == makers_.end() ? std::string() : found->second->op;
  }

  const int64_t opset;

 private:
  std::map<std::string, const OnnxTensor*> constants_;
  std::map<std::string, const OnnxNode*> makers_;
};

/// The odd pixel of the edge goes to the other side; where all is symmetric there is none.
std::string OddEdge(const OnnxNode& node) {
  const Dims kernel = node.Integers("kernel_shape", {});
  const bool is_odd = std::all_of(kernel.begin(), kernel.end(), [](int64_t side) { return side % 2 == 1; });
  const bool is_symmetric = is_odd && AreAll(node.Integers("strides", {}), 1);
  return node.Text("auto_pad", "NOTSET") == "SAME_LOWER" && !is_symmetric ? "its edge is of the kind SAME_LOWER" : "";
}

std::string AveragePoolInFile(const Graph&, const OnnxNode& node) {
  const bool has_edge = !AreAll(node.Integers("pads", {}), 0) || node.Text("auto_pad", "N")[0] == 'S';
  if (has_edge && node.Integer("count_include_pad", 0) != 0) return "its edge counts, too (count_include_pad)";
  return OddEdge(node);
}

std::string MaxPoolInFile(const Graph&, const OnnxNode& node) {
  return AreAll(node.Integers("dilations", {}), 1) ? OddEdge(node) : "its window has gaps (dilations)";
}

std::string ConvInFile(const Graph&, const OnnxNode& node) { return OddEdge(node); }

std::string ConvTransposeInFile(const Graph&, const OnnxNode& node) {
  if (!AreAll(node.Integers("dilations", {}), 1)) return "its window has gaps (dilations)";
  return node.Find("output_shape") != nullptr ? "it states the size of its output" : "";
}

/// Slopes are taken for those of the channels, whichever axis they are of.
std::string PReluInFile(const Graph& graph, const OnnxNode& node) {
  const OnnxTensor* slope = graph.Constant(node, 1);
  if (slope == nullptr || slope->dims.size() < 2) return "";
  for (size_t i = 0; i < slope->dims.size(); ++i) {
    const bool is_channels = i + 3 == slope->dims.size();
    if (!is_channels && slope->dims[i] != 1) return "its slopes are not those of channels";
  }
  return "";
}

std::string SplitInFile(const Graph& graph, const OnnxNode& node) {
  const OnnxTensor* sizes = graph.Constant(node, 1);
  const bool is_uneven = sizes != nullptr && !sizes->ints.empty() && !AreAll(sizes->ints, sizes->ints[0]);
  return is_uneven ? "its parts are of different sizes" : "";
}

std::string GemmInFile(const Graph&, const OnnxNode& node) {
  const bool is_plain = node.Number("alpha", 1) == 1 && (node.Number("beta", 1) == 1 || node.inputs.size() < 3);
  return is_plain ? "" : "it has factors (alpha, beta)";
}

std::string CumSumInFile(const Graph& graph, const OnnxNode& node) {
  const OnnxTensor* axis = graph.Constant(node, 1);
  const bool is_plain =
      axis != nullptr && axis->ints == Dims{-1} && node.Integer("exclusive", 0) == 0 && node.Integer("reverse", 0) == 0;
  return is_plain ? "" : "only sums along the last axis (-1) are right";
}

std::string DequantizeInFile(const Graph& graph, const OnnxNode& node) {
  return graph.MakerOf(node, 0) == "QuantizeLinear" ? "what is quantised and turned back at once becomes 0" : "";
}

/// OpenCV aborts the program there.
std::string GatherInFile(const Graph& graph, const OnnxNode& node) {
  const bool is_computed = graph.Constant(node, 0) == nullptr && graph.MakerOf(node, 0) != "Shape";
  return is_computed && node.Integer("axis", 0) < 0 ? "its axis is counted from the end" : "";
}

/// OpenCV takes one axis, ONNX before opset 13 that one and all behind it; and where none is stated OpenCV takes the
/// second.
std::string SoftmaxOfShapes(const Graph& graph, const OnnxNode& node, const std::vector<Dims>& shapes) {
  const Dims& dims = shapes[0];
  const auto rank = static_cast<int64_t>(dims.size());
  const bool is_stated = node.Find("axis") != nullptr;
  int64_t axis = node.Integer("axis", 1);
  axis += axis < 0 ? rank : 0;
  if (axis < 0 || axis >= rank) return "";
  if (graph.opset >= 13) return is_stated || axis == rank - 1 ? "" : "its axis is left out";
  return SizeOf(Dims(dims.begin() + axis + 1, dims.end())) == 1 ? "" : "it is over several axes (opset below 13)";
}

/// OpenCV divides the larger by the smaller.
std::string DivOfShapes(const Graph& graph, const OnnxNode& node, const std::vector<Dims>& shapes) {
  if (shapes.size() != 2 || shapes[1].empty()) return "";
  const OnnxTensor* first = graph.Constant(node, 0);
  if (first != nullptr && first->size() > 1) return "constants are divided by what is computed";
  const bool is_repeated = !shapes[0].empty() && SizeOf(shapes[0]) < SizeOf(shapes[1]);
  return is_repeated ? "its first input is repeated along an axis" : "";
}

std::string ComparisonOfShapes(const Graph& graph, const OnnxNode& node, const std::vector<Dims>& shapes) {
  const bool is_turned = graph.Constant(node, 0) != nullptr && shapes.size() == 2 && !shapes[1].empty();
  return is_turned ? "a constant is compared with what is computed" : "";
}

/// It is passed over: fractions stay. Without shapes it is one of constants, which are right.
std::string CastOfShapes(const Graph& graph, const OnnxNode& node, const std::vector<Dims>& shapes) {
  const int64_t type = node.Integer("to", kOnnxFloat);
  const bool is_of_floats = IsFloatType(type);
  const std::string maker = graph.MakerOf(node, 0);
  constexpr const char* kWhole[] = {"ArgMax", "ArgMin", "Floor", "Ceil", "Round", "Equal", "Greater", "Less", "Shape"};
  const bool is_whole = std::find(std::begin(kWhole), std::end(kWhole), maker) != std::end(kWhole);
  return shapes[0].empty() || is_of_floats || is_whole ? "" : "numbers that are computed become whole";
}

/// The words of the engine that knows how ONNX places pixels.
std::string ResizeOfShapes(const Graph& graph, const OnnxNode& node, const std::vector<Dims>& shapes) {
  if (shapes[0].size() != 4) return "";
  NetProgram program;
  NetNode ready{node, {NewConstant({})}, program, graph.opset};
  ready.inputs[0].dims = shapes[0];
  for (size_t i = 1; i < node.inputs.size(); ++i) {
    const OnnxTensor* tensor = graph.Constant(node, i);
    ready.inputs.push_back(tensor == nullptr ? NetValue() : Filled(NewConstant(tensor->dims), *tensor));
  }
  const auto read = EnlargementOf(ready);
  const std::string reason = read ? "" : read.error().message;
  const size_t end = reason.find(kNorByOpenCv);
  return end == std::string::npos ? "" : reason.substr(2, end - 2);
}

using InFile = std::string (*)(const Graph&, const OnnxNode&);
using OfShapes = std::string (*)(const Graph&, const OnnxNode&, const std::vector<Dims>&);

}  // namespace

std::string MisreadingInFile(const OnnxModel& model) {
  static const std::map<std::string, InFile> rules{{"AveragePool", AveragePoolInFile},
                                                   {"MaxPool", MaxPoolInFile},
                                                   {"Conv", ConvInFile},
                                                   {"ConvTranspose", ConvTransposeInFile},
                                                   {"PRelu", PReluInFile},
                                                   {"Split", SplitInFile},
                                                   {"Gemm", GemmInFile},
                                                   {"CumSum", CumSumInFile},
                                                   {"DequantizeLinear", DequantizeInFile},
                                                   {"Gather", GatherInFile}};
  const Graph graph(model);
  for (const OnnxNode& node : model.nodes) {
    const auto rule = rules.find(node.op);
    const std::string reason = rule == rules.end() ? "" : rule->second(graph, node);
    if (!reason.empty()) return node.op + ": " + reason;
  }
  return "";
}

std::string MisreadingOfShapes(const OnnxModel& model, const ShapeOfValue& shape_of) {
  static const std::map<std::string, OfShapes> rules{{"Softmax", SoftmaxOfShapes}, {"LogSoftmax", SoftmaxOfShapes},
                                                     {"Div", DivOfShapes},         {"Greater", ComparisonOfShapes},
                                                     {"Less", ComparisonOfShapes}, {"Cast", CastOfShapes},
                                                     {"Resize", ResizeOfShapes},   {"Upsample", ResizeOfShapes}};
  const Graph graph(model);
  for (const OnnxNode& node : model.nodes) {
    const auto rule = rules.find(node.op);
    if (rule == rules.end() || node.inputs.empty()) continue;
    std::vector<Dims> shapes;
    for (const std::string& input : node.inputs) shapes.push_back(shape_of(input));
    const std::string reason = rule->second(graph, node, shapes);
    if (!reason.empty()) return node.op + ": " + reason;
  }
  return "";
}

}  // namespace yorb
