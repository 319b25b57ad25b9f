// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/log.h"
#include "core/stopwatch.h"
#include "core/text.h"
#include "runs/test_dataset.h"

namespace yorb {
namespace {

using testing::HasSubstr;

class Runs : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    std::replace(name.begin(), name.end(), '/', '_');
    out_ = testing::TempDir() + "runs_" + name;
    std::filesystem::remove_all(out_);
    cv::setNumThreads(1);
    ASSERT_TRUE(StartLog({.keeps_text = true}).ok());
  }
  void TearDown() override {
    EXPECT_TRUE(StopLog().ok());
    std::filesystem::remove_all(out_);
  }

  RunOptions Options(const std::string& mode) const {
    RunOptions options;
    options.config.mode = mode;
    options.config.features.wanted = 300;
    options.out = out_;
    options.title = "wall";
    return options;
  }
  std::string Text(const std::string& file) const { return *ReadWholeText(out_ + "/" + file); }
  nlohmann::json Metrics() const { return nlohmann::json::parse(Text("metrics.json")); }
  size_t Lines(const std::string& file) const {
    const std::string text = Text(file);
    return static_cast<size_t>(std::count(text.begin(), text.end(), '\n'));
  }

  std::string out_;
};

INSTANTIATE_TEST_SUITE_P(Modes, Runs, testing::Values("inline", "offline", "live"));

TEST_P(Runs, WriteAllFilesAndNothingElse) {
  const auto summary = RunSequence(WallDataset(12), Options(GetParam()), {});
  ASSERT_TRUE(summary.ok()) << summary.error().message;
  EXPECT_FALSE(summary->error) << summary->error->message;
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(out_)) names.push_back(entry.path().filename().string());
  EXPECT_THAT(names, testing::UnorderedElementsAre("config.yaml", "trajectory.txt", "keyframes.txt", "metrics.json",
                                                   "frames.csv", "log.txt", "report.html"));
  EXPECT_EQ(Metrics()["frames"], 12);
  EXPECT_EQ(Metrics()["tracked"], summary->tracked);
  EXPECT_EQ(Metrics()["mode"], GetParam());
  EXPECT_EQ(Lines("frames.csv"), 13u);
  EXPECT_THAT(Text("log.txt"), HasSubstr("frames tracked"));
}

TEST_P(Runs, OfNoUseToTheTrackerEndCleanly) {
  for (const size_t count : {1, 2}) {
    const auto summary = RunSequence(WallDataset(count), Options(GetParam()), {});
    ASSERT_TRUE(summary.ok()) << summary.error().message;
    EXPECT_EQ(Metrics()["frames"], count);
  }
}

TEST_P(Runs, StoppedByASignalWriteWhatTheyHave) {
  size_t num_done = 0;
  RunHooks hooks;
  hooks.on_progress = [&](const RunProgress& now) { num_done = now.num_done; };
  hooks.should_stop = [&] { return num_done == 7; };
  const auto summary = RunSequence(WallDataset(1000, 100), Options(GetParam()), hooks);
  ASSERT_TRUE(summary.ok()) << summary.error().message;
  EXPECT_TRUE(summary->was_stopped);
  EXPECT_EQ(summary->frames, 7u);
  EXPECT_EQ(Metrics()["frames"], 7);
  EXPECT_EQ(Lines("frames.csv"), 8u);
}

TEST_P(Runs, ThatCannotGoOnWriteWhatTheyHaveAndSayWhy) {
  WallDataset dataset(20);
  dataset.broken = {9};
  const auto summary = RunSequence(dataset, Options(GetParam()), {});
  ASSERT_TRUE(summary.ok()) << summary.error().message;
  ASSERT_TRUE(summary->error.has_value());
  EXPECT_EQ(summary->error->message, "wall/9 is broken");
  EXPECT_EQ(Metrics()["frames"], 9);
}

TEST_F(Runs, EndWhereThePicturesChangeTheirSize) {
  WallDataset dataset(20);
  dataset.narrow_from = 5;
  const auto summary = RunSequence(dataset, Options("offline"), {});
  ASSERT_TRUE(summary.ok()) << summary.error().message;
  ASSERT_TRUE(summary->error.has_value());
  EXPECT_EQ(summary->error->kind, Error::Kind::kBadInput);
  EXPECT_THAT(summary->error->message, HasSubstr("160x240"));
  EXPECT_EQ(Metrics()["frames"], 5);
}

