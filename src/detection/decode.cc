// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/decode.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/text.h"
#include "detection/edge_maps.h"

namespace yorb {
namespace {

constexpr int kObjectness = 4;  // its place among the values of an anchor

/// What the scores of a network are, whether or not they make a box.
class ScoreRange {
 public:
  void See(float score) {
    has_none_ |= std::isnan(score);
    least_ = std::min(least_, score), most_ = std::max(most_, score);
  }

  /// Bad input where they are no probabilities. Quantised ones may be a little beside them.
  Status Check() const {
    constexpr float kOff = .01f;
    if (has_none_) return BadInput("gives scores that are no numbers (NaN); export it in 32 bits");
    if (least_ >= -kOff && most_ <= 1 + kOff) return Status::Ok();
    return BadInput("gives scores from " + FormatFixed(least_, 2) + " to " + FormatFixed(most_, 2) +
                    ", which are no probabilities; export it with the sigmoid");
  }

 private:
  float least_ = 0, most_ = 1;
  bool has_none_ = false;
};

/// Boxes, and the scores that were met on the way.
struct Decoded {
  std::vector<RawBox> boxes;
  ScoreRange scores;
  size_t num_turned = 0;  ///< corner boxes whose right edge lies left of the left one, or bottom above top
};

float Sigmoid(float x) { return 1.f / (1.f + std::exp(-x)); }

/// Where the numbers of one box lie, or its class scores.
struct Scores {
  const float* first;
  int64_t step;
  int count;

