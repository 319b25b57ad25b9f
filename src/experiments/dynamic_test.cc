// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/dynamic.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "experiments/dynamic_figures.h"
#include "experiments/dynamic_text.h"
#include "experiments/test_room.h"
#include "pictures/test_folder.h"

namespace yorb {
namespace {

constexpr int kNumFrames = 10;

/// What stands beside the pictures of a room with people, in a scratch folder.
void WriteTruth(const RoomDataset& room, const TestFolder& folder) {
  std::string people;
  std::filesystem::create_directories(folder.Path("mask"));
  for (const RenderedFrame& frame : room.frames()) {
    const std::string time = ToString(frame.images.timestamp);
    folder.WritePicture("mask/" + time + ".png", frame.mask);
    for (const PersonBox& box : frame.boxes) {
      people += time;
      for (const int number : {box.left, box.top, box.right, box.bottom, box.num_visible_px}) {
        people += " " + std::to_string(number);
      }
      people += "\n";
    }
  }
  folder.Write("people.txt", people);
}

/// The ways that need no network.
class DynamicBench : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    room_ = new RoomDataset(kNumFrames, 3);
    folder_ = new TestFolder();
    WriteTruth(*room_, *folder_);
    options_ = new DynamicBenchOptions();
    options_->config.mode = "inline";
    options_->ways = {dynamic_way::kOff, dynamic_way::kFullExact, dynamic_way::kOriginal};
    options_->num_runs = 2;
    report_ = new Result<DynamicReport>(MeasureDynamic({Room()}, *options_, {}));
  }
  static void TearDownTestSuite() {
    delete report_;
    delete options_;
    delete folder_;
    delete room_;
  }
  static DynamicSequence Room() {
    return {"room", room_, room_->Truth(), folder_->Path("people.txt"), folder_->Path("mask")};
  }

  static RoomDataset* room_;
  static TestFolder* folder_;
  static DynamicBenchOptions* options_;
  static Result<DynamicReport>* report_;
};
RoomDataset* DynamicBench::room_ = nullptr;
TestFolder* DynamicBench::folder_ = nullptr;
DynamicBenchOptions* DynamicBench::options_ = nullptr;
Result<DynamicReport>* DynamicBench::report_ = nullptr;

TEST_F(DynamicBench, RunsEveryWayWithEverySeedInTheOrderOfTheTables) {
  ASSERT_TRUE(report_->ok()) << report_->error().message;
  const auto& runs = (*report_)->runs;
  ASSERT_EQ(runs.size(), 6u);
  const std::vector<std::string> ways = {dynamic_way::kOriginal, dynamic_way::kOff, dynamic_way::kFullExact};
  for (size_t i = 0; i < runs.size(); ++i) {
    EXPECT_EQ(runs[i].way, ways[i / 2]);
    EXPECT_EQ(runs[i].seed, static_cast<int64_t>(1 + i % 2));
    EXPECT_EQ(runs[i].num_frames, static_cast<size_t>(kNumFrames));
    EXPECT_TRUE(runs[i].evaluation.has_value());
  }
  EXPECT_EQ(runs[4].coverage, 1);
}

TEST_F(DynamicBench, PointsGoWhereThePeopleAreAndOnlyWithBoxes) {
  ASSERT_TRUE(report_->ok());
  const DynamicRun &off = (*report_)->runs[2], &exact = (*report_)->runs[4];
  ASSERT_TRUE(off.removal && exact.removal);
  EXPECT_EQ(off.num_removed, 0);
  EXPECT_EQ(off.removal->num_removed_rightly + off.removal->num_removed_wrongly, 0u);
  EXPECT_GT(off.removal->num_kept_wrongly, 50u);  // there are people with corners
  EXPECT_GT(exact.removal->Recall(), 0.9);
  // By far more of what was removed moves than of all points.
  const RemovalScore& all = *off.removal;
  const double share =
      static_cast<double>(all.num_kept_wrongly) / static_cast<double>(all.num_kept_wrongly + all.num_kept_rightly);
  EXPECT_GT(exact.removal->Precision(), 2 * share);
  const size_t num_removed = exact.removal->num_removed_rightly + exact.removal->num_removed_wrongly;
  EXPECT_NEAR(exact.num_removed * kNumFrames, static_cast<double>(num_removed), 1e-6);
}

TEST_F(DynamicBench, TextJsonAndFiguresSayTheSame) {
  ASSERT_TRUE(report_->ok());
  const auto json = nlohmann::json::parse(DynamicJson(**report_));
  ASSERT_EQ(json["rows"].size(), 3u);
  const auto& row = json["rows"][2];
  EXPECT_EQ(row["way"], "full-exact");
  EXPECT_EQ(row["runs"].size(), 2u);
  EXPECT_GT(row["stage_ms"]["frame_total"], 0);
  EXPECT_TRUE(json["rows"][0]["removal"]["precision"].is_null());
  EXPECT_TRUE(json["published"]["ate_m"].empty());
  EXPECT_THAT(DynamicText(**report_), testing::HasSubstr("full-exact"));
  std::vector<std::string> names;
  for (const FileToWrite& file : DynamicFiles(**report_, {Room()}, "figures")) {
    EXPECT_FALSE(file.content.empty()) << file.path;
    names.push_back(file.path);
  }
  for (const char* name :
       {"dynamic.txt", "dynamic.json", "dynamic_errors.svg", "dynamic_times.svg", "dynamic_room.svg"}) {
    EXPECT_THAT(names, testing::Contains("figures/" + std::string(name)));
  }
}

