// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/decode.h"

#include <algorithm>
#include <cmath>

#include "core/iou.h"

namespace yorb {
namespace {

float Sigmoid(float x) { return 1 / (1 + std::exp(-x)); }

SceneBox BoxAt(const float* logits, int64_t row, int64_t column, const Anchor& anchor, float stride) {
  const float x = (2 * Sigmoid(logits[0]) - 0.5f + static_cast<float>(column)) * stride;
  const float y = (2 * Sigmoid(logits[1]) - 0.5f + static_cast<float>(row)) * stride;
  const float half_width = 2 * std::pow(Sigmoid(logits[2]), 2.0f) * anchor.width_px;
  const float half_height = 2 * std::pow(Sigmoid(logits[3]), 2.0f) * anchor.height_px;
  return {x - half_width, y - half_height, x + half_width, y + half_height};
}

/// All boxes of one head and one picture; `map` is (rows, columns, anchors, 5 + classes), contiguous.
void Collect(const torch::Tensor& map, const std::array<Anchor, 3>& anchors, int stride, double least,
             std::vector<Detection>& found) {
  const int64_t rows = map.size(0), columns = map.size(1), width = map.size(3);
  const float* logits = map.data_ptr<float>();
  for (int64_t cell = 0; cell < rows * columns * 3; ++cell, logits += width) {
    const float objectness = Sigmoid(logits[4]);
    if (objectness < least) continue;
    const int64_t place = cell / 3;
    SceneBox box = BoxAt(logits, place / columns, place % columns, anchors[static_cast<size_t>(cell % 3)],
                         static_cast<float>(stride));
    for (int64_t c = 5; c < width; ++c) {
      const float confidence = objectness * Sigmoid(logits[c]);
      box.class_index = static_cast<int>(c - 5);
      if (confidence >= least) found.push_back({box, confidence});
    }
  }
}

std::vector<Detection> Suppress(std::vector<Detection> found, const DecodeOptions& options) {
  constexpr size_t kMostCandidates = 5000;
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.confidence > b.confidence; });
  if (found.size() > kMostCandidates) found.resize(kMostCandidates);
  std::vector<Detection> kept;
  for (const Detection& candidate : found) {
    const bool is_new = std::none_of(kept.begin(), kept.end(), [&](const Detection& better) {
      return better.box.class_index == candidate.box.class_index &&
             IoU(better.box, candidate.box) > options.most_overlap;
    });
    if (is_new) kept.push_back(candidate);
    if (kept.size() == options.most_boxes) break;
  }
  return kept;
}

}  // namespace

std::vector<std::vector<Detection>> DecodeBoxes(const std::array<torch::Tensor, 3>& maps, const Layout& layout,
                                                const DecodeOptions& options) {
  const int64_t num_pictures = maps.front().size(0);
  std::vector<std::vector<Detection>> found(static_cast<size_t>(num_pictures));
  for (size_t level = 0; level < maps.size(); ++level) {
    const torch::Tensor& raw = maps[level];
    const torch::Tensor map = raw.to(torch::kCPU, torch::kFloat32)
                                  .permute({0, 2, 3, 1})
                                  .contiguous()
                                  .view({num_pictures, raw.size(2), raw.size(3), 3, -1});
    for (int64_t i = 0; i < num_pictures; ++i)
      Collect(map[i], layout.anchors[level], layout.strides[level], options.least_confidence,
              found[static_cast<size_t>(i)]);
  }
  for (auto& boxes : found) boxes = Suppress(std::move(boxes), options);
  return found;
}

}  // namespace yorb
