// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic/paint.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace yorb {

Paint Hsv(double hue, double saturation, double value) {
  const auto channel = [&](double shift) {
    const double k = std::fmod(shift + hue / 60, 6);
    return 255 * value * (1 - saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0));
  };
  return {channel(1), channel(3), channel(5)};
}

cv::Mat CloudNoise(cv::Size size, cv::Size cell, Random& random) {
  constexpr int kPad = 2;
  cv::Mat grid(std::max(1, size.height / cell.height), std::max(1, size.width / cell.width), CV_32FC1);
  for (int y = 0; y < grid.rows; ++y) {
    for (int x = 0; x < grid.cols; ++x) grid.at<float>(y, x) = static_cast<float>(random.Gaussian() * 1.25);
  }
  cv::Mat padded, large;
  cv::copyMakeBorder(grid, padded, kPad, kPad, kPad, kPad, cv::BORDER_WRAP);
  const int step_x = size.width / grid.cols, step_y = size.height / grid.rows;
  cv::resize(padded, large, {padded.cols * step_x, padded.rows * step_y}, 0, 0, cv::INTER_CUBIC);
  return large({kPad * step_x, kPad * step_y, size.width, size.height}).clone();
}

void Speckle(cv::Mat& picture, double deviation, Random& random) {
  for (int y = 0; y < picture.rows; ++y) {
    auto* row = picture.ptr<cv::Vec3b>(y);
    for (int x = 0; x < picture.cols; ++x) {
      // The sum of four bytes is normal enough, with a deviation of 147.8.
      const uint64_t bits = random.Next();
      const int sum =
          static_cast<int>((bits & 255) + (bits >> 8 & 255) + (bits >> 16 & 255) + (bits >> 24 & 255)) - 510;
      const auto grain = static_cast<float>(deviation * sum / 147.8);
      for (int c = 0; c < 3; ++c) row[x][c] = cv::saturate_cast<uchar>(static_cast<float>(row[x][c]) + grain);
    }
  }
}

void Modulate(cv::Mat& picture, const cv::Mat& factor) {
  for (int y = 0; y < picture.rows; ++y) {
    auto* row = picture.ptr<cv::Vec3b>(y);
    const auto* by = factor.ptr<float>(y);
    for (int x = 0; x < picture.cols; ++x) {
      for (int c = 0; c < 3; ++c) row[x][c] = cv::saturate_cast<uchar>(static_cast<float>(row[x][c]) * by[x]);
    }
  }
}

std::string RandomWord(size_t length, Random& random) {
  std::string word;
  while (word.size() < length) {
    word += "BCDFGKLMNPRSTV"[random.Below(14)];
    if (word.size() < length) word += "AEIOU"[random.Below(5)];
  }
  return word;
}

void DrawWord(cv::Mat& picture, const std::string& word, const cv::Rect& where, const Paint& colour) {
  constexpr int kFont = cv::FONT_HERSHEY_DUPLEX;
  int baseline = 0;
  const cv::Size unit = cv::getTextSize(word, kFont, 1, 1, &baseline);
  const double scale =
      std::min(static_cast<double>(where.width) / unit.width, static_cast<double>(where.height) / unit.height);
  const int thickness = std::max(1, static_cast<int>(scale * 2));
  const cv::Point start(where.x + static_cast<int>((where.width - unit.width * scale) / 2),
                        where.y + static_cast<int>((where.height + unit.height * scale) / 2));
  cv::putText(picture, word, start, kFont, scale, colour, thickness, cv::LINE_AA);
}

void DrawMarks(cv::Mat& picture, const cv::Rect& where, int line_height, const Paint& colour, Random& random) {
  const int glyph = std::max(2, line_height * 2 / 5), stroke = std::max(1, line_height / 9);
  for (int y = where.y; y + line_height <= where.y + where.height; y += line_height) {
    const bool ends_early = random.Below(5) == 0;
    const int end =
        where.x + (ends_early ? static_cast<int>(where.width * random.Uniform(0.3, 0.9)) : where.width) - glyph;
    for (int x = where.x, left_in_word = 0; x < end; x += glyph + stroke) {
      if (left_in_word-- == 0) {
        left_in_word = 2 + static_cast<int>(random.Below(7));
        continue;  // a blank
      }
      const int top = y + line_height / 4, bottom = y + line_height * 3 / 4, middle = (top + bottom) / 2;
      const uint64_t shape = random.Next();
      const auto line = [&](int bit, cv::Point a, cv::Point b) {
        if (shape >> bit & 1) cv::line(picture, a, b, colour, stroke, cv::LINE_AA);
      };
      line(0, {x, top}, {x, bottom});
      line(1, {x, top}, {x + glyph - stroke, top});
      line(2, {x, middle}, {x + glyph - stroke, middle});
      line(3, {x, bottom}, {x + glyph - stroke, bottom});
      line(4, {x + glyph - stroke, top}, {x + glyph - stroke, bottom});
      line(5, {x, bottom}, {x + glyph - stroke, top});
    }
  }
}

}  // namespace yorb
