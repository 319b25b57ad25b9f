// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/time.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/random.h"

namespace yorb {
namespace {

int64_t Ns(const char* text) {
  const auto time = ParseTimestamp(text);
  EXPECT_TRUE(time.has_value()) << text;
  return time ? time->ns : std::numeric_limits<int64_t>::min();
}

TEST(Time, ReadsEveryDigitThatADoubleWouldLose) {
  EXPECT_EQ(Ns("1305031102.175304"), 1305031102175304000);
  EXPECT_EQ(Ns("1305031102.175304123"), 1305031102175304123);
  EXPECT_EQ(Ns("1403636579.763555527"), 1403636579763555527);
}

TEST(Time, ReadsTheSameMomentInEverySpelling) {
  for (const char* text : {"1305031102.175304", "1305031102.175304000", "+1305031102.175304", "1.305031102175304e9",
                           "1.305031102175304E+09", "1305031102175304e-6", " 1305031102.175304\r", "01305031102.175304",
                           "0.001305031102175304e12"}) {
    EXPECT_EQ(Ns(text), 1305031102175304000) << text;
  }
}

TEST(Time, ReadsShortAndSmallNumbers) {
  EXPECT_EQ(Ns("0"), 0);
  EXPECT_EQ(Ns("-0.0"), 0);
  EXPECT_EQ(Ns("7"), 7000000000);
  EXPECT_EQ(Ns("7."), 7000000000);
  EXPECT_EQ(Ns(".5"), 500000000);
  EXPECT_EQ(Ns("1e-9"), 1);
  EXPECT_EQ(Ns("-1.5"), -1500000000);
  EXPECT_EQ(Ns("-1e-9"), -1);
}

TEST(Time, RoundsDigitsFinerThanANanosecond) {
  EXPECT_EQ(Ns("0.0000000014"), 1);
  EXPECT_EQ(Ns("0.0000000015"), 2);
  EXPECT_EQ(Ns("-0.0000000015"), -2);
  EXPECT_EQ(Ns("1.9999999999"), 2000000000);
  EXPECT_EQ(Ns("1403636579.7635555273"), 1403636579763555527);
  EXPECT_EQ(Ns("4e-10"), 0);
  EXPECT_EQ(Ns("5e-10"), 1);
  EXPECT_EQ(Ns("1e-20"), 0);
}

TEST(Time, HoldsNineteenDigitsAndRefusesWhatInt64CannotHold) {
  EXPECT_EQ(Ns("9223372036.854775807"), std::numeric_limits<int64_t>::max());
  EXPECT_EQ(Ns("-9223372036.854775807"), -std::numeric_limits<int64_t>::max());
  EXPECT_EQ(Ns("1305031102175304000e-9"), 1305031102175304000);
  EXPECT_FALSE(ParseTimestamp("9223372036.854775808"));
  EXPECT_FALSE(ParseTimestamp("9223372036.8547758075"));  // would round over the edge
  EXPECT_FALSE(ParseTimestamp("1305031102175304000"));    // nanoseconds taken for seconds
  EXPECT_FALSE(ParseTimestamp("1e30"));
  EXPECT_FALSE(ParseTimestamp("99999999999999999999999999"));
}

TEST(Time, RefusesWhatIsNoTime) {
  for (const char* text :
       {"",    " ",   ".",   "-",   "+",   "e5",   ".e5",  "1e",  "1e+", "1e5.5",          "1.2.3", "1,5",
        "--1", "+-1", "-+1", "nan", "inf", "-inf", "0x10", "12a", "1 2", "1e999999999999", "1e-61", "1_000"}) {
    EXPECT_FALSE(ParseTimestamp(text)) << '"' << text << '"';
  }
}

TEST(Time, PrintsSixDecimalsOrNineWhereSixWouldLose) {
  EXPECT_EQ(ToString(Timestamp{1305031102175304000}), "1305031102.175304");
  EXPECT_EQ(ToString(Timestamp{1305031102175304123}), "1305031102.175304123");
  EXPECT_EQ(ToString(Timestamp{0}), "0.000000");
  EXPECT_EQ(ToString(Timestamp{1}), "0.000000001");
  EXPECT_EQ(ToString(Timestamp{-1500000000}), "-1.500000");
  EXPECT_EQ(ToString(Timestamp{std::numeric_limits<int64_t>::min()}), "-9223372036.854775808");
}

TEST(Time, WhatIsPrintedReadsBackTheSame) {
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    const int digits = static_cast<int>(random.Below(64));
    int64_t ns = static_cast<int64_t>(random.Next() >> 1) >> digits;
    if (random.Below(2)) ns = -ns;
    const auto back = ParseTimestamp(ToString(Timestamp{ns}));
    ASSERT_TRUE(back.has_value()) << ns;
    ASSERT_EQ(back->ns, ns);
  }
}

TEST(Time, DifferencesAreTakenBeforeRoundingAndCountMicroseconds) {
  EXPECT_EQ(SecondsBetween(Timestamp{1305031102175304000}, Timestamp{1305031102175305000}), 1e-6);
  EXPECT_EQ(SecondsBetween(Timestamp{1305031102175304000}, Timestamp{1305031102175304499}), 0);
  EXPECT_EQ(SecondsBetween(Timestamp{1305031102175304499}, Timestamp{1305031102175304000}), 0);
  EXPECT_DOUBLE_EQ(SecondsBetween(Timestamp{1305031103000000000}, Timestamp{1305031102000000000}), -1.0);
}

TEST(Time, OrderIsOfWholeNumbers) {
  const Timestamp a{1}, b{2};
  EXPECT_TRUE(a < b && a <= b && b > a && b >= a && a != b && a == Timestamp{1});
  EXPECT_FALSE(b < a || b <= a || a > b || a >= b || a == b);
}

TEST(Time, ARangeIsWhatTimesCover) {
  EXPECT_EQ(RangeText({{2500000000}, {1000000000}, {1500000000}}), "1.000000 to 2.500000");
  EXPECT_EQ(RangeText({}), "");
}

TEST(SecondsBetween, IsTheSameForStampsThatWerePrintedFromDoubles) {
  const auto a = ParseTimestamp("1305031102.175304"), b = ParseTimestamp("1305031102.211214");
  const auto printed_a = ParseTimestamp("1.305031102175303936e+09"),
             printed_b = ParseTimestamp("1.305031102211214066e+09");
  ASSERT_TRUE(a && b && printed_a && printed_b);
  EXPECT_NE(*a, *printed_a);
  EXPECT_EQ(SecondsBetween(*a, *b), SecondsBetween(*printed_a, *printed_b));
  EXPECT_DOUBLE_EQ(SecondsBetween(*a, *b), 0.03591);
  EXPECT_DOUBLE_EQ(SecondsBetween(*b, *a), -0.03591);
}

}  // namespace
}  // namespace yorb
