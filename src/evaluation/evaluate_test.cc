// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/evaluate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "evaluation/test_trajectories.h"

namespace yorb {
namespace {

using ::testing::HasSubstr;

ReadTrajectory Named(const std::string& name, Trajectory poses) {
  ReadTrajectory read;
  read.path = name;
  read.poses = std::move(poses);
  return read;
}

struct Published {
  const char *truth, *estimate;
  size_t pairs;
  double ate, rpe_m, rpe_deg;
};

std::string DataFolder() {
  const char* const given = std::getenv("YORB_DATA");
  return given != nullptr ? given : std::string(YORB_SOURCE_DIR) + "/../shared/data";
}

TEST(Evaluate, EqualsTumsScriptsOnPublishedTrajectories) {
  const std::string data = DataFolder();
  if (!std::filesystem::exists(data + "/trajectories")) GTEST_SKIP() << "skipped: no data";
  const Published rows[] = {
      {"fr1_xyz/groundtruth.txt", "trajectories/freiburg1_xyz-rgbdslam.txt", 786, .013473, .021217, .934480},
      {"trajectories/fr2_desk_groundtruth.txt", "trajectories/fr2_desk_ORB.txt", 2223, .008144, .007161, .455005},
      {"trajectories/fr3_walking_xyz_groundtruth.txt", "trajectories/fr3_walking_xyz_estimate.txt", 826, .017920,
       .023597, .625590}};
  for (const Published& row : rows) {
    const auto truth = ReadTrajectoryFile(data + "/" + row.truth),
               estimate = ReadTrajectoryFile(data + "/" + row.estimate);
    ASSERT_TRUE(truth && estimate);
    const auto evaluation = Evaluate(*truth, *estimate, {});
    ASSERT_TRUE(evaluation) << evaluation.error().message;
    EXPECT_EQ(evaluation->pairs.size(), row.pairs) << row.estimate;
    EXPECT_NEAR(evaluation->ate.summary.rmse, row.ate, 5.1e-7) << row.estimate;
    EXPECT_NEAR(evaluation->rpe.translation_summary.rmse, row.rpe_m, 5.1e-7) << row.estimate;
    EXPECT_NEAR(evaluation->rpe.rotation_summary.rmse, row.rpe_deg, 5.1e-7) << row.estimate;
  }
}

TEST(Evaluate, AnotherWorldMakesNoError) {
  const Trajectory truth = SmoothWalk(500, 10), walk = SmoothWalk(150, 30);
  EvalOptions options;
  const auto rigid = Evaluate(Named("truth", truth), Named("found", Disturbed(walk, 0, SomeMotion(1), 1)), options);
  ASSERT_TRUE(rigid);
  EXPECT_EQ(rigid->pairs.size(), walk.size());
  EXPECT_LT(rigid->ate.summary.max, 1e-9);
  EXPECT_FALSE(rigid->coverage.has_value());
  options.align = EvalAlign::kSim3;
  const auto scaled = Evaluate(Named("truth", truth), Named("found", Disturbed(walk, 0, SomeMotion(0.2), 1)), options);
  ASSERT_TRUE(scaled);
  EXPECT_LT(scaled->ate.summary.max, 1e-9);
  EXPECT_LT(scaled->rpe.translation_summary.max, 1e-9);
  EXPECT_NEAR(scaled->ate.reference_from_estimate.scale, 5, 1e-9);
}

TEST(Evaluate, AlignmentHidesNoScaleAndNoneHidesNothing) {
  const Trajectory truth = SmoothWalk(500, 10);
  const ReadTrajectory found = Named("found", Disturbed(truth, 0, SomeMotion(0.2), 1));
  EvalOptions options;
  EXPECT_GT(Evaluate(Named("truth", truth), found, options)->ate.summary.rmse, 0.1);
  options.align = EvalAlign::kNone;
  EXPECT_GT(Evaluate(Named("truth", truth), found, options)->ate.summary.rmse, 1.0);
  EXPECT_EQ(Evaluate(Named("truth", truth), Named("same", truth), options)->ate.summary.max, 0.0);
}

TEST(Evaluate, MillimetresAreToldOfAndNotScaled) {
  const Trajectory truth = SmoothWalk(500, 10);
  const ReadTrajectory metres = Named("metres.txt", truth);
  const ReadTrajectory thousand = Named("mm.txt", Disturbed(truth, 0, SomeMotion(1000), 1));
  EvalOptions options;
  const auto found = Evaluate(metres, thousand, options);
  ASSERT_EQ(found->warnings.size(), 1u);
  EXPECT_THAT(found->warnings[0], HasSubstr("mm.txt extends about 1000 times as far as metres.txt"));
  EXPECT_GT(found->ate.summary.rmse, 100);
  const auto other = Evaluate(thousand, metres, options);
  ASSERT_EQ(other->warnings.size(), 1u);
  EXPECT_THAT(other->warnings[0], HasSubstr("mm.txt extends"));
  EXPECT_TRUE(Evaluate(metres, Named("five", Disturbed(truth, 0, SomeMotion(5), 1)), options)->warnings.empty());
  EXPECT_TRUE(Evaluate(metres, Named("stuck", Disturbed(truth, 0, SomeMotion(0.001), 1)), options)->warnings.empty());
  options.align = EvalAlign::kSim3;
  EXPECT_TRUE(Evaluate(metres, thousand, options)->warnings.empty());
}

TEST(Evaluate, TheOffsetMovesTheEstimate) {
  const Trajectory truth = SmoothWalk(500, 10);
  Trajectory late = truth;
  for (StampedPose& pose : late) pose.timestamp.ns += 7000000000;
  EvalOptions options;
  const auto refused = Evaluate(Named("truth.txt", truth), Named("late.txt", late), options);
  ASSERT_FALSE(refused);
  for (const char* word : {"truth.txt", "late.txt", "1300000007.000000", "1300000004.990000", "--time-offset"}) {
    EXPECT_THAT(refused.error().message, HasSubstr(word));
  }
  options.time_offset = -7;
  const auto moved = Evaluate(Named("truth.txt", truth), Named("late.txt", late), options);
  ASSERT_TRUE(moved) << moved.error().message;
  EXPECT_EQ(moved->pairs.size(), truth.size());
  EXPECT_LT(moved->rpe.translation_summary.max, 1e-9);
  EXPECT_EQ(moved->aligned[0].timestamp, truth[0].timestamp);
}

TEST(Evaluate, RowsWithoutStampsAreNeitherShiftedNorCutInSilence) {
  const Trajectory truth = SmoothWalk(60, 1000);
  ReadTrajectory reference = Named("truth.txt", truth), whole = Named("whole.txt", truth),
                 cut = Named("cut.txt", Trajectory(truth.begin(), truth.begin() + 50));
  reference.has_stamps = whole.has_stamps = cut.has_stamps = false;
  EvalOptions options;
  options.rpe_unit = RpeUnit::kFrames;
  EXPECT_TRUE(Evaluate(reference, whole, options)->warnings.empty());
  const auto unlike = Evaluate(reference, cut, options);
  ASSERT_TRUE(unlike) << unlike.error().message;
  ASSERT_EQ(unlike->warnings.size(), 1u);
  for (const char* word : {"cut.txt has 50 rows", "truth.txt 60"}) EXPECT_THAT(unlike->warnings[0], HasSubstr(word));
  EXPECT_EQ(Evaluate(cut, reference, options)->warnings.size(), 1u) << "nor where the truth is the shorter one";
  options.time_offset = 1;
  const auto shifted = Evaluate(reference, whole, options);
  ASSERT_FALSE(shifted);
  EXPECT_THAT(shifted.error().message, HasSubstr("--time-offset 1: the rows of whole.txt have no time stamps"));
  whole.has_stamps = reference.has_stamps = true;
  EXPECT_TRUE(Evaluate(reference, whole, options)) << "stamps may be shifted";
}

TEST(Evaluate, FewerThanThreePairsAreRefused) {
  const Trajectory truth = SmoothWalk(500, 10);
  for (size_t count = 1; count < 5; ++count) {
    const Trajectory few(truth.begin(), truth.begin() + static_cast<std::ptrdiff_t>(count));
    EXPECT_EQ(Evaluate(Named("truth", truth), Named("few", few), {}).ok(), count >= 3);
  }
}

TEST(Evaluate, ALineAndAPlaceGiveTheResidualAndAWarning) {
  Trajectory line = SmoothWalk(100, 30), still = line;
  for (size_t i = 0; i < line.size(); ++i) {
    line[i].world_from_cam.translation = Eigen::Vector3d(0.01 * static_cast<double>(i), 0, 0);
    still[i].world_from_cam.translation = Eigen::Vector3d(1, 2, 3);
  }
  for (const EvalAlign align : {EvalAlign::kSe3, EvalAlign::kSim3}) {
    EvalOptions options;
    options.align = align;
    const auto same = Evaluate(Named("line", line), Named("line", line), options);
    ASSERT_TRUE(same);
    EXPECT_LT(same->ate.summary.max, 1e-9);
    ASSERT_EQ(same->warnings.size(), 1u);
    EXPECT_THAT(same->warnings[0], HasSubstr("on a line"));
    const auto stuck = Evaluate(Named("line", line), Named("still", still), options);
    ASSERT_TRUE(stuck);
    EXPECT_NEAR(stuck->ate.summary.rmse, 0.288661, 1e-6) << "the spread of the truth";
    EXPECT_THAT(stuck->warnings.at(0), HasSubstr("one place"));
  }
}

TEST(Evaluate, OptionsOutOfRangeAreRefused) {
  const double nan = std::nan("");
  for (const double bad : {0.0, -1.0, nan, HUGE_VAL}) {
    EvalOptions delta, difference;
    delta.rpe_delta = bad;
    difference.max_difference = bad;
    EXPECT_FALSE(Validate(delta)) << bad;
    EXPECT_FALSE(Validate(difference)) << bad;
  }
  for (const double bad : {nan, HUGE_VAL, 1e10}) {
    EvalOptions options;
    options.time_offset = bad;
    EXPECT_FALSE(Validate(options)) << bad;
  }
  EvalOptions options;
  EXPECT_TRUE(Validate(options));
  options.num_frames = 0;
  EXPECT_FALSE(Validate(options));
}

TEST(Coverage, CountsPicturesWithAPoseAndNeverMoreThanAll) {
  const Trajectory frames = SmoothWalk(240, 33);
  Trajectory lost(frames.begin(), frames.begin() + 120), twice;
  for (const StampedPose& pose : frames) {
    twice.push_back(pose);
    twice.push_back({Timestamp{pose.timestamp.ns + 11000000}, pose.world_from_cam});
  }
  EvalOptions seen;
  seen.pictures = StampsOf(frames);
  const auto coverage = [&](const Trajectory& estimate) {
    return Evaluate(Named("truth", frames), Named("found", estimate), seen)->coverage;
  };
  EXPECT_EQ(coverage(frames), 1.0);
  EXPECT_EQ(coverage(lost), 0.5);
  EXPECT_EQ(coverage(twice), 1.0);
  seen.pictures->clear();
  EXPECT_EQ(coverage(frames), 0.0);
  EvalOptions options;
  options.num_frames = 480;
  EXPECT_EQ(Evaluate(Named("truth", frames), Named("lost", lost), options)->coverage, 0.25);
  options.num_frames = 100;
  const auto too_many = Evaluate(Named("truth", frames), Named("lost", lost), options);
  EXPECT_EQ(too_many->coverage, 1.0);
  EXPECT_EQ(too_many->warnings.size(), 1u);
}

}  // namespace
}  // namespace yorb
