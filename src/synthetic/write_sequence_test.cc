// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic/write_sequence.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "camera/camera_io.h"
#include "core/text.h"
#include "pictures/picture_file.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> FilesIn(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ostringstream content;
    content << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    files[fs::relative(entry.path(), folder).string()] = content.str();
  }
  return files;
}

class WriteSequenceTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("yorb synth " + std::to_string(::getpid()) + " " +
                                           testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::map<std::string, std::string> Write(int num_threads, int num_people, const WriteHooks& hooks = {}) const {
    SequenceOptions options;
    options.path = PathKind::kStatic;
    options.num_frames = 14;
    options.num_people = num_people;
    options.room.texture_size = 64;
    options.room.has_shadows = false;
    options.rig = SyntheticRig(160, 120);
    EXPECT_TRUE(PrepareFolder(folder_.string(), "a test").ok());
    WriteOptions write;
    write.folder = folder_.string();
    write.num_threads = num_threads;
    EXPECT_TRUE(WriteSequence(SyntheticSequence(options), write, hooks).ok());
    return FilesIn(folder_);
  }

  fs::path folder_;
};

TEST_F(WriteSequenceTest, ListsNameFilesThatAreThere) {
  const auto files = Write(2, 3);
  EXPECT_EQ(files.size(), 3 * 14 + 6u);
  for (const char* name : {"rgb.txt", "depth.txt"}) {
    const auto list = ReadTextFile((folder_ / name).string());
    ASSERT_TRUE(list.ok());
    ASSERT_EQ(list->lines.size(), 14u);
    for (const TextLine& line : list->lines) {
      const auto fields = SplitAtBlanks(line.text);
      ASSERT_EQ(fields.size(), 2u);
      const cv::Mat picture = ReadPictureFile((folder_ / std::string(fields[1])).string()).pixels;
      EXPECT_EQ(picture.size(), cv::Size(160, 120));
      EXPECT_EQ(picture.type(), std::string(name) == "rgb.txt" ? CV_8UC3 : CV_16UC1);
      const cv::Mat mask = ReadPictureFile((folder_ / "mask" / (std::string(fields[0]) + ".png")).string()).pixels;
      EXPECT_EQ(mask.type(), CV_8UC1);
    }
  }
  EXPECT_EQ(ReadTextFile((folder_ / "groundtruth.txt").string())->lines.size(), 14u);
  const auto rig = ReadCameraFile((folder_ / "camera.yaml").string());
  ASSERT_TRUE(rig.ok());
  EXPECT_EQ(rig->camera.fx, SyntheticRig(160, 120).camera.fx);
  EXPECT_EQ(rig->camera.width, 160);
}

TEST_F(WriteSequenceTest, TheSameFilesOnAnyNumberOfThreads) {
  const auto one = Write(1, 1), three = Write(3, 1);
  EXPECT_EQ(one, three);
}

TEST_F(WriteSequenceTest, ReplacesAnEarlierRenderingWhole) {
  Write(2, 2);
  const auto files = Write(2, 0);
  for (const auto& file : files) EXPECT_NE(file.first.substr(0, 4), "mask") << file.first;
  EXPECT_EQ(ReadTextFile((folder_ / "people.txt").string())->lines.size(), 0u);
}

TEST_F(WriteSequenceTest, StopsEarlyWithListsOfWhatIsThere) {
  size_t num_done = 0;
  WriteHooks hooks;
  hooks.on_progress = [&](size_t done, size_t) { num_done = done; };
  hooks.should_stop = [&] { return num_done > 0; };
  Write(1, 0, hooks);
  EXPECT_EQ(num_done, 4u);
  EXPECT_EQ(ReadTextFile((folder_ / "rgb.txt").string())->lines.size(), 4u);
  EXPECT_EQ(ReadTextFile((folder_ / "groundtruth.txt").string())->lines.size(), 4u);
}

TEST_F(WriteSequenceTest, LeavesSomebodysFilesAlone) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "rgb.txt") << "precious\n";
  const Status status = PrepareFolder(folder_.string(), "a test");
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().kind, Error::Kind::kBadInput);
  EXPECT_EQ(FilesIn(folder_).at("rgb.txt"), "precious\n");
  EXPECT_FALSE(PrepareFolder((folder_ / "rgb.txt").string(), "a test").ok());
  EXPECT_FALSE(PrepareFolder("/proc/no", "a test").ok());
  EXPECT_FALSE(PrepareFolder("", "a test").ok());
}

}  // namespace
}  // namespace yorb
