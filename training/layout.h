// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

namespace yorb {

enum class Activation { kNone, kRelu, kHardSwish, kSilu };

/// One row of a network's table, as Table 1 of the paper has them.
struct LayerSpec {
  enum class Kind {
    kConv,         ///< convolution, batch norm, activation
    kMobileBlock,  ///< inverted residual of MobileNetV3: expand, depth-wise, squeeze-and-excite, project
    kC3,           ///< cross-stage block of `repeats` bottlenecks
    kSppf,         ///< three max poolings in a row, joined
    kUpsample,     ///< nearest, twice the size
    kConcat,       ///< along the channels
  };
  Kind kind = Kind::kConv;
  std::vector<int> from = {-1};  ///< rows that it reads; -1 is the row before
  int out = 0;                   ///< channels
  int kernel = 1, stride = 1, padding = 0;
  int hidden = 0;            ///< kMobileBlock: channels within
  int repeats = 1;           ///< kC3
  bool has_se = false;       ///< kMobileBlock
  bool has_shortcut = true;  ///< kC3: around each bottleneck
  Activation activation = Activation::kSilu;
  double norm_epsilon = 1e-3;
};

struct Anchor {
  float width_px = 0, height_px = 0;
};

/// A whole detector: its rows, and the three that the heads read.
struct Layout {
  std::string name;
  std::vector<LayerSpec> rows;
  int num_backbone_rows = 0;
  std::array<int, 3> detect_from{};
  std::array<int, 3> strides{8, 16, 32};
  std::array<std::array<Anchor, 3>, 3> anchors{};
  int num_classes = 0;

  /// Channels of each head: three anchors, each with four numbers of the box, objectness and the classes.
  int NumHeadChannels() const { return 3 * (5 + num_classes); }
};

/// The names that `MakeLayout` knows: yolo-mo, yolo-mo-n, yolov5n, yolov5s.
const std::vector<std::string>& LayoutNames();

/// The layout of that name, which must be one of `LayoutNames`.
Layout MakeLayout(const std::string& name, int num_classes);

/// "C3", "MobileNet_Block" and the like, for tables.
std::string KindName(LayerSpec::Kind kind);

/// Channels that go out of each row.
std::vector<int> OutChannels(const Layout& layout);

/// `value` as the nearest multiple of 8 that is not under nine tenths of it.
int MakeDivisible(double value);

}  // namespace yorb
