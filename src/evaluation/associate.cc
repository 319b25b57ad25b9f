// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/associate.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <queue>
#include <tuple>

namespace yorb {
namespace {

constexpr size_t kNone = static_cast<size_t>(-1);

/// A stamp of either list in the common order of time, linked to the stamps beside it that are not taken yet.
struct Node {
  double time = 0;  ///< seconds
  size_t index = 0;
  bool is_first = false;
  bool is_taken = false;
  size_t before = kNone, after = kNone;
};

std::vector<Node> Merge(const std::vector<Timestamp>& first, const std::vector<Timestamp>& second, double offset) {
  std::vector<Node> nodes;
  nodes.reserve(first.size() + second.size());
  for (size_t i = 0; i < first.size(); ++i) nodes.push_back({TumSeconds(first[i]), i, true});
  for (size_t i = 0; i < second.size(); ++i) nodes.push_back({TumSeconds(second[i]) + offset, i, false});
  const auto middle = nodes.begin() + static_cast<std::ptrdiff_t>(first.size());
  std::inplace_merge(nodes.begin(), middle, nodes.end(), [](const Node& a, const Node& b) { return a.time < b.time; });
  for (size_t k = 0; k < nodes.size(); ++k) {
    if (k > 0) nodes[k].before = k - 1;
    if (k + 1 < nodes.size()) nodes[k].after = k + 1;
  }
  return nodes;
}

/// Two neighbours of different lists; the smallest is the next to be paired.
struct Candidate {
  double difference;
  size_t first, second;  ///< places in the lists, for ties
  size_t left, right;    ///< nodes

  friend bool operator>(const Candidate& a, const Candidate& b) {
    return std::tie(a.difference, a.first, a.second) > std::tie(b.difference, b.first, b.second);
  }
};

using Queue = std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>>;

void Propose(const std::vector<Node>& nodes, size_t left, size_t right, double limit, Queue& queue) {
  if (left == kNone || right == kNone || nodes[left].is_first == nodes[right].is_first) return;
  const double difference = nodes[right].time - nodes[left].time;
  if (!(difference < limit)) return;
  const auto [first, second] = nodes[left].is_first ? std::pair(left, right) : std::pair(right, left);
  queue.push({difference, nodes[first].index, nodes[second].index, left, right});
}

}  // namespace

double TumSeconds(Timestamp stamp) { return static_cast<double>(static_cast<long double>(stamp.ns) / 1e9L); }

std::vector<StampPair> AssociateStamps(const std::vector<Timestamp>& first, const std::vector<Timestamp>& second,
                                       double max_difference, double offset) {
  // The nearest pair of all always stands side by side in the common order of time (a stamp between the two would make
  // a nearer pair with one of them), and so does the nearest of what is left once a pair is taken out.
  std::vector<StampPair> pairs;
  std::vector<Node> nodes = Merge(first, second, offset);
  Queue queue;
  for (size_t k = 0; k + 1 < nodes.size(); ++k) Propose(nodes, k, k + 1, max_difference, queue);
  while (!queue.empty()) {
    const Candidate nearest = queue.top();
    queue.pop();
    if (nodes[nearest.left].is_taken || nodes[nearest.right].is_taken) continue;
    pairs.push_back({nearest.first, nearest.second});
    nodes[nearest.left].is_taken = nodes[nearest.right].is_taken = true;
    const size_t before = nodes[nearest.left].before, after = nodes[nearest.right].after;
    if (before != kNone) nodes[before].after = after;
    if (after != kNone) nodes[after].before = before;
    Propose(nodes, before, after, max_difference, queue);
  }
  std::sort(pairs.begin(), pairs.end(), [](const StampPair& a, const StampPair& b) { return a.first < b.first; });
  return pairs;
}

}  // namespace yorb
