// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/head_layout.h"

#include <algorithm>
#include <optional>

#include "detection/edge_maps.h"

namespace yorb {
namespace {

using Shape = std::vector<int64_t>;

/// The strides that networks have maps of, the common ones first.
const std::vector<std::vector<int>>& StrideSets() {
  static const std::vector<std::vector<int>> sets{{8, 16, 32}, {8, 16, 32, 64}, {4, 8, 16, 32}, {16, 32}};
  return sets;
}

int64_t NumCells(const std::vector<int>& strides, const HeadFacts& facts) {
  int64_t cells = 0;
  for (const int stride : strides) cells += int64_t{facts.width / stride} * (facts.height / stride);
  return cells;
}

bool IsNumberOfCells(int64_t count, const HeadFacts& facts) {
  return std::any_of(StrideSets().begin(), StrideSets().end(),
                     [&](const std::vector<int>& strides) { return NumCells(strides, facts) == count; });
}

/// Rows of six that are no end-to-end rows: one class and objectness, a row a cell (YOLOv6, YOLOX), or YOLOv8's two
/// classes turned round. Read as corners they would be nonsense.
bool AreSixOfAnotherNetwork(int64_t num_rows, const HeadFacts& facts) {
  return IsNumberOfCells(num_rows, facts) && facts.num_names <= 2;
}

/// How many numbers stand behind the class scores: the coefficients of a segmentation network, which has that many
/// maps at a quarter of the size as another output; the points of a pose network.
int64_t NumExtras(const HeadFacts& facts) {
  for (const Shape& shape : facts.shapes) {
    if (shape.size() == 4 && shape[2] == facts.height / 4 && shape[3] == facts.width / 4) return shape[1];
  }
  return facts.num_keypoint_values;
}

/// Which other output holds the boxes of this one's rows or columns: those of YOLO-NAS, and of exports whose parts
/// stand apart. Read alone, the scores would pass for boxes.
std::optional<size_t> BoxesApart(size_t output, const HeadFacts& facts) {
  const Shape& scores = facts.shapes[output];
  for (size_t i = 0; i < facts.shapes.size() && scores.size() == 3; ++i) {
    Shape boxes = facts.shapes[i];
    if (boxes.size() == 4 && boxes[2] == 1) boxes.erase(boxes.begin() + 2);
    if (i == output || boxes.size() != 3) continue;
    if ((boxes[2] == 4 && boxes[1] == scores[1]) || (boxes[1] == 4 && boxes[2] == scores[2])) return i;
  }
  return std::nullopt;
}

bool HasBoxesApart(size_t output, const HeadFacts& facts) { return BoxesApart(output, facts).has_value(); }

bool AgreesWithNames(int64_t num_classes, const HeadFacts& facts) {
  return num_classes > 0 && (facts.num_names == 0 || facts.num_names == num_classes);
}

/// Whether it is that of the names, or without names COCO's.
bool IsNumberOfClasses(int64_t count, const HeadFacts& facts) {
  constexpr int kCoco = 80;
  return count == (facts.num_names > 0 ? facts.num_names : kCoco);
}

/// The layout of one output that holds all boxes.
std::optional<HeadLayout> FromRows(size_t output, const HeadFacts& facts) {
  const Shape& shape = facts.shapes[output];
  if (shape.size() != 3 || HasBoxesApart(output, facts)) return std::nullopt;
  const int64_t extras = NumExtras(facts);
  HeadLayout layout;
  layout.output = output;
  const auto take = [&](LayoutKind kind, int64_t num_classes) {
    layout.kind = kind;
    layout.num_classes = static_cast<int>(num_classes);
    return layout;
  };
  const bool has_anchors = shape[1] % kAnchors == 0 && IsNumberOfCells(shape[1] / kAnchors, facts);
  if (has_anchors && AgreesWithNames(shape[2] - 5 - extras, facts))
    return take(LayoutKind::kAnchorRows, shape[2] - 5 - extras);
  // Of (1, 84, 85), YOLOX's for 64x64, both might be cells; those of three strides are the likelier ones.
  const bool is_known_behind_objectness = shape[2] - 5 - extras > 1 && IsNumberOfClasses(shape[2] - 5 - extras, facts);
  const auto is_usual = [&](int64_t count) { return count == NumCells(StrideSets()[0], facts); };
  if (is_known_behind_objectness && is_usual(shape[1]) && !is_usual(shape[2]))
    return take(LayoutKind::kCellRows, shape[2] - 5 - extras);
  if (IsNumberOfCells(shape[2], facts) && AgreesWithNames(shape[1] - 4 - extras, facts))
    return take(LayoutKind::kCentreColumns, shape[1] - 4 - extras);
  // Turned round only where names say so, and not for two classes, whose rows could be end-to-end ones.
  const bool are_cells = IsNumberOfCells(shape[1], facts);
  if (are_cells && facts.num_names > 0 && facts.num_names != 2 && facts.num_names == shape[2] - 4 - extras)
    return take(LayoutKind::kCentreRows, facts.num_names);
  if (is_known_behind_objectness && are_cells) return take(LayoutKind::kCellRows, shape[2] - 5 - extras);
  layout.has_all_rows = are_cells || has_anchors;
  if (shape[2] == 6 + extras && !AreSixOfAnotherNetwork(shape[1], facts))
    return take(LayoutKind::kCornerRows, facts.num_names);
  return std::nullopt;
}

/// Boxes of all cells in one output and their scores in another, without a third that might be their objectness.
std::optional<HeadLayout> FromPair(const HeadFacts& facts) {
  for (size_t i = 0; i < facts.shapes.size(); ++i) {
    const auto boxes = BoxesApart(i, facts);
    if (!boxes || facts.shapes[*boxes].size() != 3) continue;
    const Shape &scores = facts.shapes[i], &shape = facts.shapes[*boxes];
    const size_t value_axis = shape[2] == 4 && shape[1] == scores[1] ? 2 : 1;
    const auto num_of_rank_3 =
        std::count_if(facts.shapes.begin(), facts.shapes.end(), [](const Shape& other) { return other.size() == 3; });
    if (num_of_rank_3 != 2 || !AgreesWithNames(scores[value_axis], facts) ||
        CellsOfRows(shape[3 - value_axis], facts).empty())
      continue;
    HeadLayout layout;
    layout.kind = LayoutKind::kBoxesApart;
    layout.output = *boxes, layout.scores = i;
    layout.num_classes = static_cast<int>(scores[value_axis]);
    return layout;
  }
  return std::nullopt;
}

/// The strides and axes of a raw map; nothing where the shape is none. Where anchors have an axis of their own, a box's
/// numbers stand behind the cells or before them.
std::optional<RawMap> MapOf(size_t output, const HeadFacts& facts, bool are_values_last) {
  const Shape& shape = facts.shapes[output];
  RawMap map;
  map.output = output;
  if (shape.size() == 4) {
    map.value_axis = 1, map.y_axis = 2, map.x_axis = 3;
  } else if (shape.size() == 5 && shape[1] == kAnchors) {
    map.anchor_axis = 1;
    map.value_axis = are_values_last ? 4 : 2, map.y_axis = are_values_last ? 2 : 3, map.x_axis = map.y_axis + 1;
  } else {
    return std::nullopt;
  }
  map.height = static_cast<int>(shape[static_cast<size_t>(map.y_axis)]);
  map.width = static_cast<int>(shape[static_cast<size_t>(map.x_axis)]);
  if (map.width < 1 || map.height < 1 || facts.width % map.width != 0) return std::nullopt;
  map.stride = facts.width / map.width;
  const bool is_square = map.height * map.stride == facts.height;
  const bool is_known = map.stride == 8 || map.stride == 16 || map.stride == 32 || map.stride == 64;
  return is_square && is_known ? std::optional(map) : std::nullopt;
}

/// Numbers a box in a raw map; 0 where anchors do not divide them.
int64_t NumValues(const RawMap& map, const HeadFacts& facts) {
  const int64_t size = facts.shapes[map.output][static_cast<size_t>(map.value_axis)];
  if (map.anchor_axis > 0) return size;
  return size % kAnchors == 0 ? size / kAnchors : 0;
}

/// Whether nothing tells maps from YOLOv8's own, which have 64 numbers and one a class: the names are missing, and the
/// maps are put together from edges and classes, where YOLOv5's come from one convolution, and have 255 for COCO's.
bool MayBeWithoutAnchors(const RawMap& map, const HeadFacts& facts) {
  constexpr int64_t kEdges = 64, kCoco = 3 * (5 + 80);
  const int64_t size = facts.shapes[map.output][static_cast<size_t>(map.value_axis)];
  return facts.num_names == 0 && facts.are_joined && map.anchor_axis == 0 && size > kEdges && size != kCoco;
}

std::optional<HeadLayout> FromMaps(const HeadFacts& facts, bool are_values_last) {
  HeadLayout layout;
  for (size_t i = 0; i < facts.shapes.size(); ++i) {
    const auto map = MapOf(i, facts, are_values_last);
    if (map) layout.maps.push_back(*map);
  }
  if (layout.maps.size() != facts.shapes.size() || layout.maps.size() < 3) return std::nullopt;
  std::sort(layout.maps.begin(), layout.maps.end(),
            [](const RawMap& a, const RawMap& b) { return a.stride < b.stride; });
  for (size_t i = 0; i < layout.maps.size(); ++i) {
    if (layout.maps[i].stride != 8 << i) return std::nullopt;
    if (NumValues(layout.maps[i], facts) != NumValues(layout.maps[0], facts)) return std::nullopt;
    if (MayBeWithoutAnchors(layout.maps[i], facts)) return std::nullopt;
  }
  const int64_t num_classes = NumValues(layout.maps[0], facts) - 5;
  if (!AgreesWithNames(num_classes, facts)) return std::nullopt;
  layout.kind = LayoutKind::kRawMaps;
  layout.num_classes = static_cast<int>(num_classes);
  return layout;
}

std::optional<HeadLayout> FindLayout(const HeadFacts& facts) {
  for (size_t i = 0; i < facts.shapes.size(); ++i) {
    if (const auto layout = FromRows(i, facts)) return layout;
  }
  if (const auto layout = FromPair(facts)) return layout;
  for (const bool are_values_last : {true, false}) {
    if (const auto layout = FromMaps(facts, are_values_last)) return layout;
  }
  return EdgeMapsOf(facts);
}

/// "1 class name", "2 class names".
std::string Counted(int count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// What may be done about outputs that are refused for one reason that is known; empty where there is none.
std::string RemedyFor(const HeadFacts& facts) {
  for (size_t i = 0; i < facts.shapes.size(); ++i) {
    if (HasBoxesApart(i, facts)) return "; its boxes and scores stand apart: export it with both in one output";
  }
  const bool has_cells =
      !facts.shapes.empty() && facts.shapes[0].size() == 3 && IsNumberOfCells(facts.shapes[0][1], facts);
  if (has_cells && facts.num_names == 0)
    return "; write the class names, a line each, into a file beside it that has its name and .names behind: they tell "
           "YOLOX's rows from YOLOv8's turned round";
  const auto map = facts.shapes.size() < 3 ? std::nullopt : MapOf(0, facts, true);
  if (map && MayBeWithoutAnchors(*map, facts) && NumValues(*map, facts) > 5)
    return "; whether these are YOLOv8's maps or YOLOv5's is not said: write the class names, a line each, into a file "
           "beside it that has its name and .names behind";
  return "";
}

/// The complaint about a list of names that somebody wrote beside a network which is fine without it.
std::optional<Error> MisfitOfNames(const HeadFacts& facts, const std::string& shapes) {
  if (facts.names_file.empty()) return std::nullopt;
  HeadFacts nameless = facts;
  nameless.num_names = 0;
  const auto layout = FindLayout(nameless);
  if (!layout || layout->num_classes == 0) return std::nullopt;
  return BadInput("does not fit " + facts.names_file + ", which has " + Counted(facts.num_names, "class name") +
                  ": its outputs, " + shapes + ", are of " + std::to_string(layout->num_classes) +
                  (layout->num_classes == 1 ? " class" : " classes") + "; write a line for each class");
}

}  // namespace

std::vector<HeadCell> CellsOfRows(int64_t num_rows, const HeadFacts& facts) {
  std::vector<HeadCell> cells;
  for (const std::vector<int>& strides : StrideSets()) {
    const int64_t count = NumCells(strides, facts);
    const bool has_anchors = num_rows == kAnchors * count;
    if (count == 0 || (num_rows != count && !has_anchors)) continue;
    for (const int stride : strides) {
      const int width = facts.width / stride, size = width * (facts.height / stride);
      for (int i = 0; i < size * (has_anchors ? kAnchors : 1); ++i)
        cells.push_back(
            {static_cast<float>(i % size % width), static_cast<float>(i % size / width), static_cast<float>(stride)});
    }
    return cells;
  }
  return cells;
}

std::string ShapeText(const Shape& dims) {
  std::string text = "(";
  for (size_t i = 0; i < dims.size(); ++i) text += (i > 0 ? ", " : "") + (dims[i] < 0 ? "?" : std::to_string(dims[i]));
  return text + ")";
}

Result<HeadLayout> RecogniseLayout(const HeadFacts& facts) {
  if (const auto layout = FindLayout(facts)) return *layout;
  std::string shapes;
  for (size_t i = 0; i < std::min<size_t>(facts.shapes.size(), 6); ++i)
    shapes += (i > 0 ? ", " : "") + ShapeText(facts.shapes[i]);
  if (const auto misfit = MisfitOfNames(facts, shapes)) return *misfit;
  std::string names = facts.num_names > 0 ? " and " + Counted(facts.num_names, "class name") : "";
  if (facts.num_names > 0 && !facts.names_file.empty()) names += " in " + facts.names_file;
  const bool is_for_else = !facts.task.empty() && facts.task != "detect";
  return BadInput("is no detector that is read" + (is_for_else ? " but, as it says, for '" + facts.task + "'" : "") +
                  ": its outputs are " + shapes + " for an input of " + std::to_string(facts.width) + "x" +
                  std::to_string(facts.height) + names +
                  "; YOLOv5's (1, N, 5+C), YOLOv8's (1, 4+C, N), three raw maps and end-to-end (1, K, 6) are" +
                  RemedyFor(facts));
}

std::string LayoutText(const HeadLayout& layout, const HeadFacts& facts) {
  const auto shape = [&](size_t output) { return ShapeText(facts.shapes[output]); };
  const std::string form = std::string(layout.form == BoxForm::kCorners ? " of corners" : "") +
                           (layout.unit_x != 1 ? " of fractions " : " ");
  switch (layout.kind) {
    case LayoutKind::kAnchorRows:
      return "YOLOv5 rows" + form + shape(layout.output);
    case LayoutKind::kCentreColumns:
      return "YOLOv8 columns" + form + shape(layout.output);
    case LayoutKind::kCentreRows:
      return "YOLOv8 rows" + form + shape(layout.output);
    case LayoutKind::kCellRows:
      return (layout.form == BoxForm::kRelative ? "YOLOX rows " : "rows of all cells ") + shape(layout.output);
    case LayoutKind::kBoxesApart:
      return "boxes" + form + shape(layout.output) + " and scores " + shape(layout.scores);
    case LayoutKind::kCornerRows:
      return "end-to-end rows " + shape(layout.output);
    case LayoutKind::kEdgeMaps:
      return std::to_string(layout.edge_maps.size()) + " maps of YOLOv8's, " + shape(layout.edge_maps[0].edges) +
             " the finest";
    case LayoutKind::kRawMaps:
      break;
  }
  return std::to_string(layout.maps.size()) + " raw maps, " + shape(layout.maps.front().output) + " the finest";
}

}  // namespace yorb
