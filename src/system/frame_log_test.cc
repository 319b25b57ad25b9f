// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "system/frame_log.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "map/test_map.h"

namespace yorb {
namespace {

constexpr uint32_t kFrames = 40, kFirst = 10, kRepeated = 30;

/// A camera that goes straight on and trembles; one of its pictures was handed over twice.
std::vector<FrameRecord> TremblingWalk(KeyframeId reference) {
  Random random(2);
  std::vector<FrameRecord> records;
  for (uint32_t i = 0; i < kFrames; ++i) {
    FrameRecord record;
    record.id = FrameId(kFirst + i);
    record.timestamp = {int64_t{33'000'000} * i};
    record.state = TrackingState::kTracking;
    record.reference = reference;
    record.cam_from_reference.translation = {-0.01 * i, 0.004 * random.Gaussian(), 0};
    record.information = 1e6 * Matrix6d::Identity();
    if (i == kRepeated) {
      record.is_repeated = true;
      record.cam_from_reference = records.back().cam_from_reference;
    }
    records.push_back(record);
  }
  return records;
}

double OffTheLine(const Trajectory& trajectory) {
  double sum = 0;
  for (const StampedPose& pose : trajectory) sum += std::abs(pose.world_from_cam.translation.y());
  return sum;
}

TEST(FrameLog, GivesTheLikeliestPathOrThePosesAsTheyWere) {
  Map map;
  const KeyframeId root = AddSubmap(map, SyntheticWorld(1), {Rigid3::Identity()}).front();
  FrameLog log;
  const auto records = TremblingWalk(root);
  for (const FrameRecord& record : records) log.Add(record);
  const Trajectory smooth = log.Report(map, KeyframeId(0), true).trajectory();
  const Trajectory as_measured = log.Report(map, KeyframeId(0), false).trajectory();
  ASSERT_EQ(smooth.size(), kFrames);
  ASSERT_EQ(as_measured.size(), kFrames);
  for (size_t i = 0; i < records.size(); ++i) {
    EXPECT_EQ(smooth[i].timestamp, records[i].timestamp);
    EXPECT_EQ(as_measured[i].world_from_cam.translation, records[i].cam_from_reference.OriginInSource());
  }
  EXPECT_LT(OffTheLine(smooth), 0.6 * OffTheLine(as_measured));
}

TEST(FrameLog, OnePictureHasOnePose) {
  Map map;
  FrameLog log;
  for (const FrameRecord& record : TremblingWalk(AddSubmap(map, SyntheticWorld(1), {Rigid3::Identity()}).front())) {
    log.Add(record);
  }
  for (const bool smooth : {false, true}) {
    const Trajectory path = log.Report(map, KeyframeId(0), smooth).trajectory();
    EXPECT_EQ(path[kRepeated].world_from_cam.translation, path[kRepeated - 1].world_from_cam.translation);
    EXPECT_NE(path[kRepeated].world_from_cam.translation, path[kRepeated + 1].world_from_cam.translation);
  }
}

}  // namespace
}  // namespace yorb
