// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/results.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "runs/test_dataset.h"

namespace yorb {
namespace {

FrameRecord RecordAt(Timestamp time, TrackingState state) {
  FrameRecord record;
  record.timestamp = time;
  record.state = state;
  record.num_extracted = 1000;
  record.frame_total_ms = 12.3456;
  return record;
}

TEST(FrameRows, HaveALineForEveryPictureWhateverBecameOfIt) {
  const WallDataset dataset(5);
  const std::vector<Fate> fates{Fate::kPushed, Fate::kSkipped, Fate::kDropped, Fate::kPushed, Fate::kPushed};
  const std::vector<FrameRecord> records{RecordAt(dataset.TimeOf(0), TrackingState::kTracking),
                                         RecordAt(dataset.TimeOf(3), TrackingState::kLost),
                                         RecordAt(dataset.TimeOf(4), TrackingState::kTracking)};
  const auto rows = FrameRows(dataset, fates, records);
  ASSERT_EQ(rows.size(), 5u);
  const std::vector<std::string> states{"tracking", "skipped", "dropped", "lost", "tracking"};
  for (size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].state, states[i]);
    EXPECT_EQ(rows[i].record.timestamp, dataset.TimeOf(i));
  }
}

TEST(FrameRows, EndWhereTheWorkIsStillGoingOn) {
  const WallDataset dataset(4);
  const std::vector<Fate> fates{Fate::kPushed, Fate::kPushed, Fate::kSkipped, Fate::kPushed};
  EXPECT_EQ(FrameRows(dataset, fates, {}).size(), 0u);
  EXPECT_EQ(FrameRows(dataset, fates, {RecordAt(dataset.TimeOf(0), TrackingState::kTracking)}).size(), 1u);
}

TEST(FramesCsv, HasTheColumnsThatScriptsReadAndPlainNumbers) {
  const auto text = FramesCsv({{"tracking", RecordAt({1305031102175304000}, TrackingState::kTracking)}});
  EXPECT_EQ(
      text,
      "timestamp,state,extracted,static,removed,given_back,matched,inliers,keyframe,extract_ms,detect_ms,remove_ms,"
      "track_ms,frame_total_ms\n"
      "1305031102.175304,tracking,1000,0,0,0,0,0,0,0.000,0.000,0.000,0.000,12.346\n");
}

TEST(MetricsJson, IsStrictJsonWithNullWhereNothingCanBeSaid) {
  const std::string text = MetricsJson(RunMetrics());
  const auto json = nlohmann::json::parse(text);
  EXPECT_TRUE(json["coverage"].is_null());
  EXPECT_EQ(json["frames"], 0);
  for (const char* stage : {"extract", "detect", "remove", "track", "frame_total", "local_ba"}) {
    EXPECT_EQ(json["stages"][stage]["count"], 0) << stage;
    EXPECT_TRUE(json["stages"][stage]["median_ms"].is_null()) << stage;
  }
  EXPECT_EQ(text.find("nan"), std::string::npos);
}

TEST(MetricsJson, HasTheNamesAndNumbersThatScriptsRead) {
  RunMetrics metrics;
  metrics.frames = 8;
  metrics.tracked = 6;
  metrics.skipped = 1;
  metrics.stage_ms["extract"] = {1, 2, 3, 4, 100};
  metrics.stage_ms["something_else"] = {5};
  metrics.wall_s = std::nan("");
  const auto json = nlohmann::json::parse(MetricsJson(metrics));
  for (const char* key : {"frames", "tracked", "coverage", "keyframes", "landmarks", "loops", "wall_s", "cpu_s",
                          "peak_rss_mb", "stages", "seed", "mode", "version", "config_digest", "skipped"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  EXPECT_EQ(json["coverage"], 0.75);
  EXPECT_TRUE(json["wall_s"].is_null());
  EXPECT_EQ(json["stages"]["extract"]["median_ms"], 3);
  EXPECT_EQ(json["stages"]["extract"]["max_ms"], 100);
  EXPECT_NEAR(json["stages"]["extract"]["p95_ms"].get<double>(), 80.8, 1e-9);
  EXPECT_EQ(json["stages"]["extract"]["count"], 5);
  EXPECT_EQ(json["stages"]["something_else"]["count"], 1);
}

}  // namespace
}  // namespace yorb
