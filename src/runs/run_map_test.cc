// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/run_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/log.h"
#include "core/text.h"
#include "runs/map_export.h"
#include "runs/run.h"
#include "runs/test_dataset.h"

namespace yorb {
namespace {

using testing::HasSubstr;

/// The wall in an unlit room.
class DarkWall : public WallDataset {
 public:
  using WallDataset::WallDataset;
  Result<LoadedFrame> Load(size_t i) const override {
    auto frame = WallDataset::Load(i);
    frame->images->grey.setTo(0);
    return frame;
  }
};

/// Pictures of another recording in a new order, seconds apart.
class Photos : public WallDataset {
 public:
  explicit Photos(std::vector<size_t> order) : WallDataset(order.size(), 0.5), order_(std::move(order)) {}
  Result<LoadedFrame> Load(size_t i) const override {
    auto frame = WallDataset::Load(order_[i]);
    frame->images->timestamp = TimeOf(i);
    return frame;
  }

 private:
  std::vector<size_t> order_;
};

class RunMaps : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    folder_ = testing::TempDir() + "run_maps_" + std::to_string(::getpid()) + "/";
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    cv::setNumThreads(1);
    ASSERT_TRUE(StartLog({.keeps_text = true}).ok());
  }
  void TearDown() override {
    EXPECT_TRUE(StopLog().ok());
    std::filesystem::remove_all(folder_);
  }