  float operator[](int label) const { return first[label * step]; }
};

RawBox FromCentre(float x, float y, float width, float height) {
  return {x - width / 2, y - height / 2, x + width / 2, y + height / 2, 0, 0};
}

bool IsSound(const RawBox& box) {
  return std::isfinite(box.left) && std::isfinite(box.top) && std::isfinite(box.right) && std::isfinite(box.bottom);
}

/// A box from its four numbers, in the layout's form.
RawBox BoxOf(const Scores& numbers, const HeadLayout& layout, size_t row) {
  const float x = numbers[0] * layout.unit_x, y = numbers[1] * layout.unit_y;
  const float width = numbers[2] * layout.unit_x, height = numbers[3] * layout.unit_y;
  if (layout.form == BoxForm::kCorners) return {x, y, width, height, 0, 0};
  if (layout.form == BoxForm::kCentre) return FromCentre(x, y, width, height);
  const HeadCell& cell = layout.cells[row];
  return FromCentre((x + cell.column) * cell.stride, (y + cell.row) * cell.stride, std::exp(width) * cell.stride,
                    std::exp(height) * cell.stride);
}

/// Adds a box for the best class, or for every class, whose score times `factor` reaches the confidence.
template <typename Score>
void AddClasses(RawBox box, int num_classes, const DecodeOptions& options, const Score& score, Decoded& found) {
  const auto least = static_cast<float>(options.confidence);
  const auto add = [&](int label, float confidence) {
    box.confidence = std::min(confidence, 1.f), box.label = label;
    found.boxes.push_back(box);
  };
  int best = 0;
  float most = score(0);
  for (int label = 0; label < num_classes; ++label) {
    const float confidence = score(label);
    if (options.takes_all_classes && confidence >= least) add(label, confidence);
    if (confidence > most) most = confidence, best = label;
  }
  found.scores.See(most);
  if (!options.takes_all_classes && most >= least) add(best, most);
}

/// Rows or columns of centre, size, objectness where there is one, classes.
void DecodeCentres(const TensorView& output, const HeadLayout& layout, const DecodeOptions& options, Decoded& found) {
  const bool has_objectness = layout.kind == LayoutKind::kAnchorRows || layout.kind == LayoutKind::kCellRows;
  const size_t box_axis = layout.kind == LayoutKind::kCentreColumns ? 2 : 1;
  const int64_t count = output.dims[box_axis];
  const int64_t step = output.strides[box_axis], value_step = output.strides[3 - box_axis];
  for (int64_t i = 0; i < count; ++i) {
    const float* at = output.data + i * step;
    const float objectness = has_objectness ? at[kObjectness * value_step] : 1.f;
    found.scores.See(objectness);
    if (!(objectness >= static_cast<float>(options.confidence))) continue;
    const RawBox box = BoxOf({at, value_step, 4}, layout, static_cast<size_t>(i));
    const Scores scores{at + (has_objectness ? 5 : 4) * value_step, value_step, layout.num_classes};
    if (!IsSound(box)) {
      found.scores.See(scores[0]);
      continue;
    }
    AddClasses(
        box, layout.num_classes, options, [&](int label) { return scores[label] * objectness; }, found);
  }
}

/// Boxes in one output, scores in another.
void DecodeApart(const std::vector<TensorView>& outputs, const HeadLayout& layout, const DecodeOptions& options,
                 Decoded& found) {
  const TensorView &boxes = outputs[layout.output], &scores = outputs[layout.scores];
  const bool are_rows = boxes.dims[2] == 4 && boxes.dims[1] == scores.dims[1];
  const size_t row_axis = are_rows ? 1 : 2, value_axis = 3 - row_axis;
  for (int64_t i = 0; i < boxes.dims[row_axis]; ++i) {
    const RawBox box =
        BoxOf({boxes.data + i * boxes.strides[row_axis], boxes.strides[value_axis], 4}, layout, static_cast<size_t>(i));
    const Scores classes{scores.data + i * scores.strides[row_axis], scores.strides[value_axis], layout.num_classes};
    if (!IsSound(box)) continue;
    AddClasses(
        box, layout.num_classes, options, [&](int label) { return classes[label]; }, found);
  }
}

/// Rows of corners, confidence, class number; where there are fewer boxes than rows, some exports fill up with -1.
void DecodeCorners(const TensorView& output, const HeadLayout& layout, const DecodeOptions& options, Decoded& found) {
  constexpr float kMostClasses = 1 << 20;
  for (int64_t i = 0; i < output.dims[1]; ++i) {
    const auto value = [&](int64_t k) { return output.At(0, i, k); };
    const float confidence = value(4), label = value(5);
    if (confidence == -1 || label < 0) continue;
    found.scores.See(confidence);
    RawBox box{value(0), value(1), value(2), value(3), std::min(confidence, 1.f), 0};
    if (!(confidence >= static_cast<float>(options.confidence)) || !IsSound(box)) continue;
    if (!(label < kMostClasses)) continue;
    box.label = static_cast<int>(std::lround(label));
    if (layout.num_classes > 0 && box.label >= layout.num_classes) continue;
    found.num_turned += box.right < box.left || box.bottom < box.top ? 1 : 0;
    found.boxes.push_back(box);
  }
}

/// Compared before the sigmoid is taken, since nearly all cells are empty.
float LeastObjectness(const DecodeOptions& options) {
  const double confidence = std::clamp(options.confidence, 1e-9, 1 - 1e-9);
  return static_cast<float>(options.is_logits ? std::log(confidence / (1 - confidence)) : options.confidence);
}

/// One of YOLOv8's own maps.
void DecodeEdges(const std::vector<TensorView>& outputs, const EdgeMap& map, const DecodeOptions& options,
                 Decoded& found) {
  const TensorView &edges = outputs[map.edges], &scores = outputs[map.scores];
  const auto stride = static_cast<float>(map.stride);
  const float least = LeastObjectness(options);
  for (int cell = 0; cell < map.width * map.height; ++cell) {
    const int x = cell % map.width, y = cell / map.width;
    const Scores classes{
        scores.data + map.first_score * scores.strides[1] + y * scores.strides[2] + x * scores.strides[3],
        scores.strides[1], map.num_classes};
    float most = classes[0];
    for (int label = 0; label < map.num_classes; ++label) {
      if (std::isnan(classes[label])) found.scores.See(classes[label]);
      most = std::max(most, classes[label]);
    }
    if (!(most >= least)) continue;
    const float middle_x = static_cast<float>(x) + .5f, middle_y = static_cast<float>(y) + .5f;
    const auto [left, top, right, bottom] = EdgesAt(edges, x, y);
    const RawBox box{(middle_x - left) * stride,
                     (middle_y - top) * stride,
                     (middle_x + right) * stride,
                     (middle_y + bottom) * stride,
                     0,
                     0};
    const auto score = [&](int label) { return options.is_logits ? Sigmoid(classes[label]) : classes[label]; };
    if (IsSound(box)) AddClasses(box, map.num_classes, options, score, found);
  }
}

/// One raw map: centres relative to their cell, sizes relative to the cell's anchors.
class MapDecoder {
 public:
  MapDecoder(const TensorView& output, const RawMap& map, const DecodeOptions& options)
      : output_(output), map_(map), options_(options) {
    value_step_ = Step(map.value_axis);
    anchor_step_ = map.anchor_axis > 0 ? Step(map.anchor_axis) : value_step_ * output.dims[1] / kAnchors;
    least_ = LeastObjectness(options);
  }

  void Decode(int num_classes, const float* anchors, Decoded& found) const {
    for (int anchor = 0; anchor < kAnchors; ++anchor) {
      for (int y = 0; y < map_.height; ++y) {
        const float* row = output_.data + anchor * anchor_step_ + y * Step(map_.y_axis);
        for (int x = 0; x < map_.width; ++x) {
          const float* at = row + x * Step(map_.x_axis);
          const float objectness = at[kObjectness * value_step_];
          if (std::isnan(objectness)) found.scores.See(objectness);
          if (!(objectness >= least_)) continue;
          Add(at, BoxAt(at, x, y, anchors + 2 * anchor), num_classes, found);
        }
      }
    }
  }

