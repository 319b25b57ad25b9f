// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>
#include <vector>

namespace yorb {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::internal::CaptureStderr;
using ::testing::internal::CaptureStdout;
using ::testing::internal::GetCapturedStderr;
using ::testing::internal::GetCapturedStdout;

Status Start(const std::string& file, bool to_stdout = false) {
  LogOptions options;
  options.file = file;
  options.to_stdout = to_stdout;
  options.repeats_shown = 3;
  return StartLog(options);
}

class Logs : public ::testing::Test {
 protected:
  void SetUp() override {
    path_ = (std::filesystem::temp_directory_path() / ("yorb_log_" + std::to_string(::getpid()) + ".txt")).string();
  }
  void TearDown() override {
    EXPECT_TRUE(StopLog().ok());
    std::filesystem::remove(path_);
  }

  std::string Content() const {
    std::ifstream file(path_);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
  static long NumLines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

  std::string path_;
};

TEST_F(Logs, WithoutAStartWarningsGoToStandardErrorAndTheRestNowhere) {
  CaptureStdout();
  CaptureStderr();
  LogInfo("quiet");
  LogWarning("kind", "beware");
  LogError("broken");
  EXPECT_EQ(GetCapturedStdout(), "");
  EXPECT_EQ(GetCapturedStderr(), "beware\nbroken\n");
}

TEST_F(Logs, RepeatedWarningsAreShownAFewTimesThenCounted) {
  ASSERT_TRUE(Start(path_).ok());
  CaptureStderr();
  for (int i = 0; i < 10; ++i) LogWarning("picture-skipped", "picture " + std::to_string(i));
  for (int i = 0; i < 3; ++i) LogWarning("other", "other " + std::to_string(i));
  ASSERT_TRUE(StopLog().ok());
  EXPECT_EQ(GetCapturedStderr(),
            "picture 0\npicture 1\npicture 2\nother 0\nother 1\nother 2\npicture-skipped: 7 more of these warnings\n");
  EXPECT_EQ(NumLines(Content()), 7);
}

TEST_F(Logs, InformationGoesToTheFileAndOnlyOnRequestToStandardOutput) {
  ASSERT_TRUE(Start(path_, true).ok());
  CaptureStdout();
  CaptureStderr();
  LogInfo("500 frames in 12.5 s");
  LogWarning("kind", "beware");
  EXPECT_EQ(GetCapturedStdout(), "500 frames in 12.5 s\n");
  EXPECT_EQ(GetCapturedStderr(), "beware\n");
  ASSERT_TRUE(Start(path_).ok());  // a new log begins a new file
  CaptureStdout();
  LogInfo("in the file alone");
  EXPECT_EQ(GetCapturedStdout(), "");
  ASSERT_TRUE(StopLog().ok());
  EXPECT_EQ(NumLines(Content()), 1);
  EXPECT_THAT(Content(), ContainsRegex("^[0-9-]+ [0-9:.]+ info: in the file alone\n"));
}

TEST_F(Logs, BracesArePrintedAsTheyAre) {
  CaptureStderr();
  LogError("{} %s {0:x}");
  EXPECT_EQ(GetCapturedStderr(), "{} %s {0:x}\n");
}

TEST_F(Logs, AFileThatCannotBeWrittenIsBadInput) {
  const Status status = Start("/dev/null/log.txt");
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().kind, Error::Kind::kBadInput);
  EXPECT_THAT(status.error().message, HasSubstr("/dev/null/log.txt cannot be written"));
}

TEST_F(Logs, AFullDiskIsSaidAtTheEnd) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "skipped: no /dev/full";
  ASSERT_TRUE(Start("/dev/full").ok());
  LogInfo("lost");
  const Status status = StopLog();
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().kind, Error::Kind::kFailure);
  EXPECT_THAT(status.error().message, HasSubstr("/dev/full cannot be written whole"));
}

TEST_F(Logs, LinesOfManyThreadsStayWholeAndAllCount) {
  constexpr int kThreads = 4, kLines = 250;
  ASSERT_TRUE(Start(path_).ok());
  CaptureStderr();
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t) {
    threads.emplace_back([t] {
      for (int i = 0; i < kLines; ++i) {
        LogInfo("line of thread " + std::to_string(t));
        LogWarning("many", "warning");
      }
    });
  }
  for (auto& thread : threads) thread.join();
  ASSERT_TRUE(StopLog().ok());
  EXPECT_THAT(GetCapturedStderr(), HasSubstr("many: 997 more of these warnings"));
  std::ifstream file(path_);
  long num_info = 0;
  for (std::string line; std::getline(file, line);)
    num_info += line.find(" info: line of thread ") != std::string::npos;
  EXPECT_EQ(num_info, kThreads * kLines);
}

}  // namespace
}  // namespace yorb