  std::string In(const std::string& name) const { return folder_ + name; }
  std::string Bytes(const std::string& name) const {
    std::ifstream file(In(name), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  }
  std::string Text(const std::string& file) const { return *ReadWholeText(In(file)); }

  /// The first coordinates of a trajectory.
  std::vector<double> AlongTheWall(const std::string& file) const {
    std::vector<double> x;
    const TextFile text = *ReadTextFile(In(file));
    for (const TextLine& line : text.lines) x.push_back(*ParseDouble(SplitAtBlanks(line.text)[1]));
    return x;
  }

  RunOptions Options(const std::string& out, const std::string& load, const std::string& save) const {
    RunOptions options;
    options.config.mode = "inline";
    options.config.features.wanted = 300;
    options.out = In(out);
    options.title = "wall";
    if (!load.empty()) options.config.load_map = In(load);
    if (!save.empty()) options.save_map = In(save);
    return options;
  }

  RunSummary Done(const Dataset& dataset, const RunOptions& options, const RunHooks& hooks = {}) const {
    auto summary = RunSequence(dataset, options, hooks);
    EXPECT_TRUE(summary.ok()) << summary.error().message;
    return summary ? *std::move(summary) : RunSummary();
  }

  void ExpectCounts(const RunSummary& summary, const std::string& map) const {
    const auto saved = ReadMapFile(In(map));
    ASSERT_TRUE(saved.ok()) << saved.error().message;
    EXPECT_EQ(saved->map.num_keyframes(), summary.keyframes);
    EXPECT_EQ(saved->map.num_landmarks(), summary.landmarks);
  }

  std::string Refusal(const RunOptions& options) const {
    const auto summary = RunSequence(WallDataset(3), options, {});
    if (summary.ok()) return "";
    EXPECT_EQ(summary.error().kind, Error::Kind::kBadInput);
    return summary.error().message;
  }

  /// A slow machine (or a sanitizer) may drop any frame of a live run.
  static size_t AtLeast(size_t count) { return std::string(GetParam()) == "live" ? 0 : count; }

  std::string folder_;
};

INSTANTIATE_TEST_SUITE_P(Modes, RunMaps, testing::Values("inline", "offline", "live"));

TEST_P(RunMaps, AreSavedAndGoneOnWith) {
  RunOptions first = Options("a", "", "a.map");
  first.config.mode = GetParam();
  const RunSummary made = Done(WallDataset(30, 60), first);
  EXPECT_EQ(made.map, In("a.map"));
  ExpectCounts(made, "a.map");
  const std::string before = Bytes("a.map");

  RunOptions second = Options("b", "a.map", "b.map");
  second.config.mode = GetParam();
  const RunSummary continued = Done(WallDataset(60, 60), second);
  EXPECT_EQ(Bytes("a.map"), before) << "what is loaded is only read";
  ExpectCounts(continued, "b.map");
  EXPECT_GT(continued.tracked, AtLeast(40));
  EXPECT_GE(continued.keyframes, made.keyframes + AtLeast(1));
  EXPECT_EQ(nlohmann::json::parse(Text("b/metrics.json"))["tracked"], continued.tracked);
}

TEST_P(RunMaps, StoppedByASignalAreSaved) {
  RunOptions options = Options("a", "", "a.map");
  options.config.mode = GetParam();
  size_t num_done = 0;
  RunHooks hooks;
  hooks.on_progress = [&](const RunProgress& progress) { num_done = progress.num_done; };
  hooks.should_stop = [&] { return num_done >= 10; };
  const RunSummary summary = Done(WallDataset(60, 60), options, hooks);
  EXPECT_TRUE(summary.was_stopped);
  ExpectCounts(summary, "a.map");
}

TEST_F(RunMaps, GoOnInTheFrameOfTheFirstRun) {
  Done(WallDataset(30), Options("a", "", "a.map"));
  Done(WallDataset(30), Options("b", "a.map", "b.map"));
  // The same pictures again: the camera is where it was, and the old keyframes are all there.
  const std::vector<double> first = AlongTheWall("a/trajectory.txt"), second = AlongTheWall("b/trajectory.txt");
  ASSERT_EQ(first.size(), 30u);
  ASSERT_EQ(second.size(), 30u);
  for (size_t i = 0; i < first.size(); ++i) EXPECT_NEAR(first[i], second[i], 0.01) << i;
  const SavedMap old = *ReadMapFile(In("a.map")), now = *ReadMapFile(In("b.map"));
  EXPECT_GE(now.map.next_keyframe().value(), old.map.next_keyframe().value());
  EXPECT_EQ(AlongTheWall("b/keyframes.txt").size(), now.map.num_keyframes());
}

TEST_F(RunMaps, LocatingChangesNothingAndGivesTheSameTwice) {
  Done(WallDataset(60), Options("a", "", "a.map"));
  RunOptions options = Options("b", "a.map", "");
  options.config.localize_only = true;
  const RunSummary once = Done(WallDataset(50), options);
  options.out = In("c");
  const RunSummary twice = Done(WallDataset(50), options);
  EXPECT_GE(once.tracked, 48u);
  EXPECT_EQ(Text("b/trajectory.txt"), Text("c/trajectory.txt"));
  const SavedMap saved = *ReadMapFile(In("a.map"));
  EXPECT_EQ(once.keyframes, saved.map.num_keyframes());
  EXPECT_EQ(once.landmarks, saved.map.num_landmarks());
  const TextFile frames = *ReadTextFile(In("b/frames.csv"));
  for (const TextLine& line : frames.lines) {
    EXPECT_NE(SplitAt(line.text, ',')[8], "1") << "a keyframe";
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 4) << "a.map and three folders";
}

TEST_F(RunMaps, SinglePicturesInNoOrderAreLocatedOneByOne) {
  Done(WallDataset(90), Options("a", "", "a.map"));
  RunOptions options = Options("b", "a.map", "");
  options.config.localize_only = true;
  const std::vector<size_t> order = {70, 5, 45, 80, 20, 60, 10, 35};
  EXPECT_EQ(Done(Photos(order), options).tracked, order.size());
  const std::vector<double> x = AlongTheWall("b/trajectory.txt");
  for (size_t i = 0; i < order.size(); ++i) {
    EXPECT_NEAR(x[i], 0.006 * static_cast<double>(order[i]), 0.02) << "picture " << order[i];
  }
}

TEST_F(RunMaps, AreSavedWholeWhereNothingIsSeenAny) {
  const RunSummary made = Done(WallDataset(30), Options("a", "", "a.map"));
  const RunSummary dark = Done(DarkWall(10), Options("b", "a.map", "b.map"));
  EXPECT_EQ(dark.tracked, 0u);
  EXPECT_EQ(Bytes("b.map"), Bytes("a.map"));
  EXPECT_THAT(LogText(), HasSubstr("none of the 10 frames was found in the map"));
  ExpectCounts(made, "b.map");
}

/// Another wall: this one in a mirror.
class OtherWall : public WallDataset {
 public:
  using WallDataset::WallDataset;
  Result<LoadedFrame> Load(size_t i) const override {
    auto frame = WallDataset::Load(i);
    cv::flip(frame->images->grey, frame->images->grey, 1);
    return frame;
  }
};

TEST_P(RunMaps, GetANewSubmapWhereNothingIsRecognised) {
  Done(WallDataset(30), Options("a", "", "a.map"));
  RunOptions options = Options("b", "a.map", "b.map");
  options.config.mode = GetParam();
  options.config.tracking.new_map_after_s = 0.5;
  const RunSummary elsewhere = Done(OtherWall(60), options);
  EXPECT_EQ(elsewhere.tracked, 0u) << "trajectory.txt is in the world of the map that was loaded";
  EXPECT_EQ(AlongTheWall("b/trajectory.txt").size(), 0u);
  EXPECT_GE(AlongTheWall("b/trajectory_2.txt").size(), AtLeast(60)) << "with the frames that the camera was lost in";
  ExpectCounts(elsewhere, "b.map");
  EXPECT_EQ(Text("b/keyframes.txt"), Text("a/keyframes.txt"));

  options = Options("c", "b.map", "");
  options.config.localize_only = true;
  EXPECT_GT(Done(WallDataset(20), options).tracked, 18u) << "the first place is still known";
  options.config.tracking.new_map_after_s = 0;
  options.config.load_map = In("a.map");
  const RunSummary lost = Done(OtherWall(20), options);
  EXPECT_EQ(lost.tracked, 0u);
  EXPECT_EQ(lost.keyframes, ReadMapFile(In("a.map"))->map.num_keyframes()) << "nothing begins while locating only";
}

TEST_F(RunMaps, AreExportedInTheOrderOfTheRunsResults) {
  Done(WallDataset(30), Options("a", "", "a.map"));
  RunOptions options = Options("b", "a.map", "b.map");
  options.config.tracking.new_map_after_s = 0.5;
  Done(OtherWall(90), options);
  const auto files = ExportedFiles(*ReadMapFile(In("b.map")), "x.txt", MapExport::kKeyframes);
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].content, Text("b/keyframes.txt"));
  EXPECT_EQ(files[1].content, Text("b/keyframes_2.txt"));
}