TEST_F(Runs, SkipUnreadablePicturesAndCountThem) {
  WallDataset dataset(12);
  dataset.unreadable = {4, 6};
  const auto summary = RunSequence(dataset, Options("inline"), {});
  ASSERT_TRUE(summary.ok());
  EXPECT_EQ(Metrics()["skipped"], 2);
  EXPECT_EQ(Metrics()["frames"], 12);
  EXPECT_THAT(Text("frames.csv"), HasSubstr(ToString(dataset.TimeOf(4)) + ",skipped,"));
}

TEST_F(Runs, OfPicturesToBeTurnedSayOnceWhichPixelsGivenBoxesMean) {
  WallDataset wall(4);
  wall.orientation = 6;
  const std::string boxes = out_ + "_boxes.jsonl";
  ASSERT_TRUE(WriteFileWhole(boxes, ""));
  RunOptions options = Options("inline");
  for (const bool are_given : {false, true}) {
    options.config.detections = are_given ? boxes : "";
    const auto summary = RunSequence(wall, options, {});
    ASSERT_TRUE(summary.ok()) << summary.error().message;
    const std::string log = Text("log.txt"), complaint = "the boxes of " + boxes + " must be in pixels of the stored";
    const size_t first = log.find(complaint);
    EXPECT_EQ(first != std::string::npos, are_given) << log;
    EXPECT_EQ(first, log.rfind(complaint)) << "once, or never";
  }
  std::filesystem::remove(boxes);
}

TEST_F(Runs, WithoutAMapSayWhy) {
  RunOptions options = Options("inline");
  options.config.tracking.min_first_points = 20000;
  options.config.features.wanted = 20000;
  const auto summary = RunSequence(WallDataset(3), options, {});
  ASSERT_TRUE(summary.ok());
  EXPECT_FALSE(summary->error.has_value());
  EXPECT_EQ(Metrics()["tracked"], 0);
  EXPECT_THAT(Text("log.txt"), HasSubstr("no map began: none of the 3 frames shows 20000 corners with depth"));
}

TEST_F(Runs, WithoutAMapSayThatBoxesHideEverything) {
  const std::string boxes = out_ + "_boxes.txt";
  ASSERT_TRUE(WriteFileWhole(boxes, "100 0 0 9999 9999 1\n"));
  RunOptions options = Options("inline");
  options.config.dynamics = "exact";
  options.config.detections = boxes;
  ASSERT_TRUE(RunSequence(WallDataset(1), options, {}).ok());
  EXPECT_THAT(Text("log.txt"), HasSubstr("all of it within boxes of what moves?"));
  std::filesystem::remove(boxes);
}

TEST_F(Runs, NameSomeOfManyUnknownClassesInOneLine) {
  const std::string boxes = out_ + "_boxes.jsonl";
  std::string list;
  for (int i = 10; i < 40; ++i) {
    list += (i > 10 ? ", " : "") + std::string("{\"name\": \"thing") + std::to_string(i) + "\", \"box\": [1, 1, 9, 9]}";
  }
  ASSERT_TRUE(WriteFileWhole(boxes, "{\"timestamp\": 100, \"boxes\": [" + list + "]}\n"));
  RunOptions options = Options("inline");
  options.config.detections = boxes;
  ASSERT_TRUE(RunSequence(WallDataset(1), options, {}).ok());
  EXPECT_THAT(Text("log.txt"), HasSubstr("of the class 'thing10', 'thing11', "));
  EXPECT_THAT(Text("log.txt"), HasSubstr("'thing19' and 20 more; it counts as static"));
  std::filesystem::remove(boxes);
}

TEST_F(Runs, TakeOnlySoManyFrames) {
  RunOptions options = Options("inline");
  options.config.max_frames = 5;
  ASSERT_TRUE(RunSequence(WallDataset(12), options, {}).ok());
  EXPECT_EQ(Metrics()["frames"], 5);
  options.config.max_frames = 1000000000;
  ASSERT_TRUE(RunSequence(WallDataset(12), options, {}).ok());
  EXPECT_EQ(Metrics()["frames"], 12);
}

