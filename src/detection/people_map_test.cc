// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/people_map.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace yorb {
namespace {

constexpr int kCellPx = 8;

/// A map in which one rectangle of the input, px, surely shows somebody.
struct Somebody {
  std::vector<float> logits;
  TensorView view;

  Somebody(const cv::Size& input, const cv::Rect& where) {
    const int rows = input.height / kCellPx, columns = input.width / kCellPx;
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const cv::Point middle(column * kCellPx + kCellPx / 2, row * kCellPx + kCellPx / 2);
        logits.push_back(where.contains(middle) ? 20.f : -20.f);
      }
    }
    view = {logits.data(), {1, 1, rows, columns}, DenseStrides({1, 1, rows, columns})};
  }
};

/// The grid's value at a place of the picture, px.
int At(const cv::Mat& people, const cv::Size& picture, double x, double y) {
  return people.at<uint8_t>(static_cast<int>(y * people.rows / picture.height),
                            static_cast<int>(x * people.cols / picture.width));
}

TEST(PeopleMap, CoversThePictureAloneWhateverItsShape) {
  const cv::Size input(320, 256);
  for (const cv::Size picture : {cv::Size(640, 480), cv::Size(540, 360), cv::Size(300, 900), cv::Size(320, 256)}) {
    const Letterbox fit = FitLetterbox(picture, input);
    // The left third of the scaled picture.
    const Somebody somebody(input, {fit.left, fit.top, fit.scaled.width / 3, fit.scaled.height});
    const cv::Mat people = PeopleIn(somebody.view, fit);
    ASSERT_EQ(people.type(), CV_8UC1);
    EXPECT_NEAR(people.cols, fit.scaled.width / kCellPx, 1);
    EXPECT_NEAR(people.rows, fit.scaled.height / kCellPx, 1);
    for (const double y : {0.1, 0.5, 0.9}) {
      EXPECT_GT(At(people, picture, 0.1 * picture.width, y * picture.height), 250) << picture;
      EXPECT_LT(At(people, picture, 0.6 * picture.width, y * picture.height), 5) << picture;
      EXPECT_LT(At(people, picture, 0.99 * picture.width, y * picture.height), 5) << picture;
    }
  }
}

TEST(PeopleMap, HalfACellIsHalfSure) {
  const cv::Size size(320, 256);
  const Letterbox fit = FitLetterbox(size, size);
  Somebody nobody(size, {});
  nobody.logits.assign(nobody.logits.size(), 0.f);
  EXPECT_EQ(cv::countNonZero(PeopleIn(nobody.view, fit) != 128), 0);
}

TEST(PeopleMap, WhatIsNoNumberIsNobody) {
  const cv::Size size(320, 256);
  Somebody somebody(size, {0, 0, 320, 256});
  somebody.logits[0] = std::numeric_limits<float>::quiet_NaN();
  somebody.logits[1] = -std::numeric_limits<float>::infinity();
  const cv::Mat people = PeopleIn(somebody.view, FitLetterbox(size, size));
  EXPECT_EQ(people.at<uint8_t>(0, 0), 0);
  EXPECT_EQ(people.at<uint8_t>(0, 1), 0);
  EXPECT_EQ(people.at<uint8_t>(0, 2), 255);
}

TEST(PeopleMap, IsOneNumberACell) {
  const auto is_map = [](std::vector<int64_t> dims) { return IsPeopleMap({nullptr, std::move(dims), {}}); };
  EXPECT_TRUE(is_map({1, 1, 32, 40}));
  EXPECT_FALSE(is_map({1, 2, 32, 40}));
  EXPECT_FALSE(is_map({2, 1, 32, 40}));
  EXPECT_FALSE(is_map({1, 1, 0, 40}));
  EXPECT_FALSE(is_map({1, 32, 40}));
}

}  // namespace
}  // namespace yorb