TEST_F(RunMaps, WithoutAKeyframeAreNotWritten) {
  const RunSummary summary = Done(DarkWall(10), Options("a", "", "a.map"));
  EXPECT_FALSE(summary.error);
  EXPECT_EQ(summary.map, "");
  EXPECT_FALSE(std::filesystem::exists(In("a.map")));
  EXPECT_THAT(LogText(), HasSubstr("a.map was not written"));
}

TEST_F(RunMaps, ThatCannotBeReadAreNotOverwritten) {
  Done(WallDataset(20), Options("a", "", "a.map"));
  const std::string cut = Bytes("a.map").substr(0, 5000);
  std::ofstream(In("a.map"), std::ios::binary) << cut;
  EXPECT_THAT(Refusal(Options("b", "a.map", "a.map")), HasSubstr("a.map is damaged"));
  EXPECT_EQ(Bytes("a.map"), cut);
  EXPECT_FALSE(std::filesystem::exists(In("b")));
}

TEST_F(RunMaps, ThatCannotBeWrittenAreRefusedBeforeAnyWork) {
  std::filesystem::create_directories(In("folder"));
  ASSERT_TRUE(WriteFileWhole(In("notes.txt"), "mine").ok());
  for (const char* name : {"folder", "notes.txt", "notes.txt/a.map"}) {
    EXPECT_THAT(Refusal(Options("b", "", name)), HasSubstr(In(name)));
  }
  EXPECT_EQ(Text("notes.txt"), "mine");
  EXPECT_FALSE(std::filesystem::exists(In("b")));
}