TEST_F(Runs, SaveAsTheyGo) {
  RunOptions options = Options("inline");
  options.save_every_s = 0;
  bool is_saved = true;
  RunHooks hooks;
  hooks.on_progress = [&](const RunProgress& now) {
    if (now.num_done > 1) is_saved = is_saved && std::filesystem::exists(out_ + "/trajectory.txt");
  };
  ASSERT_TRUE(RunSequence(WallDataset(6), options, hooks).ok());
  EXPECT_TRUE(is_saved);
}

TEST_F(Runs, TakeAwayWhatAnOlderOneLeftOfFurtherSubmaps) {
  for (const char* name : {"trajectory_2.txt", "keyframes_2.txt", "keyframes_3.txt", "notes_2.txt"}) {
    ASSERT_TRUE(WriteFileWhole(out_ + "/" + name, "old").ok());
  }
  ASSERT_TRUE(RunSequence(WallDataset(5), Options("inline"), {}).ok());
  for (const char* name : {"trajectory_2.txt", "keyframes_2.txt", "keyframes_3.txt"}) {
    EXPECT_FALSE(std::filesystem::exists(out_ + "/" + name)) << name;
  }
  EXPECT_EQ(Text("notes_2.txt"), "old");
}

TEST_F(Runs, ThatCannotBeginLeaveAnOlderRunAlone) {
  ASSERT_TRUE(WriteFileWhole(out_ + "/trajectory.txt", "old").ok());
  WallDataset dataset(5);
  dataset.broken = {0};
  const auto summary = RunSequence(dataset, Options("inline"), {});
  ASSERT_TRUE(summary.ok());
  EXPECT_TRUE(summary->error.has_value());
  EXPECT_EQ(Text("trajectory.txt"), "old");
}

TEST_F(Runs, ThatCannotBeWrittenSayWhichFileAndLeaveTheOldOnes) {
  ASSERT_TRUE(WriteFileWhole(out_ + "/trajectory.txt", "old").ok());
  RunHooks hooks;  // somebody puts a folder in the way while the run goes on
  hooks.on_progress = [&](const RunProgress&) {
    std::filesystem::create_directories(out_ + "/keyframes.txt.part/full");
  };
  const auto summary = RunSequence(WallDataset(5), Options("inline"), hooks);
  ASSERT_TRUE(summary.ok());
  ASSERT_TRUE(summary->error.has_value());
  EXPECT_EQ(summary->error->kind, Error::Kind::kFailure);
  EXPECT_THAT(summary->error->message, HasSubstr("keyframes.txt"));
  EXPECT_EQ(Text("trajectory.txt"), "old");
}

TEST_F(Runs, HaveTheirTrajectoryThoughTheReportDoesNotFit) {
  RunHooks hooks;
  hooks.on_progress = [&](const RunProgress&) { std::filesystem::create_directories(out_ + "/report.html.part/full"); };
  const auto summary = RunSequence(WallDataset(5), Options("inline"), hooks);
  ASSERT_TRUE(summary.ok());
  ASSERT_TRUE(summary->error.has_value());
  EXPECT_THAT(summary->error->message, HasSubstr("report.html"));
  EXPECT_THAT(Text("trajectory.txt"), HasSubstr("\n"));
  EXPECT_THAT(Text("metrics.json"), HasSubstr("coverage"));
}

TEST_F(Runs, LiveGoAtThePaceOfTheTimeStampsButWaitNoLongerThanASecond) {
  const Stopwatch watch;
  ASSERT_TRUE(RunSequence(WallDataset(6, 10), Options("live"), {}).ok());
  EXPECT_GE(watch.seconds(), 0.5);
  const Stopwatch long_gap;
  ASSERT_TRUE(RunSequence(WallDataset(2, 0.001), Options("live"), {}).ok());  // 1000 s apart
  EXPECT_GE(long_gap.seconds(), 1.0);
  EXPECT_LT(long_gap.seconds(), 10.0);
}

}  // namespace
}  // namespace yorb
