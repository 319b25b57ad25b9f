// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/features.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/random.h"
#include "experiments/features_figures.h"
#include "experiments/features_light.h"
#include "experiments/features_spread.h"
#include "features/hamming.h"
#include "features/original_extractor.h"
#include "features/test_pictures.h"
#include "pictures/png.h"

namespace yorb {
namespace {

/// A folder with two pictures that is gone afterwards.
class TwoPictures : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("yorb_features_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
    for (const int seed : {1, 2}) {
      std::ofstream(folder_ / (std::to_string(seed) + ".png"), std::ios::binary)
          << *EncodePng(RectanglesPicture(320, 240, static_cast<uint64_t>(seed)));
    }
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_;
};

Descriptor RandomDescriptor(Random& random) { return {random.Next(), random.Next(), random.Next(), random.Next()}; }

TEST(FeaturesLight, ChangesWhatItsNameSays) {
  cv::Mat grey(1, 4, CV_8UC1);
  const uint8_t levels[] = {0, 100, 101, 250};
  std::copy(std::begin(levels), std::end(levels), grey.data);
  const auto relit = [&](size_t i) {
    const cv::Mat picture = Relit(grey, LightChanges()[i]);
    return std::vector<int>(picture.begin<uint8_t>(), picture.end<uint8_t>());
  };
  EXPECT_EQ(LightChanges()[0].name, "x0.6");
  EXPECT_EQ(relit(0), (std::vector<int>{0, 60, 61, 150}));
  EXPECT_EQ(LightChanges()[1].name, "x1.4");
  EXPECT_EQ(relit(1), (std::vector<int>{0, 140, 141, 255}));
  EXPECT_EQ(relit(2), (std::vector<int>{0, 60, 61, 210}));
  EXPECT_EQ(relit(3), (std::vector<int>{40, 140, 141, 255}));
  EXPECT_EQ(relit(6), (std::vector<int>{0, 30, 101, 250})) << "the right half stays";
}

TEST(FeaturesSpread, DispersionIsTheDeviationOverNineCells) {
  std::vector<Keypoint> points(9);
  for (Keypoint& point : points) point.x = 5, point.y = 5;
  // Nine points in one cell, none in eight: mean 1, squares 64 + 8.
  EXPECT_NEAR(Dispersion(points, {90, 90}), std::sqrt(72.0 / 9), 1e-12);
  for (size_t i = 0; i < 9; ++i) points[i].x = 15 + 30 * float(i % 3), points[i].y = 15 + 30 * float(i / 3);
  EXPECT_EQ(Dispersion(points, {90, 90}), 0);
}

TEST(FeaturesMatching, MutualNearestEqualsTheSlowWay) {
  Random random(3);
  std::vector<Descriptor> a, b;
  for (int i = 0; i < 60; ++i) a.push_back(RandomDescriptor(random));
  for (int i = 0; i < 50; ++i) b.push_back(i % 2 == 0 ? a[static_cast<size_t>(i)] : RandomDescriptor(random));
  const auto nearest = [](const Descriptor& to, const std::vector<Descriptor>& rows) {
    size_t best = 0;
    for (size_t i = 1; i < rows.size(); ++i) {
      if (HammingDistance(to, rows[i]) < HammingDistance(to, rows[best])) best = i;
    }
    return best;
  };
  std::vector<std::pair<size_t, size_t>> slow;
  for (size_t i = 0; i < a.size(); ++i) {
    const size_t j = nearest(a[i], b);
    if (nearest(b[j], a) == i) slow.emplace_back(i, j);
  }
  EXPECT_GE(slow.size(), 25u);
  EXPECT_EQ(MutualNearest(a, b), slow);
  EXPECT_TRUE(MutualNearest(a, {}).empty());
  EXPECT_TRUE(MutualNearest({}, b).empty());
}

TEST(FeaturesMatching, JudgesByDepthAndMotion) {
  Rig rig;
  rig.camera.fx = rig.camera.fy = 100, rig.camera.cx = rig.camera.cy = 50;
  DepthImage depth;
  depth.pixels = cv::Mat(100, 100, CV_32FC1, cv::Scalar(2.f));
  depth.pixels.at<float>(70, 70) = 0;
  Features a, b;
  a.keypoints = {{50, 50, 0, 0, 0}, {70, 70, 0, 0, 0}, {30, 40, 0, 0, 0}};
  b.keypoints = {{60, 50, 0, 0, 0}, {80, 70, 0, 0, 0}, {30, 40, 0, 0, 0}};
  // 0.2 m to the left at 2 m: everything moves 10 px to the right.
  const Rigid3 b_from_a(Eigen::Quaterniond::Identity(), Eigen::Vector3d(0.2, 0, 0));
  const std::vector<std::pair<size_t, size_t>> matches = {{0, 0}, {1, 1}, {2, 2}};
  const MatchErrors errors = ErrorsByMotion(a, b, matches, rig, depth, b_from_a);
  EXPECT_NEAR(errors[0], 0, 1e-4);
  EXPECT_TRUE(std::isnan(errors[1])) << "no depth, no verdict";
  EXPECT_NEAR(errors[2], 10, 1e-4);
  EXPECT_EQ(Verdicts(a, matches, errors), (std::vector<int>{1, -1, 0}));
}

TEST(FeaturesPictures, TruePoseLiesBetweenItsNeighbours) {
  const Trajectory truth = {{{0}, Rigid3()},
                            {{50'000'000}, {Eigen::Quaterniond::Identity(), Eigen::Vector3d(1, 0, 0)}},
                            {{900'000'000}, {Eigen::Quaterniond::Identity(), Eigen::Vector3d(2, 0, 0)}}};
  EXPECT_NEAR(TruePose(truth, {10'000'000})->translation.x(), 0.2, 1e-9);
  EXPECT_NEAR(TruePose(truth, {50'000'000})->translation.x(), 1, 1e-9);
  EXPECT_FALSE(TruePose(truth, {100'000'000})) << "a hole";
  EXPECT_FALSE(TruePose(truth, {-1}));
  EXPECT_FALSE(TruePose(truth, {1'000'000'000}));
}

TEST(FeaturesPictures, SpreadTakesEachOnceAndAllWhereAsked) {
  EXPECT_EQ(Spread(5, 0), (std::vector<size_t>{0, 1, 2, 3, 4}));
  EXPECT_EQ(Spread(10, 5), (std::vector<size_t>{0, 2, 4, 6, 8}));
  EXPECT_EQ(Spread(3, 10).size(), 3u);
}

TEST(FeaturesFrontEnds, OriginalPathFindsAsManyPointsAsItsFastTwin) {
  const cv::Mat picture = RectanglesPicture(640, 480, 5);
  FeatureOptions fixed;
  fixed.detector = "fixed", fixed.distribution = "quadtree";
  fixed.over_extraction = 1;
  const size_t fast = OrbExtractor(fixed).Extract(picture).keypoints.size();
  const Features path = OriginalExtractor({}).Extract(picture);
  EXPECT_EQ(path.keypoints.size(), path.descriptors.size());
  EXPECT_NEAR(static_cast<double>(path.keypoints.size()), static_cast<double>(fast), 0.02 * static_cast<double>(fast));
}

TEST_F(TwoPictures, AreMeasuredAndDrawn) {
  const auto set = OpenPictureSet(folder_.string() + "/", "");
  ASSERT_TRUE(set.ok()) << set.error().message;
  EXPECT_EQ(set->name, folder_.filename().string());
  FeaturesBenchOptions options;
  options.features.wanted = 300;
  const auto report = MeasureFeatures(*set, options);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(report->pictures, 2u);
  EXPECT_THAT(FeaturesText({*report}), testing::HasSubstr("Table 5"));
  const auto json = nlohmann::json::parse(FeaturesJson({*report, *report}));
  EXPECT_EQ(json["brightness"][0]["change"], "x0.6");
  EXPECT_LT(json["brightness"][0]["original"], -0.1) << "a fixed threshold finds less in the dark";
  EXPECT_LT(std::abs(json["brightness"][0]["improved"].get<double>()), 0.1);
  EXPECT_GT(json["time"]["cv_orb_ms"], 0);
  EXPECT_GT(json["time"]["original_ms"], 0);
  EXPECT_GT(json["dispersion"]["improved"], 0);
  ASSERT_EQ(json["matching"].size(), 2u);
  EXPECT_GT(json["matching"][0]["improved"]["matches"], 50);
  EXPECT_LE(json["matching"][0]["improved"]["precision"], 1);
  const auto figures = FeatureFigures(*set, options.features, "out");
  ASSERT_TRUE(figures.ok()) << figures.error().message;
  EXPECT_EQ(figures->size(), 5u);
  EXPECT_EQ(figures->front().content.substr(1, 3), "PNG");
}

TEST(FeaturesPictures, RefusesWhatIsNotThere) {
  const auto set = OpenPictureSet("/no/such/place", "");
  ASSERT_FALSE(set.ok());
  EXPECT_THAT(set.error().message, testing::HasSubstr("/no/such/place"));
}

}  // namespace
}  // namespace yorb
