// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>

#include "core/text.h"

namespace yorb {
namespace {

using testing::HasSubstr;

class Files : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = testing::TempDir() + "files_" + testing::UnitTest::GetInstance()->current_test_info()->name() + "/";
    std::filesystem::remove_all(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string Text(const std::string& name) const { return *ReadWholeText(folder_ + name); }
  size_t Count() const { return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(folder_), {})); }

  std::string folder_;
};

TEST_F(Files, AreWrittenWithTheirParentsAndReplaced) {
  ASSERT_TRUE(WriteFileWhole(folder_ + "a/b/c.txt", "one").ok());
  ASSERT_TRUE(WriteFileWhole(folder_ + "a/b/c.txt", "two").ok());
  EXPECT_EQ(Text("a/b/c.txt"), "two");
}

TEST(UntakenPath, CountsUntilNoOtherHasTheName) {
  std::set<std::string> taken;
  EXPECT_EQ(UntakenPath("a/x.jpg", taken), "a/x.jpg");
  EXPECT_EQ(UntakenPath("a/x.jpg", taken), "a/x_2.jpg");
  EXPECT_EQ(UntakenPath("a/x.jpg", taken), "a/x_3.jpg");
  EXPECT_EQ(UntakenPath("b/x.jpg", taken), "b/x.jpg");
  EXPECT_EQ(UntakenPath("x.png", taken), "x.png");
  EXPECT_EQ(UntakenPath("x.png", taken), "x_2.png");
}

TEST(OwnName, IsTheLastPartHoweverAPathIsWritten) {
  for (const char* path : {"a", "a/", "b/a", "/b/a/.", "b/../a//", "./a"}) EXPECT_EQ(OwnName(path), "a") << path;
  EXPECT_EQ(OwnName("."), std::filesystem::current_path().filename().string());
  EXPECT_EQ(OwnName("/"), "/");
}

TEST_F(Files, LeaveNoDraftsBehind) {
  ASSERT_TRUE(WriteFilesTogether({{folder_ + "a", "1"}, {folder_ + "b", "2"}}).ok());
  EXPECT_EQ(Count(), 2u);
  EXPECT_EQ(Text("a") + Text("b"), "12");
}

TEST_F(Files, TwoOfOnePathAreAMistakeOfOurs) {
  EXPECT_DEATH((void)WriteFilesTogether({{folder_ + "a", "1"}, {folder_ + "a", "2"}}), "two files of one path");
}

TEST_F(Files, NoneIsReplacedWhereOneCannotBeWritten) {
  ASSERT_TRUE(WriteFilesTogether({{folder_ + "a", "old"}, {folder_ + "b", "old"}}).ok());
  const Status status = WriteFilesTogether({{folder_ + "a", "new"}, {folder_ + "b", "new"}, {folder_ + "a/c", "new"}});
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().message, HasSubstr(folder_ + "a/c cannot be written"));
  EXPECT_EQ(status.error().kind, Error::Kind::kFailure);
  EXPECT_EQ(Text("a") + Text("b"), "oldold");
  EXPECT_EQ(Count(), 2u);
}

TEST_F(Files, AFolderInTheWayIsNamedAndNothingRemains) {
  std::filesystem::create_directories(folder_ + "a/full");
  const Status status = WriteFileWhole(folder_ + "a", "new");
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().message, HasSubstr(folder_ + "a cannot be written"));
  EXPECT_EQ(Count(), 1u);
}

TEST_F(Files, ALinkIsReplacedAndNotWrittenThrough) {
  std::filesystem::create_directories(folder_);
  std::filesystem::create_symlink("/dev/full", folder_ + "a");
  EXPECT_TRUE(WriteFileWhole(folder_ + "a", "new").ok());
  EXPECT_EQ(Text("a"), "new");
}

}  // namespace
}  // namespace yorb
