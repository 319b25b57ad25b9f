// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "places/cluster.h"

#include <algorithm>
#include <array>
#include <utility>

#include "features/hamming.h"

namespace yorb {
namespace {

/// 256 counters whose n-th binary digits stand together in the n-th row, so that adding a descriptor is a few whole
/// words of arithmetic.
class BitCounts {
 public:
  void Add(const Descriptor& row) {
    Descriptor carry = row;
    for (Descriptor& digit : digits_) {
      for (size_t word = 0; word < carry.size(); ++word) {
        const uint64_t both = digit[word] & carry[word];
        digit[word] ^= carry[word];
        carry[word] = both;
      }
    }
    if (++count_ == kMostRows) Spill();
  }

  /// The bits that more than half of the rows had.
  Descriptor Majority() {
    Spill();
    Descriptor majority{};
    for (size_t bit = 0; bit < sums_.size(); ++bit) {
      if (2 * sums_[bit] > total_) majority[bit / 64] |= uint64_t{1} << (bit % 64);
    }
    return majority;
  }

 private:
  static constexpr size_t kDigits = 6, kMostRows = (1u << kDigits) - 1;

  void Spill() {
    for (size_t digit = 0; digit < kDigits; ++digit) {
      for (size_t bit = 0; bit < sums_.size(); ++bit)
        sums_[bit] += ((digits_[digit][bit / 64] >> (bit % 64)) & 1) << digit;
    }
    total_ += count_;
    count_ = 0;
    digits_ = {};
  }

  std::array<Descriptor, kDigits> digits_{};
  std::array<uint64_t, 256> sums_{};
  size_t count_ = 0;
  uint64_t total_ = 0;
};

struct Nearest {
  int centre = 0, distance = 257;
};

Nearest NearestOf(const Descriptor& row, const std::vector<Descriptor>& centres) {
  Nearest nearest;
  for (size_t centre = 0; centre < centres.size(); ++centre) {
    const int distance = HammingDistance(row, centres[centre]);
    if (distance < nearest.distance) nearest = {static_cast<int>(centre), distance};
  }
  return nearest;
}

/// k-means++ (Arthur and Vassilvitskii, 2007): each next centre is a row drawn by its squared distance to those that
/// there are, so that rows equal to a centre are never drawn.
std::vector<Descriptor> ChooseCentres(const Descriptor* rows, size_t count, size_t most, Random& random) {
  std::vector<Descriptor> centres = {rows[static_cast<size_t>(random.Uniform() * static_cast<double>(count))]};
  std::vector<int> squares(count, 257 * 257);
  while (centres.size() < most) {
    double sum = 0;
    for (size_t row = 0; row < count; ++row) {
      const int distance = HammingDistance(rows[row], centres.back());
      squares[row] = std::min(squares[row], distance * distance);
      sum += squares[row];
    }
    if (sum <= 0) break;
    double left = random.Uniform() * sum;
    size_t chosen = 0;
    for (size_t row = 0; row < count; ++row) {
      if (squares[row] == 0) continue;
      chosen = row;
      if ((left -= squares[row]) < 0) break;
    }
    centres.push_back(rows[chosen]);
  }
  return centres;
}

/// The majorities of the rows of each centre; a centre without rows goes, and of equal ones all but the first.
std::vector<Descriptor> MoveCentres(const Descriptor* rows, const std::vector<int>& centre_of, size_t num_centres) {
  std::vector<BitCounts> counts(num_centres);
  std::vector<bool> has_rows(num_centres, false);
  for (size_t row = 0; row < centre_of.size(); ++row) {
    counts[static_cast<size_t>(centre_of[row])].Add(rows[row]);
    has_rows[static_cast<size_t>(centre_of[row])] = true;
  }
  std::vector<Descriptor> moved;
  for (size_t centre = 0; centre < num_centres; ++centre) {
    if (!has_rows[centre]) continue;
    const Descriptor majority = counts[centre].Majority();
    if (std::find(moved.begin(), moved.end(), majority) == moved.end()) moved.push_back(majority);
  }
  return moved;
}

std::vector<int> Assign(const Descriptor* rows, size_t count, const std::vector<Descriptor>& centres) {
  std::vector<int> centre_of(count);
  for (size_t row = 0; row < count; ++row) centre_of[row] = NearestOf(rows[row], centres).centre;
  return centre_of;
}

/// Sorts rows by cluster and leaves centres without rows out.
Clusters Sorted(Descriptor* rows, const std::vector<int>& centre_of, const std::vector<Descriptor>& centres) {
  std::vector<std::vector<Descriptor>> parts(centres.size());
  for (size_t row = 0; row < centre_of.size(); ++row) parts[static_cast<size_t>(centre_of[row])].push_back(rows[row]);
  Clusters clusters;
  for (size_t centre = 0; centre < centres.size(); ++centre) {
    if (parts[centre].empty()) continue;
    clusters.centres.push_back(centres[centre]);
    clusters.sizes.push_back(parts[centre].size());
    rows = std::copy(parts[centre].begin(), parts[centre].end(), rows);
  }
  return clusters;
}

}  // namespace

Descriptor MajorityOf(const Descriptor* rows, size_t count) {
  BitCounts counts;
  for (size_t row = 0; row < count; ++row) counts.Add(rows[row]);
  return counts.Majority();
}

Clusters ClusterRows(Descriptor* rows, size_t count, const ClusterOptions& options, Random& random) {
  if (count == 0) return {};
  std::vector<Descriptor> centres = ChooseCentres(rows, count, static_cast<size_t>(options.most_clusters), random);
  std::vector<int> centre_of = Assign(rows, count, centres);
  for (int round = 0; round < options.most_rounds; ++round) {
    std::vector<Descriptor> moved = MoveCentres(rows, centre_of, centres.size());
    if (moved == centres) break;
    centres = std::move(moved);
    centre_of = Assign(rows, count, centres);
  }
  return Sorted(rows, centre_of, centres);
}

}  // namespace yorb
