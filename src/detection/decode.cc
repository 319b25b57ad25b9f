// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/decode.h"

#include <algorithm>
#include <cmath>

namespace yorb {
namespace {

constexpr int kObjectness = 4;  // its place among the values of an anchor

float Sigmoid(float x) { return 1.f / (1.f + std::exp(-x)); }

/// Where the class scores of one box lie.
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

/// Adds a box for the best class, or for every class, whose score times `factor` reaches the confidence.
template <typename Score>
void AddClasses(RawBox box, int num_classes, const DecodeOptions& options, const Score& score,
                std::vector<RawBox>& boxes) {
  const auto least = static_cast<float>(options.confidence);
  RawBox best = box;
  best.confidence = -1;
  for (int label = 0; label < num_classes; ++label) {
    box.confidence = std::min(score(label), 1.f);
    box.label = label;
    if (options.takes_all_classes && box.confidence >= least) boxes.push_back(box);
    if (box.confidence > best.confidence) best = box;
  }
  if (!options.takes_all_classes && best.confidence >= least) boxes.push_back(best);
}

/// Rows or columns of centre, size, objectness where there is one, classes.
void DecodeCentres(const TensorView& output, const HeadLayout& layout, const DecodeOptions& options,
                   std::vector<RawBox>& boxes) {
  const bool has_objectness = layout.kind == LayoutKind::kAnchorRows;
  const int64_t count = output.dims[has_objectness ? 1 : 2];
  const int64_t step = output.strides[has_objectness ? 1 : 2], value_step = output.strides[has_objectness ? 2 : 1];
  for (int64_t i = 0; i < count; ++i) {
    const float* at = output.data + i * step;
    const float objectness = has_objectness ? at[4 * value_step] : 1.f;
    if (!(objectness >= static_cast<float>(options.confidence))) continue;
    const RawBox box = FromCentre(at[0], at[value_step], at[2 * value_step], at[3 * value_step]);
    if (!IsSound(box)) continue;
    const Scores scores{at + (has_objectness ? 5 : 4) * value_step, value_step, layout.num_classes};
    AddClasses(
        box, layout.num_classes, options, [&](int label) { return scores[label] * objectness; }, boxes);
  }
}

/// Rows of corners, confidence, class number.
void DecodeCorners(const TensorView& output, const HeadLayout& layout, const DecodeOptions& options,
                   std::vector<RawBox>& boxes) {
  constexpr float kMostClasses = 1 << 20;
  for (int64_t i = 0; i < output.dims[1]; ++i) {
    const auto value = [&](int64_t k) { return output.At(0, i, k); };
    RawBox box{value(0), value(1), value(2), value(3), std::min(value(4), 1.f), 0};
    if (!(value(4) >= static_cast<float>(options.confidence)) || !IsSound(box)) continue;
    if (!(value(5) >= 0 && value(5) < kMostClasses)) continue;
    box.label = static_cast<int>(std::lround(value(5)));
    if (layout.num_classes > 0 && box.label >= layout.num_classes) continue;
    boxes.push_back(box);
  }
}

/// Compared before the sigmoid is taken, since nearly all cells are empty.
float LeastObjectness(const DecodeOptions& options) {
  const double confidence = std::clamp(options.confidence, 1e-9, 1 - 1e-9);
  return static_cast<float>(options.is_logits ? std::log(confidence / (1 - confidence)) : options.confidence);
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

  void Decode(int num_classes, const float* anchors, std::vector<RawBox>& boxes) const {
    for (int anchor = 0; anchor < kAnchors; ++anchor) {
      for (int y = 0; y < map_.height; ++y) {
        const float* row = output_.data + anchor * anchor_step_ + y * Step(map_.y_axis);
        for (int x = 0; x < map_.width; ++x) {
          const float* at = row + x * Step(map_.x_axis);
          if (!(at[kObjectness * value_step_] >= least_)) continue;
          Add(at, BoxAt(at, x, y, anchors + 2 * anchor), num_classes, boxes);
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

  void Add(const float* at, const RawBox& box, int num_classes, std::vector<RawBox>& boxes) const {
    if (!IsSound(box)) return;
    const float objectness = Value(at, kObjectness);
    AddClasses(
        box, num_classes, options_, [&](int label) { return Value(at, 5 + label) * objectness; }, boxes);
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

std::vector<RawBox> DecodeBoxes(const std::vector<TensorView>& outputs, const HeadLayout& layout,
                                const DecodeOptions& options) {
  std::vector<RawBox> boxes;
  switch (layout.kind) {
    case LayoutKind::kAnchorRows:
    case LayoutKind::kCentreColumns:
      DecodeCentres(outputs[layout.output], layout, options, boxes);
      break;
    case LayoutKind::kCornerRows:
      DecodeCorners(outputs[layout.output], layout, options, boxes);
      break;
    case LayoutKind::kRawMaps:
      for (size_t i = 0; i < layout.maps.size(); ++i) {
        const RawMap& map = layout.maps[i];
        const MapDecoder decoder(outputs[map.output], map, options);
        decoder.Decode(layout.num_classes, options.anchors.data() + 2 * kAnchors * i, boxes);
      }
      break;
  }
  return boxes;
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
