// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/result.h"

namespace yorb {

constexpr int kAnchors = 3;  ///< of a cell in a map of YOLOv5's

/// How the outputs of a network are to be read.
enum class LayoutKind {
  kAnchorRows,     ///< YOLOv5: (1, N, 5+C), N three times the cells: centre, size, objectness, classes
  kCentreColumns,  ///< YOLOv8 and 11: (1, 4+C, N), N the cells: centre, size, classes
  kCentreRows,     ///< the same turned round: (1, N, 4+C)
  kCellRows,       ///< YOLOX and YOLOv6: (1, N, 5+C), N the cells: box, objectness, classes
  kBoxesApart,     ///< YOLO-NAS: (1, N, 4) and, in an output of their own, the scores, (1, N, C); or both turned round
  kCornerRows,     ///< end to end: (1, K, 6): corners, confidence, class number; doubles are mostly gone already
  kEdgeMaps,       ///< YOLOv8's own maps, a stride each: 64 numbers of the edges, and a score a class, not yet decoded
  kRawMaps,        ///< a map a stride, (1, 3 (5+C), h, w) or with an axis for the anchors, not yet decoded
};

/// What the four numbers of a box are.
enum class BoxForm {
  kCentre,    ///< centre and size, px of the input
  kCorners,   ///< left, top, right, bottom, px of the input
  kRelative,  ///< YOLOX: the centre from the corner of its cell and the logarithm of the size, both in cells
};

/// Where a row's cell lies.
struct HeadCell {
  float column = 0, row = 0, stride = 0;
};

/// One raw map, and the steps between its numbers' axes.
struct RawMap {
  size_t output = 0;  ///< which of the network's outputs
  int stride = 0;     ///< px of the input between cells
  int width = 0, height = 0;
  int anchor_axis = 0, value_axis = 0, y_axis = 0, x_axis = 0;  ///< anchor_axis 0: anchors and values share an axis
};

/// One of YOLOv8's own maps: where its edges and its scores are.
struct EdgeMap {
  size_t edges = 0, scores = 0;  ///< which of the network's outputs
  int64_t first_score = 0;       ///< the channel at which the scores begin
  int num_classes = 0;
  int stride = 0;  ///< px of the input between cells
  int width = 0, height = 0;
};

/// What the outputs of a network hold.
struct HeadLayout {
  LayoutKind kind = LayoutKind::kRawMaps;
  int num_classes = 0;        ///< 0 where the shapes do not say (end to end without names)
  size_t output = 0;          ///< the one that holds the boxes; not for raw maps
  bool has_all_rows = false;  ///< corner rows, one a cell: nothing was chosen among them, and doubles are there
  std::vector<RawMap> maps;   ///< by rising stride
  std::vector<EdgeMap> edge_maps;
  size_t scores = 0;  ///< the output that holds them where they stand apart from the boxes
  BoxForm form = BoxForm::kCentre;
  float unit_x = 1, unit_y = 1;  ///< px of the input in a box's numbers: its size where they are fractions of it
  std::vector<HeadCell> cells;   ///< of each row, where boxes are relative to them
};

/// The outputs' shapes, and what helps to tell layouts of the same shape from each other.
struct HeadFacts {
  std::vector<std::vector<int64_t>> shapes;
  int width = 0, height = 0;    ///< of the input, px
  int num_names = 0;            ///< 0: the file carries none
  bool are_joined = false;      ///< each output is put together from several, as YOLOv8's raw maps are
  int num_keypoint_values = 0;  ///< numbers behind the classes of a pose network; 0: it is none
  std::string names_file;       ///< where the names stand in a file beside the network's
  std::string task;             ///< what the file says that the network is for: "detect", "obb", "classify"
};

/// The cells of so many rows, or of three times as many, in the order of the rows; none where the number fits no
/// strides.
std::vector<HeadCell> CellsOfRows(int64_t num_rows, const HeadFacts& facts);

/// "(1, 84, 8400)".
std::string ShapeText(const std::vector<int64_t>& dims);

/// The layout of these outputs. The error says which shapes there are and has no file name before it.
Result<HeadLayout> RecogniseLayout(const HeadFacts& facts);

/// The layout in words, for the log: "YOLOv8 columns (1, 84, 8400)".
std::string LayoutText(const HeadLayout& layout, const HeadFacts& facts);

}  // namespace yorb
