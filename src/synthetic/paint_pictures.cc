// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "synthetic/paint.h"

namespace yorb {
namespace {

cv::Point RandomPoint(cv::Size size, Random& random) {
  return {static_cast<int>(random.Below(size.width)), static_cast<int>(random.Below(size.height))};
}

void FillGradient(cv::Mat& picture, const Paint& top, const Paint& bottom) {
  for (int y = 0; y < picture.rows; ++y) {
    const double t = static_cast<double>(y) / picture.rows;
    picture.row(y).setTo(top * (1 - t) + bottom * t);
  }
}

// The outline of hills, filled down to the lower edge.
void DrawRidge(cv::Mat& picture, double height, double roughness, const Paint& colour, Random& random) {
  std::vector<cv::Point> outline;
  const double p1 = random.Uniform(0, 6.28), p2 = random.Uniform(0, 6.28), p3 = random.Uniform(0, 6.28);
  for (int x = 0; x <= picture.cols; x += 4) {
    const double u = static_cast<double>(x) / picture.cols * 6.28;
    const double lift =
        std::sin(u + p1) + 0.5 * std::sin(2.7 * u + p2) + 0.25 * std::sin(7.1 * u + p3) + 0.12 * random.Gaussian();
    outline.emplace_back(x, static_cast<int>(picture.rows * (height - roughness * lift)));
  }
  outline.emplace_back(picture.cols, picture.rows);
  outline.emplace_back(0, picture.rows);
  cv::fillPoly(picture, std::vector<std::vector<cv::Point>>{outline}, colour, cv::LINE_AA);
}

void DrawTree(cv::Mat& picture, const cv::Point& foot, int height, Random& random) {
  cv::line(picture, foot, foot - cv::Point(0, height / 2), Paint(34, 52, 74), std::max(1, height / 14), cv::LINE_AA);
  for (int i = 0; i < 14; ++i) {
    const cv::Point at = foot - cv::Point(static_cast<int>(random.Gaussian() * height / 6),
                                          height / 2 + static_cast<int>(random.Uniform() * height / 2));
    cv::circle(picture, at, std::max(2, height / 9), Hsv(random.Uniform(70, 140), 0.55, random.Uniform(0.2, 0.55)),
               cv::FILLED, cv::LINE_AA);
  }
}

void DrawShape(cv::Mat& picture, const Paint& colour, Random& random) {
  const cv::Point at = RandomPoint(picture.size(), random);
  const int radius = static_cast<int>(picture.cols * random.Uniform(0.03, 0.16));
  const int thickness = random.Below(3) == 0 ? std::max(2, radius / 5) : static_cast<int>(cv::FILLED);
  const double angle = random.Uniform(0, 360);
  switch (random.Below(4)) {
    case 0:
      cv::circle(picture, at, radius, colour, thickness, cv::LINE_AA);
      break;
    case 1:
      cv::ellipse(picture, at, {radius, radius / 2}, angle, 0, random.Uniform(120, 360), colour, thickness,
                  cv::LINE_AA);
      break;
    case 2: {
      const cv::RotatedRect box(at, cv::Size2f(static_cast<float>(2 * radius), static_cast<float>(radius)),
                                static_cast<float>(angle));
      cv::Point2f corner[4];
      box.points(corner);
      cv::fillConvexPoly(picture, std::vector<cv::Point>{corner[0], corner[1], corner[2], corner[3]}, colour,
                         cv::LINE_AA);
      break;
    }
    default: {
      std::vector<cv::Point> corner;
      for (int i = 0; i < 3; ++i) {
        const double turn = (angle + 120 * i + random.Uniform(-30, 30)) * 0.01745;
        corner.emplace_back(at.x + static_cast<int>(radius * std::cos(turn)),
                            at.y + static_cast<int>(radius * std::sin(turn)));
      }
      cv::fillConvexPoly(picture, corner, colour, cv::LINE_AA);
    }
  }
}

}  // namespace

cv::Mat PaintLandscape(cv::Size size, Random& random) {
  cv::Mat picture(size, CV_8UC3);
  const double hue = random.Uniform(195, 225);
  FillGradient(picture, Hsv(hue, 0.6, 0.85), Hsv(random.Uniform(20, 50), 0.25, 0.98));
  const cv::Point sun(static_cast<int>(size.width * random.Uniform(0.15, 0.85)),
                      static_cast<int>(size.height * random.Uniform(0.12, 0.3)));
  cv::circle(picture, sun, size.width / 14, Hsv(45, 0.3, 1), cv::FILLED, cv::LINE_AA);
  for (int i = 0; i < 4; ++i) {
    const double depth = i / 3.0;
    DrawRidge(picture, 0.42 + 0.16 * i, 0.07 - 0.008 * i,
              Hsv(205 - 100 * depth, 0.28 + 0.25 * depth, 0.72 - 0.3 * depth), random);
    for (int k = 0; k < 3 * i; ++k) {
      const cv::Point foot(static_cast<int>(random.Below(size.width)),
                           static_cast<int>(size.height * (0.5 + 0.15 * i + random.Uniform(0, 0.1))));
      DrawTree(picture, foot, static_cast<int>(size.height * (0.05 + 0.04 * i)), random);
    }
  }
  Modulate(picture, CloudNoise(size, {8, 8}, random) * 0.03 + 1);
  cv::rectangle(picture, cv::Rect({0, 0}, size), Paint::all(235), size.width / 24);
  return picture;
}

cv::Mat PaintPoster(cv::Size size, Random& random) {
  const double hue = random.Uniform(0, 360);
  cv::Mat picture(size, CV_8UC3);
  FillGradient(picture, Hsv(hue, random.Uniform(0.1, 0.5), 0.92), Hsv(hue + 30, random.Uniform(0.2, 0.6), 0.75));
  for (int i = 0; i < 12; ++i)
    DrawShape(picture, Hsv(hue + random.Uniform(90, 270), random.Uniform(0.4, 0.9), random.Uniform(0.25, 0.95)),
              random);
  const Paint ink = Hsv(hue + 180, 0.5, 0.18);
  const int w = size.width, h = size.height;
  DrawWord(picture, RandomWord(5 + random.Below(4), random), {w / 12, h / 18, w * 10 / 12, h / 8}, ink);
  cv::rectangle(picture, cv::Rect(w / 12, h * 3 / 4, w * 10 / 12, h / 5), Hsv(hue, 0.06, 0.96), cv::FILLED);
  DrawMarks(picture, {w / 10, h * 3 / 4 + 6, w * 8 / 10, h / 5 - 10}, std::max(10, h / 30), ink, random);
  cv::rectangle(picture, cv::Rect({0, 0}, size), Hsv(hue, 0.05, 0.97), w / 40);
  return picture;
}

cv::Mat PaintMap(cv::Size size, Random& random) {
  cv::Mat picture(size, CV_8UC3);
  const cv::Mat height = CloudNoise(size, {size.width / 4, size.height / 4}, random) +
                         CloudNoise(size, {size.width / 16, size.height / 16}, random) * 0.35;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const double level = height.at<float>(y, x);
      const bool is_contour = level > 0 && std::abs(level * 6 - std::round(level * 6)) < 0.08;
      const Paint colour = level < 0 ? Hsv(205, 0.35 + std::min(0.3, -level * 0.3), 0.9)
                                     : Hsv(110 - std::min(80.0, level * 60), 0.35, 0.85);
      picture.at<cv::Vec3b>(y, x) =
          cv::Vec3b(static_cast<uchar>(colour[0]), static_cast<uchar>(colour[1]), static_cast<uchar>(colour[2])) *
          (is_contour ? 0.75 : 1.0);
    }
  }
  for (int i = 0; i < 14; ++i) {
    const cv::Point at = RandomPoint(size, random), to = RandomPoint(size, random);
    if (i < 6) cv::line(picture, at, to, Paint(60, 80, 200), 2, cv::LINE_AA);
    cv::circle(picture, at, 5, Paint(40, 40, 40), cv::FILLED, cv::LINE_AA);
    DrawMarks(picture, {at.x + 8, at.y - 8, 60, 16}, 14, Paint(30, 30, 30), random);
  }
  cv::rectangle(picture, cv::Rect({0, 0}, size), Paint(220, 232, 238), size.width / 20);
  return picture;
}

