// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/orb_extractor.h"

#include <gtest/gtest.h>

#include <bit>
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

std::vector<cv::KeyPoint> ToOpenCv(const Features& features) {
  std::vector<cv::KeyPoint> keypoints;
  for (size_t i = 0; i < features.keypoints.size(); ++i) {
    const Keypoint& k = features.keypoints[i];
    keypoints.emplace_back(k.x, k.y, 31.f, DegreesOf(k.angle_rad), k.response, k.octave, static_cast<int>(i));
  }
  return keypoints;
}

/// How many descriptors differ from cv::ORB's at the same keypoints.
int CountDifferent(const cv::Mat& picture, const Features& features) {
  const cv::Ptr<cv::ORB> orb = cv::ORB::create(1000, 1.2f, 8, 19);
  std::vector<cv::KeyPoint> keypoints = ToOpenCv(features);
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

}  // namespace
}  // namespace yorb
