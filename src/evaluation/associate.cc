// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/associate.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <tuple>

namespace yorb {
namespace {

constexpr size_t kNone = static_cast<size_t>(-1);

/// A stamp of either list in the common order of time, linked to the stamps beside it that are not taken yet.
struct Node {
  Timestamp time;
  size_t index = 0;
  bool is_first = false;
  bool is_taken = false;
  size_t before = kNone, after = kNone;
};

std::vector<Node> Merge(const std::vector<Timestamp>& first, const std::vector<Timestamp>& second) {
  std::vector<Node> nodes;
  nodes.reserve(first.size() + second.size());
  for (size_t i = 0, j = 0; i < first.size() || j < second.size();) {
    const bool take_first = j == second.size() || (i < first.size() && first[i] <= second[j]);
    nodes.push_back(take_first ? Node{first[i], i, true} : Node{second[j], j, false});
    ++(take_first ? i : j);
  }
  for (size_t k = 0; k < nodes.size(); ++k) {
    if (k > 0) nodes[k].before = k - 1;
    if (k + 1 < nodes.size()) nodes[k].after = k + 1;
  }
  return nodes;
}

/// Two neighbours of different lists; the smallest is the next to be paired.
struct Candidate {
  uint64_t difference_ns;
  size_t first, second;  ///< places in the lists, for ties
  size_t left, right;    ///< nodes

  friend bool operator>(const Candidate& a, const Candidate& b) {
    return std::tie(a.difference_ns, a.first, a.second) > std::tie(b.difference_ns, b.first, b.second);
  }
};

using Queue = std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>>;

void Propose(const std::vector<Node>& nodes, size_t left, size_t right, uint64_t limit_ns, Queue& queue) {
  if (left == kNone || right == kNone || nodes[left].is_first == nodes[right].is_first) return;
  const uint64_t difference = static_cast<uint64_t>(nodes[right].time.ns) - static_cast<uint64_t>(nodes[left].time.ns);
  if (difference >= limit_ns) return;
  const auto [first, second] = nodes[left].is_first ? std::pair(left, right) : std::pair(right, left);
  queue.push({difference, nodes[first].index, nodes[second].index, left, right});
}

}  // namespace

std::vector<StampPair> AssociateStamps(const std::vector<Timestamp>& first, const std::vector<Timestamp>& second,
                                       int64_t max_difference_ns) {
  // The nearest pair of all always stands side by side in the common order of time (a stamp between the two would make
  // a nearer pair with one of them), and so does the nearest of what is left once a pair is taken out.
  std::vector<StampPair> pairs;
  if (max_difference_ns <= 0) return pairs;
  const auto limit_ns = static_cast<uint64_t>(max_difference_ns);
  std::vector<Node> nodes = Merge(first, second);
  Queue queue;
  for (size_t k = 0; k + 1 < nodes.size(); ++k) Propose(nodes, k, k + 1, limit_ns, queue);
  while (!queue.empty()) {
    const Candidate nearest = queue.top();
    queue.pop();
    if (nodes[nearest.left].is_taken || nodes[nearest.right].is_taken) continue;
    pairs.push_back({nearest.first, nearest.second});
    nodes[nearest.left].is_taken = nodes[nearest.right].is_taken = true;
    const size_t before = nodes[nearest.left].before, after = nodes[nearest.right].after;
    if (before != kNone) nodes[before].after = after;
    if (after != kNone) nodes[after].before = before;
    Propose(nodes, before, after, limit_ns, queue);
  }
  std::sort(pairs.begin(), pairs.end(), [](const StampPair& a, const StampPair& b) { return a.first < b.first; });
  return pairs;
}

}  // namespace yorb
