// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/fuse_looks.h"

#include <gtest/gtest.h>

namespace yorb {
namespace {

constexpr double kMostOverlap = 0.5;

Box BoxAt(double left, double confidence, const char* name = "person") {
  return {name, confidence, left, 10, left + 40, 110};
}

TEST(FuseLooks, NothingOfNothing) {
  EXPECT_TRUE(FuseLooks({}, kMostOverlap).empty());
  EXPECT_TRUE(FuseLooks({{}, {}}, kMostOverlap).empty());
}

TEST(FuseLooks, WhatAllSawIsTheirMean) {
  const auto fused = FuseLooks({{BoxAt(0, .8)}, {BoxAt(4, .2)}}, kMostOverlap);
  ASSERT_EQ(fused.size(), 1u);
  EXPECT_DOUBLE_EQ(fused[0].left, 0.8);  // .8 * 0 + .2 * 4
  EXPECT_DOUBLE_EQ(fused[0].right, 40.8);
  EXPECT_DOUBLE_EQ(fused[0].top, 10);
  EXPECT_DOUBLE_EQ(fused[0].bottom, 110);
  EXPECT_DOUBLE_EQ(fused[0].confidence, .5);
}

TEST(FuseLooks, WhatOneLookAloneSawIsDoubted) {
  const auto fused = FuseLooks({{BoxAt(0, .9)}, {BoxAt(200, .8), BoxAt(1, .7)}, {}, {}}, kMostOverlap);
  ASSERT_EQ(fused.size(), 2u);
  EXPECT_DOUBLE_EQ(fused[0].confidence, .4);
  EXPECT_DOUBLE_EQ(fused[1].confidence, .2);
  EXPECT_DOUBLE_EQ(fused[1].left, 200);
}

TEST(FuseLooks, ALookCountsOnceForAThing) {
  // Two boxes of one look that do not overlap enough to be doubles, and both overlap another look's.
  const auto fused = FuseLooks({{BoxAt(0, .9)}, {BoxAt(-9, .6), BoxAt(9, .5)}}, kMostOverlap);
  ASSERT_EQ(fused.size(), 1u);
  EXPECT_DOUBLE_EQ(fused[0].confidence, (.9 + .6) / 2);
}

TEST(FuseLooks, OtherNamesAreOtherThings) {
  EXPECT_EQ(FuseLooks({{BoxAt(0, .8)}, {BoxAt(0, .6, "chair")}}, kMostOverlap).size(), 2u);
}

TEST(FuseLooks, TheOrderOfLooksIsOfNoImportance) {
  const std::vector<Box> one = {BoxAt(0, .8), BoxAt(100, .3)}, other = {BoxAt(5, .6), BoxAt(103, .7), BoxAt(300, .1)};
  const auto a = FuseLooks({one, other}, kMostOverlap), b = FuseLooks({other, one}, kMostOverlap);
  ASSERT_EQ(a.size(), 3u);
  ASSERT_EQ(b.size(), 3u);
  for (size_t i = 0; i < a.size(); ++i) {
    EXPECT_DOUBLE_EQ(a[i].left, b[i].left);
    EXPECT_DOUBLE_EQ(a[i].confidence, b[i].confidence);
  }
}

}  // namespace
}  // namespace yorb