 private:
  int64_t Step(int axis) const { return output_.strides[static_cast<size_t>(axis)]; }
  float Value(const float* at, int64_t k) const {
    return options_.is_logits ? Sigmoid(at[k * value_step_]) : at[k * value_step_];
  }

  RawBox BoxAt(const float* at, int x, int y, const float* anchor) const {
    const auto stride = static_cast<float>(map_.stride);
    const auto sized = [&](int64_t k, float size) { return std::pow(Value(at, k) * 2, 2.f) * size; };
    return FromCentre((Value(at, 0) * 2 - 0.5f + static_cast<float>(x)) * stride,
                      (Value(at, 1) * 2 - 0.5f + static_cast<float>(y)) * stride, sized(2, anchor[0]),
                      sized(3, anchor[1]));
  }

  void Add(const float* at, const RawBox& box, int num_classes, Decoded& found) const {
    if (!IsSound(box)) return;
    const float objectness = Value(at, kObjectness);
    AddClasses(
        box, num_classes, options_, [&](int label) { return Value(at, 5 + label) * objectness; }, found);
  }

  const TensorView& output_;
  const RawMap& map_;
  const DecodeOptions& options_;
  int64_t value_step_ = 0, anchor_step_ = 0;
  float least_ = 0;
};

}  // namespace

const std::vector<float>& StandardAnchors() {
  static const std::vector<float> anchors{10, 13, 16, 30, 33, 23, 30, 61, 62, 45, 59, 119, 116, 90, 156, 198, 373, 326};
  return anchors;
}

Result<std::vector<RawBox>> DecodeBoxes(const std::vector<TensorView>& outputs, const HeadLayout& layout,
                                        const DecodeOptions& options) {
  Decoded found;
  switch (layout.kind) {
    case LayoutKind::kAnchorRows:
    case LayoutKind::kCentreColumns:
    case LayoutKind::kCentreRows:
    case LayoutKind::kCellRows:
      DecodeCentres(outputs[layout.output], layout, options, found);
      break;
    case LayoutKind::kBoxesApart:
      DecodeApart(outputs, layout, options, found);
      break;
    case LayoutKind::kEdgeMaps:
      for (const EdgeMap& map : layout.edge_maps) DecodeEdges(outputs, map, options, found);
      break;
    case LayoutKind::kCornerRows:
      DecodeCorners(outputs[layout.output], layout, options, found);
      break;
    case LayoutKind::kRawMaps:
      for (size_t i = 0; i < layout.maps.size(); ++i) {
        const RawMap& map = layout.maps[i];
        const MapDecoder decoder(outputs[map.output], map, options);
        decoder.Decode(layout.num_classes, options.anchors.data() + 2 * kAnchors * i, found);
      }
      break;
  }
  if (Status status = found.scores.Check(); !status) return status.error();
  if (found.num_turned > 0 && found.num_turned == found.boxes.size())
    return BadInput(
        "gives rows that begin with no corners, for right edges lie left of the left ones; export it with left, top, "
        "right, bottom");
  return std::move(found.boxes);
}

bool LookLikeFractions(const std::vector<RawBox>& boxes) {
  constexpr float kReach = 1.5f;  // px: fractions go a little beyond the edges of the picture, too
  const auto is_in_corner = [](const RawBox& box) {
    return std::abs(box.left) < kReach && std::abs(box.top) < kReach && std::abs(box.right) < kReach &&
           std::abs(box.bottom) < kReach && box.right - box.left < kReach && box.bottom - box.top < kReach;
  };
  const auto has_area = [](const RawBox& box) { return box.right > box.left && box.bottom > box.top; };
  return std::all_of(boxes.begin(), boxes.end(), is_in_corner) && std::any_of(boxes.begin(), boxes.end(), has_area);
}

ObjectnessRead ObjectnessOf(int64_t num_channels, const DecodeOptions& options) {
  ObjectnessRead read;
  for (int64_t anchor = 0; anchor < kAnchors; ++anchor)
    read.channels.push_back(anchor * (num_channels / kAnchors) + kObjectness);
  read.least = LeastObjectness(options);
  return read;
}

bool HaveClassNumbers(const TensorView& rows) {
  constexpr float kOff = 1e-3f;
  for (int64_t i = 0; i < rows.dims[1]; ++i) {
    const float label = rows.At(0, i, 5);
    if (std::isnan(rows.At(0, i, 4))) continue;  // no number at all, which is said when it is decoded
    if (!(std::abs(label - std::round(label)) <= kOff)) return false;
  }
  return true;
}

bool LookLikeLogits(const std::vector<TensorView>& outputs, const HeadLayout& layout) {
  for (const RawMap& map : layout.maps) {
    const TensorView& output = outputs[map.output];
    int64_t count = 1;
    for (const int64_t dim : output.dims) count *= dim;
    const auto is_outside = [](float value) { return value < 0 || value > 1; };
    if (std::any_of(output.data, output.data + count, is_outside)) return true;
  }
  return false;
}

}  // namespace yorb
