// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/quadtree.h"

#include <algorithm>
#include <cmath>

namespace yorb {
namespace {

/// Equation (4): the improved quadtree stops splitting at this share of the wanted corners.
constexpr double kEnoughNodes = 0.7;

/// Scrambles a place. Scores are whole numbers, so that many corners tie for the last places; by their order the upper
/// part of the picture would win them all.
uint32_t Lot(const Corner& corner) {
  uint32_t lot = static_cast<uint32_t>(corner.x) * 0x9e3779b1u ^ static_cast<uint32_t>(corner.y) * 0x85ebca77u;
  lot = (lot ^ (lot >> 15)) * 0xc2b2ae3du;
  return lot ^ (lot >> 16);
}

bool IsStronger(const Corner& a, const Corner& b) {
  return a.response != b.response ? a.response > b.response : Lot(a) > Lot(b);
}

}  // namespace

void Quadtree::Start(const std::vector<Corner>& corners, const CornerArea& area) {
  order_.clear();
  moved_.resize(corners.size());
  kept_.clear();
  nodes_.clear();
  // Roots side by side, as nearly square as whole numbers allow.
  const int width = area.right - area.left, height = area.bottom - area.top;
  const int roots = std::max(1, static_cast<int>(std::lround(static_cast<double>(width) / height)));
  for (int root = 0; root < roots; ++root) {
    const int left = area.left + width * root / roots, right = area.left + width * (root + 1) / roots;
    const uint32_t begin = static_cast<uint32_t>(order_.size());
    for (uint32_t i = 0; i < corners.size(); ++i) {
      if (corners[i].x >= left && corners[i].x < right) order_.push_back(i);
    }
    const uint32_t end = static_cast<uint32_t>(order_.size());
    if (end > begin) nodes_.push_back({{left, area.top, right, area.bottom}, begin, end});
  }
}

void Quadtree::Split(const std::vector<Corner>& corners, const Node& node) {
  const CornerArea& area = node.area;
  const int x = area.left + (area.right - area.left + 1) / 2, y = area.top + (area.bottom - area.top + 1) / 2;
  const auto quarter_of = [&](uint32_t i) { return (corners[i].x >= x ? 1u : 0u) + (corners[i].y >= y ? 2u : 0u); };
  uint32_t starts[5] = {node.begin, 0, 0, 0, 0};
  for (uint32_t i = node.begin; i < node.end; ++i) ++starts[quarter_of(order_[i]) + 1];
  for (int quarter = 0; quarter < 4; ++quarter) starts[quarter + 1] += starts[quarter];
  uint32_t places[4] = {starts[0], starts[1], starts[2], starts[3]};
  for (uint32_t i = node.begin; i < node.end; ++i) moved_[places[quarter_of(order_[i])]++] = order_[i];
  std::copy(moved_.begin() + node.begin, moved_.begin() + node.end, order_.begin() + node.begin);

  const CornerArea areas[4] = {{area.left, area.top, x, y},
                               {x, area.top, area.right, y},
                               {area.left, y, x, area.bottom},
                               {x, y, area.right, area.bottom}};
  for (int quarter = 0; quarter < 4; ++quarter) {
    if (starts[quarter + 1] > starts[quarter]) {
      next_.push_back({areas[quarter], starts[quarter], starts[quarter + 1]});
    }
  }
}

void Quadtree::SplitAll(const std::vector<Corner>& corners) {
  next_.clear();
  for (const Node& node : nodes_) {
    if (node.CanSplit()) {
      Split(corners, node);
    } else {
      next_.push_back(node);
    }
  }
  nodes_.swap(next_);
}

void Quadtree::SplitFullest(const std::vector<Corner>& corners, size_t wanted) {
  fullest_.clear();
  for (uint32_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].CanSplit()) fullest_.push_back(i);
  }
  std::sort(fullest_.begin(), fullest_.end(), [&](uint32_t a, uint32_t b) {
    return nodes_[a].size() != nodes_[b].size() ? nodes_[a].size() > nodes_[b].size() : a < b;
  });
  next_.clear();
  size_t whole = nodes_.size();  // nodes of before this pass that are not split
  for (const uint32_t index : fullest_) {
    if (whole + next_.size() >= wanted) break;
    Split(corners, nodes_[index]);
    nodes_[index].end = nodes_[index].begin;
    --whole;
  }
  for (const Node& node : nodes_) {
    if (node.size() > 0) next_.push_back(node);
  }
  nodes_.swap(next_);
}

size_t Quadtree::CountSplittable() const {
  return static_cast<size_t>(std::count_if(nodes_.begin(), nodes_.end(), [](const Node& n) { return n.CanSplit(); }));
}

uint32_t Quadtree::BestOf(const std::vector<Corner>& corners, const Node& node) const {
  uint32_t best = order_[node.begin];
  for (uint32_t i = node.begin + 1; i < node.end; ++i) {
    if (IsStronger(corners[order_[i]], corners[best])) best = order_[i];
  }
  return best;
}

void Quadtree::KeepStrongest(const std::vector<Corner>& corners, std::vector<uint32_t>& indices, size_t count) const {
  if (indices.size() <= count) return;
  const auto is_stronger = [&](uint32_t a, uint32_t b) { return IsStronger(corners[a], corners[b]); };
  std::nth_element(indices.begin(), indices.begin() + static_cast<ptrdiff_t>(count), indices.end(), is_stronger);
  indices.resize(count);
}

const std::vector<Corner>& Quadtree::Take(const std::vector<Corner>& corners, size_t wanted) {
  KeepStrongest(corners, kept_, wanted);
  std::sort(kept_.begin(), kept_.end());
  chosen_.clear();
  for (const uint32_t i : kept_) chosen_.push_back(corners[i]);
  return chosen_;
}

const std::vector<Corner>& Quadtree::KeepBestOfEach(const std::vector<Corner>& corners, const CornerArea& area,
                                                    int wanted_corners) {
  const size_t wanted = static_cast<size_t>(std::max(wanted_corners, 0));
  Start(corners, area);
  for (size_t splittable = CountSplittable(); splittable > 0 && nodes_.size() < wanted;
       splittable = CountSplittable()) {
    if (nodes_.size() + 3 * splittable > wanted) {
      SplitFullest(corners, wanted);
    } else {
      SplitAll(corners);
    }
  }
  for (const Node& node : nodes_) kept_.push_back(BestOf(corners, node));
  return Take(corners, wanted);
}

const std::vector<Corner>& Quadtree::KeepSinglesAndBest(const std::vector<Corner>& corners, const CornerArea& area,
                                                        int wanted_corners) {
  const size_t wanted = static_cast<size_t>(std::max(wanted_corners, 0));
  Start(corners, area);
  while (static_cast<double>(nodes_.size()) < kEnoughNodes * static_cast<double>(wanted) && CountSplittable() > 0) {
    SplitAll(corners);
  }
  crowd_.clear();
  for (const Node& node : nodes_) {
    std::vector<uint32_t>& to = node.size() == 1 ? kept_ : crowd_;
    to.insert(to.end(), order_.begin() + node.begin, order_.begin() + node.end);
  }
  KeepStrongest(corners, crowd_, wanted - std::min(wanted, kept_.size()));
  kept_.insert(kept_.end(), crowd_.begin(), crowd_.end());
  return Take(corners, wanted);
}

}  // namespace yorb