TEST_F(RunMaps, ThatAndOtherResultsWouldTakeEachOthersPlaceAreRefusedBeforeAnyWork) {
  for (const char* name : {"new/", "new/.", "b", "b/", "b/.", "b/config.yaml", "b/trajectory.txt", "b/trajectory_2.txt",
                           "b/keyframes.txt", "b/keyframes_12.txt", "b/metrics.json", "b/frames.csv", "b/log.txt",
                           "b/report.html", "b/report.html/a.map", "./b/x/../log.txt"}) {
    EXPECT_THAT(Refusal(Options("b", "", name)), HasSubstr(In(name)));
  }
  EXPECT_THAT(Refusal(Options("b/c", "", "b")), HasSubstr(In("b"))) << "a folder above the results";
  RunOptions options = Options("b", "", "o");
  options.overlay = In("o");
  EXPECT_THAT(Refusal(options), HasSubstr(In("o")));
  EXPECT_TRUE(std::filesystem::is_empty(folder_)) << "something was made";
  for (const char* name : {"b/office.map", "b/trajectory_of_b.txt", "b/sub/trajectory.txt"}) {
    ExpectCounts(Done(WallDataset(10), Options("b", "", name)), name);
  }
}

TEST_F(RunMaps, BehindALinkAreFoundToBeInThePlaceOfAResult) {
  std::filesystem::create_directories(In("b"));
  std::filesystem::create_directory_symlink("b", In("link"));
  EXPECT_THAT(Refusal(Options("b", "", "link/trajectory.txt")), HasSubstr(In("link/trajectory.txt")));
  EXPECT_THAT(Refusal(Options("link", "", "b/log.txt")), HasSubstr(In("b/log.txt")));
  EXPECT_TRUE(std::filesystem::is_empty(In("b")));
}

TEST_F(RunMaps, OptionsThatContradictAreRefusedByName) {
  Done(WallDataset(20), Options("a", "", "a.map"));
  RunOptions without = Options("b", "", "");
  without.config.localize_only = true;
  EXPECT_THAT(Refusal(without), HasSubstr("--load-map"));
  RunOptions saving = Options("b", "a.map", "b.map");
  saving.config.localize_only = true;
  EXPECT_THAT(Refusal(saving), HasSubstr("--save-map"));
}

/// The wall in the eyes of somebody who measured the camera otherwise.
class OtherCamera : public WallDataset {
 public:
  explicit OtherCamera(size_t count) : WallDataset(count), rig_(WallDataset::rig()) {
    rig_.camera.fx = rig_.camera.fy = 330;
    rig_.name = "other";
  }
  const Rig& rig() const override { return rig_; }

 private:
  Rig rig_;
};

TEST_F(RunMaps, KeepTheirCamera) {
  Done(WallDataset(30), Options("a", "", "a.map"));
  RunOptions options = Options("b", "a.map", "");
  const auto refused = RunSequence(OtherCamera(20), options, {});
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.error().message, testing::AllOf(HasSubstr("a.map"), HasSubstr("other"), HasSubstr("wall")));
  EXPECT_FALSE(std::filesystem::exists(In("b")));
  options.config.localize_only = true;
  EXPECT_GE(Done(OtherCamera(20), options).tracked, 18u);
  EXPECT_THAT(LogText(), HasSubstr("made with the camera wall"));
}

}  // namespace
}  // namespace yorb
