// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/orb_extractor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <opencv2/features2d.hpp>

#include "features/hamming.h"
#include "features/test_pictures.h"

namespace yorb {
namespace {

/// The degrees that cv::ORB turns into exactly this angle.
float DegreesOf(float angle_rad) {
  const float radians_per_degree = static_cast<float>(CV_PI / 180.f);
  float degrees = angle_rad / radians_per_degree;
  for (const float candidate : {degrees, std::nextafter(degrees, 0.f), std::nextafter(degrees, 400.f)}) {
    if (candidate * radians_per_degree == angle_rad) return candidate;
  }
  ADD_FAILURE() << "no degrees give " << angle_rad;
  return degrees;
}

/// Keypoints at which cv::ORB reads the very pixels of the level that ours were found at: cv::ORB scales bare
/// coordinates, where we keep the borders of the levels together.
std::vector<cv::KeyPoint> ToOpenCv(const Features& features, const cv::Size& size) {
  std::vector<cv::KeyPoint> keypoints;
  for (size_t i = 0; i < features.keypoints.size(); ++i) {
    const Keypoint& k = features.keypoints[i];
    const float scale = static_cast<float>(std::pow(1.2, k.octave));
    const auto place = [&](float full, int full_size) {
      const float level_size = std::rint(static_cast<float>(full_size) / scale);
      return std::rint((full + 0.5f) * level_size / static_cast<float>(full_size) - 0.5f) * scale;
    };
    keypoints.emplace_back(place(k.x, size.width), place(k.y, size.height), 31.f, DegreesOf(k.angle_rad), k.response,
                           k.octave, static_cast<int>(i));
  }
  return keypoints;
}

/// How many descriptors differ from cv::ORB's at the same keypoints.
int CountDifferent(const cv::Mat& picture, const Features& features) {
  const cv::Ptr<cv::ORB> orb = cv::ORB::create(1000, 1.2f, 8, 10);  // 10: no point is left out
  std::vector<cv::KeyPoint> keypoints = ToOpenCv(features, picture.size());
  cv::Mat descriptors;
  orb->compute(picture, keypoints, descriptors);
  EXPECT_EQ(keypoints.size(), features.keypoints.size());
  int different = 0;
  for (int row = 0; row < descriptors.rows; ++row) {
    const size_t ours = static_cast<size_t>(keypoints[static_cast<size_t>(row)].class_id);
    different += std::memcmp(descriptors.ptr(row), features.descriptors[ours].data(), 32) != 0;
  }
  return different;
}

TEST(OrbExtractor, DescriptorsAreOpenCvsToTheBit) {
  FeatureOptions options;
  options.wanted = 3000;
  OrbExtractor extractor(options);
  for (const cv::Mat& picture :
       {RectanglesPicture(640, 480, 1), RectanglesPicture(517, 389, 2, 8), NoisePicture(640, 480, 3)}) {
    const Features features = extractor.Extract(picture);
    EXPECT_GT(features.keypoints.size(), 1000u);
    EXPECT_EQ(CountDifferent(picture, features), 0) << "of " << features.keypoints.size();
  }
}

TEST(OrbExtractor, AnglesAreOpenCvs) {
  const cv::Mat picture = RectanglesPicture(640, 480, 4);
  FeatureOptions options;
  options.subpixel = false;
  const Features features = OrbExtractor(options).Extract(picture);
  std::vector<cv::KeyPoint> theirs;
  cv::ORB::create(3000, 1.2f, 1, 31, 0, 2, cv::ORB::FAST_SCORE, 31, 5)->detect(picture, theirs);
  int compared = 0;
  for (const Keypoint& k : features.keypoints) {
    for (const cv::KeyPoint& t : theirs) {
      if (k.octave != 0 || t.pt.x != k.x || t.pt.y != k.y) continue;
      EXPECT_EQ(k.angle_rad, t.angle * static_cast<float>(CV_PI / 180.f));
      ++compared;
    }
  }
  EXPECT_GT(compared, 50);
}

FeatureOptions Options(const std::string& detector, const std::string& distribution) {
  FeatureOptions options;
  options.detector = detector;
  options.distribution = distribution;
  return options;
}

void ExpectEqual(const Features& a, const Features& b) {
  ASSERT_EQ(a.keypoints.size(), b.keypoints.size());
  for (size_t i = 0; i < a.keypoints.size(); ++i) {
    EXPECT_EQ(std::memcmp(&a.keypoints[i], &b.keypoints[i], sizeof(Keypoint)), 0);
    EXPECT_EQ(a.descriptors[i], b.descriptors[i]);
  }
}

class OrbExtractorWays : public testing::TestWithParam<FeatureOptions> {};

TEST_P(OrbExtractorWays, GivesWhatIsWantedOnAllLevels) {
  FeatureOptions options = GetParam();
  for (const double over : {1.0, 1.5}) {
    options.over_extraction = over;
    const Features features = OrbExtractor(options).Extract(RectanglesPicture(640, 480, 5));
    ASSERT_EQ(features.keypoints.size(), features.descriptors.size());
    EXPECT_GT(static_cast<double>(features.keypoints.size()), 950 * over);
    EXPECT_LE(static_cast<double>(features.keypoints.size()), 1000 * over);
    std::vector<int> counts(8);
    for (const Keypoint& k : features.keypoints) ++counts[static_cast<size_t>(k.octave)];
    for (size_t level = 1; level < 8; ++level) {
      EXPECT_NEAR(counts[level], counts[level - 1] / 1.2, 0.1 * counts[level - 1]) << level;
    }
  }
}

TEST_P(OrbExtractorWays, RefusedPlacesLeaveTheirShareToTheOthers) {
  const cv::Mat picture = RectanglesPicture(640, 480, 7);
  const PointFilter is_right = [](const Keypoint& point) { return point.x > 400; };
  const Features features = OrbExtractor(GetParam()).Extract(picture, is_right);
  const Features all = OrbExtractor(GetParam()).Extract(picture);
  const auto num_right = std::count_if(all.keypoints.begin(), all.keypoints.end(), is_right);
  EXPECT_GT(features.keypoints.size(), static_cast<size_t>(num_right));
  for (const Keypoint& k : features.keypoints) EXPECT_GT(k.x, 399);  // refined by up to half a pixel of a level
}

TEST_P(OrbExtractorWays, ASecondLookIsAsAFirstOne) {
  const PointFilter is_right = [](const Keypoint&point) { return point.x > 400; },
                    is_left = [](const Keypoint&point) { return point.x < 90; };
  OrbExtractor used(GetParam());
  for (const cv::Size size : {cv::Size(640, 480), cv::Size(100, 90), cv::Size(640, 480)}) {
    const cv::Mat picture = RectanglesPicture(size.width, size.height, 7);
    used.Extract(picture, is_left);  // some levels give nothing
    ExpectEqual(used.ExtractAgain(is_right), OrbExtractor(GetParam()).Extract(picture, is_right));
    ExpectEqual(used.ExtractAgain({}), OrbExtractor(GetParam()).Extract(picture));
  }
}

TEST_P(OrbExtractorWays, KeepsAwayFromTheBorder) {
  const Features features = OrbExtractor(GetParam()).Extract(RectanglesPicture(320, 240, 6));
  for (const Keypoint& k : features.keypoints) {
    EXPECT_GE(std::min(k.x, k.y), 18.5);
    EXPECT_LE(k.x, 320 - 19);
    EXPECT_LE(k.y, 240 - 19);
    EXPECT_GT(k.response, 0);
  }
}

TEST_P(OrbExtractorWays, TheSamePictureGivesTheSameFeatures) {
  const cv::Mat picture = RectanglesPicture(640, 480, 7);
  OrbExtractor used(GetParam()), fresh(GetParam());
  used.Extract(RectanglesPicture(800, 500, 8));
  used.Extract(RectanglesPicture(100, 90, 8));
  const Features first = used.Extract(picture);
  ExpectEqual(first, fresh.Extract(picture));
  OrbExtractor moved(std::move(used));
  ExpectEqual(first, moved.Extract(picture));
}

TEST_P(OrbExtractorWays, OddPicturesAreNoTrouble) {
  OrbExtractor extractor(GetParam());
  for (const cv::Size size :
       {cv::Size(1, 1), cv::Size(38, 500), cv::Size(39, 39), cv::Size(500, 41), cv::Size(47, 63)}) {
    extractor.Extract(NoisePicture(size.width, size.height, 9));
  }
  EXPECT_TRUE(extractor.Extract(cv::Mat()).keypoints.empty());
  EXPECT_TRUE(extractor.Extract(cv::Mat(480, 640, CV_8UC1, cv::Scalar(128))).keypoints.empty()) << "nothing to see";
}

TEST_P(OrbExtractorWays, PartOfALargerPictureIsReadAsIfAlone) {
  const cv::Mat large = RectanglesPicture(500, 400, 10);
  const cv::Mat part = large(cv::Rect(60, 40, 320, 240));
  ExpectEqual(OrbExtractor(GetParam()).Extract(part), OrbExtractor(GetParam()).Extract(part.clone()));
}

INSTANTIATE_TEST_SUITE_P(All, OrbExtractorWays,
                         testing::Values(Options("fixed", "quadtree"), Options("fixed", "improved"),
                                         Options("adaptive", "quadtree"), Options("adaptive", "improved")),
                         [](const auto& way) { return way.param.detector + "_" + way.param.distribution; });

}  // namespace
}  // namespace yorb
