// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/hamming.h"

#include <gtest/gtest.h>

#include <bitset>

#include "core/random.h"

namespace yorb {
namespace {

std::vector<Descriptor> RandomRows(size_t count, uint64_t seed) {
  Random random(seed);
  std::vector<Descriptor> rows(count);
  for (Descriptor& row : rows) {
    for (uint64_t& word : row) word = random.Next();
  }
  return rows;
}

int SlowDistance(const Descriptor& a, const Descriptor& b) {
  int distance = 0;
  for (size_t word = 0; word < a.size(); ++word) {
    for (int bit = 0; bit < 64; ++bit) distance += static_cast<int>(((a[word] ^ b[word]) >> bit) & 1);
  }
  return distance;
}

TEST(Hamming, CountsEveryBitOnce) {
  const Descriptor zero{};
  EXPECT_EQ(HammingDistance(zero, zero), 0);
  for (size_t bit = 0; bit < 256; ++bit) {
    Descriptor one{};
    one[bit / 64] = uint64_t{1} << (bit % 64);
    EXPECT_EQ(HammingDistance(zero, one), 1);
  }
  EXPECT_EQ(HammingDistance(zero, {~0ull, ~0ull, ~0ull, ~0ull}), 256);
}

TEST(Hamming, AllPathsGiveTheSlowTwinsNumbers) {
  for (const size_t count : {size_t{0}, size_t{1}, size_t{3}, size_t{64}, size_t{1001}}) {
    std::vector<Descriptor> rows = RandomRows(count, 7 + count);
    const Descriptor query = RandomRows(1, 5)[0];
    if (count > 2) rows[1] = query;
    if (count > 2) rows[2] = {~query[0], ~query[1], ~query[2], ~query[3]};
    for (const hamming::Path path :
         {hamming::Path{HammingDistances}, hamming::Path{hamming::Portable}, hamming::Avx2(), hamming::Avx512()}) {
      if (path == nullptr) continue;
      std::vector<uint16_t> distances(count + 1, 9999);
      path(query, rows.data(), count, distances.data());
      for (size_t i = 0; i < count; ++i) EXPECT_EQ(distances[i], SlowDistance(query, rows[i]));
      EXPECT_EQ(distances[count], 9999) << "wrote past the end";
    }
  }
}

}  // namespace
}  // namespace yorb
