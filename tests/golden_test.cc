// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Real data: the first five seconds of TUM's freiburg1_xyz, where they are at hand.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <opencv2/core/utility.hpp>

#include "datasets/open_dataset.h"
#include "evaluation/ate.h"
#include "evaluation/trajectory_io.h"
#include "runs/feed.h"
#include "system/slam.h"

namespace yorb {
namespace {

constexpr int kFrames = 150;

/// The folder of the recording; empty where there is none.
std::string Recording() {
  const char* given = std::getenv("YORB_DATA");
  const std::string data = given != nullptr ? given : std::string(YORB_SOURCE_DIR) + "/../shared/data";
  return std::filesystem::exists(data + "/fr1_xyz/rgb.txt") ? data + "/fr1_xyz" : "";
}

class Golden : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (Recording().empty()) GTEST_SKIP() << "skipped: no data";
  }
};
INSTANTIATE_TEST_SUITE_P(Modes, Golden, testing::Values("inline", "offline"));

TEST_P(Golden, TheDeskIsTrackedThroughoutAndTrueToACentimetre) {
  cv::setNumThreads(1);
  Config config;
  config.mode = GetParam();
  config.max_frames = kFrames;
  const auto dataset = OpenDataset(Recording(), "tum_fr1");
  ASSERT_TRUE(dataset.ok()) << dataset.error().message;
  auto slam = Slam::Create(config, (*dataset)->rig());
  ASSERT_TRUE(slam.ok()) << slam.error().message;
  const FeedLog fed = Feed(**dataset, config, **slam, {});
  ASSERT_FALSE(fed.error) << fed.error->message;
  const SlamReport report = (*slam)->Report();
  EXPECT_EQ(report.trajectory().size(), size_t{kFrames});
  const auto truth = ReadTrajectoryFile(Recording() + "/groundtruth.txt");
  ASSERT_TRUE(truth.ok()) << truth.error().message;
  const auto pairs = AssociateStamps(StampsOf(truth->poses), StampsOf(report.trajectory()), 20000000);
  ASSERT_GE(pairs.size(), size_t{kFrames * 9 / 10});
  EXPECT_LT(ComputeAbsoluteError(truth->poses, report.trajectory(), pairs, EvalAlign::kSe3).summary.rmse, 0.015);
}

}  // namespace
}  // namespace yorb
