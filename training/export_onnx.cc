// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/export_onnx.h"

#include "core/text.h"
#include "detection/class_names.h"
#include "training/onnx_graph.h"

namespace yorb {
namespace {

/// "[a, b, c]", the elements as `text_of` writes them.
template <typename Range, typename TextOf>
std::string ListText(const Range& values, const TextOf& text_of) {
  std::string text;
  for (const auto& value : values) {
    if (!text.empty()) text += ", ";
    text += text_of(value);
  }
  return std::string("[").append(text).append("]");
}

std::string AnchorsText(const Layout& layout) {
  const auto pair = [](const Anchor& a) {
    return FormatShortest(a.width_px).append(", ").append(FormatShortest(a.height_px));
  };
  return ListText(layout.anchors, [&](const auto& level) { return ListText(level, pair); });
}

std::string ConvNormTo(OnnxGraph& graph, const std::string& name, const std::string& in, const ConvNorm& conv_norm) {
  return graph.Activate(graph.Conv(name, in, Fold(*conv_norm)), conv_norm->spec.activation);
}

std::string MobileBlockTo(OnnxGraph& graph, const std::string& name, const std::string& in, const MobileBlock& block) {
  std::string x = in;
  if (block.expand) x = ConvNormTo(graph, name + ".expand", x, block.expand);
  x = ConvNormTo(graph, name + ".dw", x, block.dw);
  if (block.se) {
    const std::string mean = graph.Unary("GlobalAveragePool", x);
    const auto plain = [](const torch::nn::Conv2d& conv) { return FoldedConv{conv->weight, conv->bias}; };
    const std::string squeezed = graph.Unary("Relu", graph.Conv(name + ".se.fc1", mean, plain(block.se->fc1)));
    const std::string weights = graph.HardSigmoid(graph.Conv(name + ".se.fc2", squeezed, plain(block.se->fc2)));
    // In this order: OpenCV 4.6 takes any Mul(x, HardSigmoid(y)) for a hard swish of y.
    x = graph.Binary("Mul", weights, x);
  }
  x = ConvNormTo(graph, name + ".project", x, block.project);
  return block.has_shortcut ? graph.Binary("Add", x, in) : x;
}

std::string C3To(OnnxGraph& graph, const std::string& name, const std::string& in, const C3Row& row) {
  std::string x = ConvNormTo(graph, name + ".cv1", in, row.cv1);
  for (size_t i = 0; i < row.bottlenecks.size(); ++i) {
    const Bottleneck& bottleneck = row.bottlenecks[i];
    const std::string part = name + ".bottleneck" + std::to_string(i);
    const std::string first = ConvNormTo(graph, part + ".cv1", x, bottleneck->cv1);
    const std::string y = ConvNormTo(graph, part + ".cv2", first, bottleneck->cv2);
    x = bottleneck->has_shortcut ? graph.Binary("Add", x, y) : y;
  }
  const std::string side = ConvNormTo(graph, name + ".cv2", in, row.cv2);
  return ConvNormTo(graph, name + ".cv3", graph.Concat({x, side}), row.cv3);
}

std::string SppfTo(OnnxGraph& graph, const std::string& name, const std::string& in, const SppfRow& row) {
  std::vector<std::string> parts{ConvNormTo(graph, name + ".cv1", in, row.cv1)};
  for (int i = 0; i < 3; ++i) parts.push_back(graph.MaxPool(parts.back(), row.kernel));
  return ConvNormTo(graph, name + ".cv2", graph.Concat(parts), row.cv2);
}

/// The first row with the picture's normalisation folded in. Exact at the borders, too, since the network pads the
/// picture before it normalises.
std::string FirstRowTo(OnnxGraph& graph, const std::string& in, const ConvRow& row, int padding) {
  FoldedConv conv = Fold(*row.conv_norm);
  const auto as_tensor = [](const std::array<float, 3>& v) {
    return torch::tensor({v[0], v[1], v[2]}).view({1, 3, 1, 1});
  };
  conv.weight = conv.weight / as_tensor(PictureDeviation());
  conv.bias = conv.bias - (conv.weight * as_tensor(PictureMean())).sum({1, 2, 3});
  conv.padding = padding;
  return graph.Activate(graph.Conv("0", in, conv), row.conv_norm->spec.activation);
}

std::string RowTo(OnnxGraph& graph, const std::string& name, const std::vector<std::string>& ins, const RowImpl& row) {
  if (const auto* conv = dynamic_cast<const ConvRow*>(&row)) return ConvNormTo(graph, name, ins[0], conv->conv_norm);
  if (const auto* block = dynamic_cast<const MobileBlock*>(&row)) return MobileBlockTo(graph, name, ins[0], *block);
  if (const auto* c3 = dynamic_cast<const C3Row*>(&row)) return C3To(graph, name, ins[0], *c3);
  if (const auto* sppf = dynamic_cast<const SppfRow*>(&row)) return SppfTo(graph, name, ins[0], *sppf);
  if (dynamic_cast<const UpsampleRow*>(&row) != nullptr) return graph.UpsampleTwice(ins[0]);
  return graph.Concat(ins);
}

}  // namespace

std::string ExportOnnx(Network network, const ClassTable& table, const cv::Size& size,
                       const std::vector<int>& stills_px) {
  const torch::NoGradGuard no_grad;
  const Layout& layout = network->layout;
  OnnxGraph graph;
  const std::string images = graph.Input("images", {1, 3, size.height, size.width});
  std::vector<std::string> values;
  for (size_t i = 0; i < layout.rows.size(); ++i) {
    if (i == 0) {
      const auto& first = dynamic_cast<const ConvRow&>(*network->rows[0]);
      values.push_back(FirstRowTo(graph, images, first, layout.rows[0].padding));
      continue;
    }
    std::vector<std::string> ins;
    for (const int from : layout.rows[i].from) ins.push_back(values[from < 0 ? i - 1 : static_cast<size_t>(from)]);
    values.push_back(RowTo(graph, std::to_string(i), ins, *network->rows[i]));
  }
  for (size_t level = 0; level < 3; ++level) {
    const int stride = layout.strides[level];
    const auto& head = network->heads[level];
    const std::string& from = values[static_cast<size_t>(layout.detect_from[level])];
    const std::string out = graph.Conv("stride" + std::to_string(stride), from, {head->weight, head->bias});
    graph.Output(out, {1, layout.NumHeadChannels(), size.height / stride, size.width / stride});
  }
  const auto number = [](int value) { return std::to_string(value); };
  graph.Metadata("description", layout.name + " of yorb-slam");
  graph.Metadata("license", "BSD-3-Clause");
  graph.Metadata("names", ClassNamesText(table.names));
  graph.Metadata("stride", ListText(layout.strides, number));
  graph.Metadata("anchors", AnchorsText(layout));
  graph.Metadata("imgsz", ListText(std::array<int, 2>{size.height, size.width}, number));
  if (!stills_px.empty()) graph.Metadata("stills", ListText(stills_px, number));
  return graph.Bytes(layout.name);
}

}  // namespace yorb