TEST_F(DynamicBench, RepeatsToTheBitButForTimes) {
  ASSERT_TRUE(report_->ok());
  DynamicBenchOptions options = *options_;
  options.ways = {dynamic_way::kFullExact};
  options.num_runs = 1;
  const auto again = MeasureDynamic({Room()}, options, {});
  ASSERT_TRUE(again.ok());
  ASSERT_EQ(again->runs.size(), 1u);
  EXPECT_EQ(again->runs[0].evaluation->ate.errors, (*report_)->runs[4].evaluation->ate.errors);
  EXPECT_EQ(again->runs[0].num_removed, (*report_)->runs[4].num_removed);
}

TEST_F(DynamicBench, WithoutTruthOfAnyKindThereIsLessToSay) {
  DynamicBenchOptions options = *options_;
  options.num_runs = 1;
  options.config.max_frames = 3;
  const auto report = MeasureDynamic({{"bare", room_, {}, "", ""}}, options, {});
  ASSERT_TRUE(report.ok()) << report.error().message;
  ASSERT_EQ(report->runs.size(), 2u);  // without boxes no full-exact
  EXPECT_EQ(report->runs[0].num_frames, 3u);
  EXPECT_FALSE(report->runs[0].evaluation.has_value());
  EXPECT_FALSE(report->runs[0].removal.has_value());
  const auto json = nlohmann::json::parse(DynamicJson(*report));
  EXPECT_TRUE(json["rows"][1]["ate_m"]["rmse"].is_null());
  EXPECT_TRUE(json["rows"][1]["removal"]["recall"].is_null());
  for (const FileToWrite& file : DynamicFiles(*report, {{"bare", room_, {}, "", ""}}, "f")) {
    EXPECT_THAT(file.path, testing::Not(testing::HasSubstr("dynamic_bare")));
  }
}

TEST_F(DynamicBench, StopsWhenAskedAndKeepsWhatIsDone) {
  size_t num_runs = 0;
  DynamicBenchHooks hooks;
  hooks.should_stop = [&] { return num_runs == 1; };
  hooks.on_run = [&](const DynamicRun&) { ++num_runs; };
  const auto report = MeasureDynamic({Room()}, *options_, hooks);
  ASSERT_TRUE(report.ok());
  EXPECT_TRUE(report->was_stopped);
  EXPECT_EQ(report->runs.size(), 1u);
}

TEST_F(DynamicBench, WhatFailsLaterLosesNothingThatWasMeasured) {
  class Breaking : public RoomDataset {
   public:
    using RoomDataset::RoomDataset;
    Result<LoadedFrame> Load(size_t i) const override {
      if (i == 1) return BadInput("1.png is of another size");
      return RoomDataset::Load(i);
    }
  };
  const Breaking breaking(3);
  DynamicBenchOptions options = *options_;
  options.ways = {dynamic_way::kOff};
  options.num_runs = 1;
  options.config.max_frames = 2;
  const DynamicSequence bad{"bad", &breaking, {}, "", ""};
  const auto report = MeasureDynamic({Room(), bad}, options, {});
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(report->runs.size(), 1u);
  ASSERT_TRUE(report->error.has_value());
  EXPECT_THAT(report->error->message, testing::HasSubstr("another size"));
  EXPECT_FALSE(MeasureDynamic({bad, Room()}, options, {}).ok()) << "nothing was measured";
}

TEST_F(DynamicBench, NamesWhatIsWrongWithTheBoxes) {
  DynamicBenchOptions options = *options_;
  options.ways = {dynamic_way::kFullExact};
  DynamicSequence room = Room();
  room.people = folder_->Path("nobody.txt");
  const auto report = MeasureDynamic({room}, options, {});
  ASSERT_FALSE(report.ok());
  EXPECT_THAT(report.error().message, testing::HasSubstr("nobody.txt"));
}

TEST_F(DynamicBench, AForeignFolderOfTheMasksNameIsNoFault) {
  DynamicBenchOptions options = *options_;
  options.ways = {dynamic_way::kOff};
  options.num_runs = 1;
  options.config.max_frames = 2;
  DynamicSequence room = Room();
  room.masks = folder_->Path();
  const auto report = MeasureDynamic({room}, options, {});
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_FALSE(report->runs[0].removal.has_value());
}

}  // namespace
}  // namespace yorb
