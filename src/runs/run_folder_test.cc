// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/run_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>

#include "core/files.h"
#include "core/text.h"

namespace yorb {
namespace {

using testing::HasSubstr;

class RunFolder : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = testing::TempDir() + "run_folder_" + testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::remove_all(folder_);
    ASSERT_TRUE(WriteFileWhole(folder_ + "/plain_file", "mine").ok());
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string folder_;
};

TEST_F(RunFolder, IsMadeWithItsParentsAndEmpty) {
  const std::string out = folder_ + "/new/deep/er";
  ASSERT_TRUE(PrepareRunFolder(out).ok());
  EXPECT_TRUE(std::filesystem::is_empty(out));
}

TEST_F(RunFolder, LeavesAnOlderRunUntouched) {
  ASSERT_TRUE(WriteFileWhole(folder_ + "/trajectory.txt", "old").ok());
  ASSERT_TRUE(PrepareRunFolder(folder_).ok());
  EXPECT_EQ(*ReadWholeText(folder_ + "/trajectory.txt"), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 2);
}

TEST_F(RunFolder, IsRefusedByNameWhereItCannotBe) {
  for (const std::string& out :
       {folder_ + "/plain_file", folder_ + "/plain_file/run", folder_ + "/" + std::string(300, 'x')}) {
    const Status status = PrepareRunFolder(out);
    ASSERT_FALSE(status.ok()) << out;
    EXPECT_THAT(status.error().message, HasSubstr(out));
    EXPECT_EQ(status.error().kind, Error::Kind::kBadInput);
  }
  EXPECT_EQ(*ReadWholeText(folder_ + "/plain_file"), "mine");
  EXPECT_FALSE(PrepareRunFolder("").ok());
}

TEST_F(RunFolder, IsRefusedWhereAFolderStandsInAFilesPlace) {
  std::filesystem::create_directories(folder_ + "/trajectory.txt");
  const Status status = PrepareRunFolder(folder_);
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().message, HasSubstr("trajectory.txt"));
}

TEST_F(RunFolder, WithoutANameIsANewOneEveryTime) {
  const auto here = std::filesystem::current_path();
  std::filesystem::current_path(folder_);
  const auto first = MakeDefaultRunFolder(), second = MakeDefaultRunFolder();
  std::filesystem::current_path(here);
  ASSERT_TRUE(first.ok() && second.ok());
  EXPECT_THAT(*first, testing::StartsWith("yorb_20"));
  EXPECT_NE(*first, *second);
}

TEST_F(RunFolder, FilesOfSubmapsThatWereNotWrittenAreOlderOnes) {
  const auto in = [&](const char* name) { return InRunFolder(folder_, name); };
  EXPECT_EQ(NumberedPath(in("x.ply"), 1), in("x.ply"));
  EXPECT_EQ(NumberedPath(in("x.ply"), 3), in("x_3.ply"));
  const std::vector<FileToWrite> written = {{in("x.ply"), ""}, {in("x_3.ply"), ""}};
  for (const char* name : {"x.ply", "x_2.ply", "x_3.ply", "x_4.ply", "x_6.ply"}) {
    ASSERT_TRUE(WriteFileWhole(in(name), "old").ok());
  }
  EXPECT_THAT(OlderFiles(in("x.ply"), written, 3), testing::ElementsAre(in("x_2.ply"), in("x_4.ply")));
}

}  // namespace
}  // namespace yorb
