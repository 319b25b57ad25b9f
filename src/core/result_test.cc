// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/result.h"

#include <gtest/gtest.h>

#include <memory>

#include "core/id.h"

namespace yorb {
namespace {

Result<int> Half(int number) {
  if (number % 2) return BadInput(std::to_string(number) + " is odd");
  return number / 2;
}

TEST(Result, HoldsAValueOrTheReasonWhyNot) {
  const auto good = Half(8), bad = Half(7);
  ASSERT_TRUE(good.ok());
  EXPECT_EQ(*good, 4);
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().message, "7 is odd");
  EXPECT_EQ(bad.error().kind, Error::Kind::kBadInput);
}

TEST(Result, GivesAwayWhatCanOnlyBeMoved) {
  Result<std::unique_ptr<int>> result(std::make_unique<int>(3));
  const std::unique_ptr<int> taken = *std::move(result);
  EXPECT_EQ(*taken, 3);
}

TEST(Result, CanBeChangedInPlace) {
  Result<std::string> result(std::string("a"));
  *result += "b";
  result->push_back('c');
  EXPECT_EQ(result.value(), "abc");
}

TEST(ResultDeathTest, StopsWhereTheReasonWasNotLookedAt) {
  EXPECT_DEATH(static_cast<void>(Half(7).value()), "7 is odd");
  EXPECT_DEATH(static_cast<void>(Half(8).error()), "holds a value");
  EXPECT_DEATH(static_cast<void>(Status::Ok().error()), "is fine");
}

TEST(Status, IsFineUnlessItSaysOtherwise) {
  EXPECT_TRUE(Status::Ok().ok());
  const Status status = Failure("disk full");
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().kind, Error::Kind::kFailure);
  EXPECT_EQ(status.error().message, "disk full");
}

TEST(CheckDeathTest, NamesThePlaceAndTheBrokenPromise) {
  EXPECT_DEATH(YORB_CHECK(1 + 1 == 3, "sums are right"),
               "result_test.cc:[0-9]+: check failed: 1 \\+ 1 == 3 .sums are right");
  YORB_CHECK(true, "never said");
}

TEST(Id, IsNoneUntilItIsGivenANumber) {
  struct Apple;
  EXPECT_FALSE(Id<Apple>().IsValid());
  EXPECT_TRUE(Id<Apple>(0).IsValid());
  EXPECT_EQ(Id<Apple>(), Id<Apple>());
  EXPECT_NE(Id<Apple>(0), Id<Apple>());
  EXPECT_LT(Id<Apple>(1), Id<Apple>(2));
  EXPECT_EQ(std::hash<Id<Apple>>()(Id<Apple>(7)), std::hash<Id<Apple>>()(Id<Apple>(7)));
}

TEST(Id, KindsDoNotMix) {
  struct Apple;
  struct Pear;
  EXPECT_FALSE((std::is_convertible_v<Id<Apple>, Id<Pear>>));
  EXPECT_FALSE((std::is_convertible_v<uint32_t, Id<Apple>>));
}

}  // namespace
}  // namespace yorb
