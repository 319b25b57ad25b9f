// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/edge_maps.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace yorb {
namespace {

constexpr int64_t kEdges = 4 * kEdgeBins;

/// Where a cell's numbers begin; the channels follow by the second stride.
const float* At(const TensorView& map, int64_t channel, int x, int y) {
  return map.data + channel * map.strides[1] + y * map.strides[2] + x * map.strides[3];
}

/// The outputs of each size, the finest first.
std::map<std::pair<int64_t, int64_t>, std::vector<size_t>, std::greater<>> BySize(const HeadFacts& facts) {
  std::map<std::pair<int64_t, int64_t>, std::vector<size_t>, std::greater<>> by_size;
  for (size_t i = 0; i < facts.shapes.size(); ++i) {
    const std::vector<int64_t>& shape = facts.shapes[i];
    if (shape.size() == 4 && shape[1] != 1) by_size[{shape[2], shape[3]}].push_back(i);  // 1: sums, for some chips
  }
  return by_size;
}

/// The map of these outputs, which are of one size: both parts in one, or the edges in one and the classes in the
/// other.
std::optional<EdgeMap> MapOf(const std::vector<size_t>& outputs, const HeadFacts& facts) {
  EdgeMap map;
  const auto channels = [&](size_t i) { return facts.shapes[outputs[i]][1]; };
  if (outputs.size() == 1 && facts.num_names > 0 && channels(0) == kEdges + facts.num_names) {
    map.edges = map.scores = outputs[0], map.first_score = kEdges, map.num_classes = facts.num_names;
  } else if (outputs.size() == 2 && (channels(0) == kEdges) != (channels(1) == kEdges)) {
    const size_t edges = channels(0) == kEdges ? 0 : 1;
    map.edges = outputs[edges], map.scores = outputs[1 - edges];
    map.num_classes = static_cast<int>(channels(1 - edges));
  } else {
    return std::nullopt;
  }
  const std::vector<int64_t>& shape = facts.shapes[map.edges];
  map.height = static_cast<int>(shape[2]), map.width = static_cast<int>(shape[3]);
  if (map.width < 1 || map.height < 1 || facts.width % map.width != 0) return std::nullopt;
  map.stride = facts.width / map.width;
  const bool is_named = facts.num_names == 0 || facts.num_names == map.num_classes;
  return map.height * map.stride == facts.height && is_named ? std::optional(map) : std::nullopt;
}

}  // namespace

std::optional<HeadLayout> EdgeMapsOf(const HeadFacts& facts) {
  constexpr int kFinest = 8;
  HeadLayout layout;
  layout.kind = LayoutKind::kEdgeMaps;
  for (const auto& [size, outputs] : BySize(facts)) {
    const auto map = MapOf(outputs, facts);
    if (!map || map->stride != kFinest << layout.edge_maps.size()) return std::nullopt;
    if (layout.num_classes != 0 && layout.num_classes != map->num_classes) return std::nullopt;
    layout.num_classes = map->num_classes;
    layout.edge_maps.push_back(*map);
  }
  return layout.edge_maps.size() < 3 ? std::nullopt : std::optional(layout);
}

std::array<float, 4> EdgesAt(const TensorView& edges, int x, int y) {
  std::array<float, 4> found{};
  for (int edge = 0; edge < 4; ++edge) {
    const float* first = At(edges, int64_t{edge} * kEdgeBins, x, y);
    float most = *first, sum = 0, weighted = 0;
    for (int bin = 1; bin < kEdgeBins; ++bin) most = std::max(most, first[bin * edges.strides[1]]);
    for (int bin = 0; bin < kEdgeBins; ++bin) {
      const float weight = std::exp(first[bin * edges.strides[1]] - most);
      sum += weight, weighted += weight * static_cast<float>(bin);
    }
    found[static_cast<size_t>(edge)] = weighted / sum;
  }
  return found;
}

bool AreEdgeMapsLogits(const std::vector<TensorView>& outputs, const HeadLayout& layout) {
  for (const EdgeMap& map : layout.edge_maps) {
    const TensorView& scores = outputs[map.scores];
    for (int cell = 0; cell < map.width * map.height; ++cell) {
      const float* first = At(scores, map.first_score, cell % map.width, cell / map.width);
      for (int label = 0; label < map.num_classes; ++label) {
        const float score = first[label * scores.strides[1]];
        if (score < 0 || score > 1) return true;
      }
    }
  }
  return false;
}

}  // namespace yorb
