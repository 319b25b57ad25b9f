// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/check.h"

namespace yorb {
namespace {

using Kind = LayerSpec::Kind;

/// The standard anchors of YOLOv5, found on COCO at 640 px; small ones first.
constexpr std::array<std::array<Anchor, 3>, 3> kStandardAnchors{
    {{{{10, 13}, {16, 30}, {33, 23}}}, {{{30, 61}, {62, 45}, {59, 119}}}, {{{116, 90}, {156, 198}, {373, 326}}}}};

LayerSpec Conv(int out, int kernel, int stride, Activation activation) {
  return {.kind = Kind::kConv,
          .out = out,
          .kernel = kernel,
          .stride = stride,
          .padding = kernel / 2,
          .activation = activation};
}

LayerSpec C3(int out, int repeats, bool has_shortcut, Activation activation) {
  return {.kind = Kind::kC3, .out = out, .repeats = repeats, .has_shortcut = has_shortcut, .activation = activation};
}

LayerSpec Upsample() { return {.kind = Kind::kUpsample}; }

LayerSpec Concat(int other) { return {.kind = Kind::kConcat, .from = {-1, other}}; }

struct Block {
  int out, hidden, kernel, stride;
  bool has_se, is_hard_swish;
};

/// Table 1, rows 1 to 11: MobileNetV3-small.
constexpr std::array<Block, 11> kMobileNetSmall{{{16, 16, 3, 2, true, false},
                                                 {24, 72, 3, 2, false, false},
                                                 {24, 88, 3, 1, false, false},
                                                 {40, 96, 5, 2, true, true},
                                                 {40, 240, 5, 1, true, true},
                                                 {40, 240, 5, 1, true, true},
                                                 {48, 120, 5, 1, true, true},
                                                 {48, 144, 5, 1, true, true},
                                                 {96, 288, 5, 2, true, true},
                                                 {96, 576, 5, 1, true, true},
                                                 {96, 576, 5, 1, true, true}}};

void AppendMobileNet(Layout& layout) {
  layout.rows.push_back(Conv(16, 3, 2, Activation::kHardSwish));
  for (const Block& block : kMobileNetSmall) {
    layout.rows.push_back({.kind = Kind::kMobileBlock,
                           .out = block.out,
                           .kernel = block.kernel,
                           .stride = block.stride,
                           .padding = block.kernel / 2,
                           .hidden = block.hidden,
                           .has_se = block.has_se,
                           .activation = block.is_hard_swish ? Activation::kHardSwish : Activation::kRelu});
  }
}

struct HeadSizes {
  std::array<int, 3> channels;  // at strides 8, 16, 32
  int repeats;                  // bottlenecks of each C3
  Activation activation;
};

/// The two ways of features, down and up again (a path-aggregation network), on rows `p3` and `p4` and the last one.
void AppendHead(Layout& layout, int p3, int p4, const HeadSizes& sizes) {
  const auto [small, middle, large] = sizes.channels;
  const Activation act = sizes.activation;
  const auto c3 = [&](int out) { return C3(out, sizes.repeats, false, act); };
  const int first = static_cast<int>(layout.rows.size());
  const std::vector<LayerSpec> head{
      Conv(middle, 1, 1, act), Upsample(),        Concat(p4), c3(middle),  // first + 0 ... 3
      Conv(small, 1, 1, act),  Upsample(),        Concat(p3), c3(small),   // first + 4 ... 7, detects at stride 8
      Conv(small, 3, 2, act),  Concat(first + 4), c3(middle),              // first + 8 ... 10, stride 16
      Conv(middle, 3, 2, act), Concat(first),     c3(large)};              // first + 11 ... 13, stride 32
  layout.rows.insert(layout.rows.end(), head.begin(), head.end());
  layout.detect_from = {first + 7, first + 10, first + 13};
}

Layout YoloMo(double width) {
  Layout layout;
  AppendMobileNet(layout);
  layout.num_backbone_rows = static_cast<int>(layout.rows.size());
  const auto wide = [&](int channels) { return MakeDivisible(channels * width); };
  AppendHead(layout, 3, 8, {{wide(128), wide(256), wide(512)}, 1, Activation::kHardSwish});
  return layout;
}

/// YOLOv5 v6.1 with its multiples of depth and width.
Layout YoloV5(double depth, double width) {
  Layout layout;
  const Activation act = Activation::kSilu;
  const auto wide = [&](int channels) { return MakeDivisible(channels * width); };
  const auto deep = [&](int repeats) { return std::max(1, static_cast<int>(std::lround(repeats * depth))); };
  LayerSpec stem = Conv(wide(64), 6, 2, act);
  stem.padding = 2;
  layout.rows.push_back(stem);
  int repeats[] = {3, 6, 9, 3};
  for (int level = 0; level < 4; ++level) {
    const int out = wide(128 << level);
    layout.rows.push_back(Conv(out, 3, 2, act));
    layout.rows.push_back(C3(out, deep(repeats[level]), true, act));
  }
  layout.rows.push_back({.kind = Kind::kSppf, .out = wide(1024), .kernel = 5, .activation = act});
  layout.num_backbone_rows = static_cast<int>(layout.rows.size());
  AppendHead(layout, 4, 6, {{wide(256), wide(512), wide(1024)}, deep(3), act});
  return layout;
}

}  // namespace

int MakeDivisible(double value) {
  const int rounded = std::max(8, static_cast<int>(value + 4) / 8 * 8);
  return rounded < 0.9 * value ? rounded + 8 : rounded;
}

const std::vector<std::string>& LayoutNames() {
  static const std::vector<std::string> names{"yolo-mo", "yolo-mo-n", "yolov5n", "yolov5s"};
  return names;
}

Layout MakeLayout(const std::string& name, int num_classes) {
  Layout layout;
  if (name == "yolo-mo") layout = YoloMo(1.0);
  if (name == "yolo-mo-n") layout = YoloMo(0.5);
  if (name == "yolov5n") layout = YoloV5(0.33, 0.25);
  if (name == "yolov5s") layout = YoloV5(0.33, 0.5);
  YORB_CHECK(!layout.rows.empty(), "MakeLayout wants one of LayoutNames");
  layout.name = name;
  layout.num_classes = num_classes;
  layout.anchors = kStandardAnchors;
  return layout;
}

std::string KindName(Kind kind) {
  switch (kind) {
    case Kind::kConv:
      return "Conv";
    case Kind::kMobileBlock:
      return "MobileNet_Block";
    case Kind::kC3:
      return "C3";
    case Kind::kSppf:
      return "SPPF";
    case Kind::kUpsample:
      return "Upsample";
    case Kind::kConcat:
      return "Concat";
  }
  return "?";
}

std::vector<int> OutChannels(const Layout& layout) {
  std::vector<int> channels;
  for (const LayerSpec& row : layout.rows) {
    const auto channels_of = [&](int from) { return from < 0 ? channels.back() : channels[static_cast<size_t>(from)]; };
    if (row.kind == Kind::kUpsample) {
      channels.push_back(channels_of(row.from.front()));
    } else if (row.kind == Kind::kConcat) {
      channels.push_back(std::accumulate(row.from.begin(), row.from.end(), 0,
                                         [&](int sum, int from) { return sum + channels_of(from); }));
    } else {
      channels.push_back(row.out);
    }
  }
  return channels;
}

}  // namespace yorb