cv::Mat PaintAbstract(cv::Size size, Random& random) {
  const double hue = random.Uniform(0, 360);
  cv::Mat picture(size, CV_8UC3, Hsv(hue, 0.08, 0.93));
  std::vector<int> columns{0}, rows{0};
  while (columns.back() < size.width)
    columns.push_back(columns.back() + static_cast<int>(size.width * random.Uniform(0.08, 0.3)));
  while (rows.back() < size.height)
    rows.push_back(rows.back() + static_cast<int>(size.height * random.Uniform(0.08, 0.3)));
  for (size_t i = 0; i + 1 < columns.size(); ++i) {
    for (size_t j = 0; j + 1 < rows.size(); ++j) {
      if (random.Below(3) == 0) continue;
      const Paint colour = Hsv(hue + 60 * random.Below(6) + random.Uniform(-12, 12), random.Uniform(0.3, 0.85),
                               random.Uniform(0.35, 0.95));
      cv::rectangle(picture, {columns[i], rows[j]}, {columns[i + 1], rows[j + 1]}, colour, cv::FILLED);
      cv::rectangle(picture, {columns[i], rows[j]}, {columns[i + 1], rows[j + 1]}, Paint(30, 28, 28),
                    std::max(2, size.width / 90));
      if (random.Below(3) == 0) {
        cv::circle(picture, {(columns[i] + columns[i + 1]) / 2, (rows[j] + rows[j + 1]) / 2},
                   (columns[i + 1] - columns[i]) / 3, Hsv(hue + 180, 0.7, random.Uniform(0.3, 0.9)), cv::FILLED,
                   cv::LINE_AA);
      }
    }
  }
  Modulate(picture, CloudNoise(size, {4, 4}, random) * 0.04 + 1);
  return picture;
}

}  // namespace yorb
