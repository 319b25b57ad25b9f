// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "synthetic/paint.h"

namespace yorb {
namespace {

Paint Vary(const Paint& colour, double amount, Random& random) {
  const double lightness = 1 + amount * random.Gaussian();
  Paint varied;
  for (int c = 0; c < 3; ++c)
    varied[c] = std::clamp(colour[c] * (lightness + 0.12 * amount * random.Gaussian()), 0.0, 255.0);
  return varied;
}

// One board: long streaks, a few darker lines that wander, sometimes a knot.
void PaintBoard(cv::Mat board, const Paint& colour, Random& random) {
  board.setTo(Vary(colour, 0.09, random));
  cv::Mat factor(board.size(), CV_32FC1);
  const double lines = random.Uniform(3, 7) / board.rows * 6.283, wave = random.Uniform(0.5, 2.0),
               phase = random.Uniform(0, 6.28);
  const cv::Point2d knot(random.Uniform(0.1, 0.9) * board.cols, random.Uniform(0.2, 0.8) * board.rows);
  const double knot_size = random.Below(3) == 0 ? board.rows * random.Uniform(0.1, 0.25) : 0;
  for (int y = 0; y < board.rows; ++y) {
    for (int x = 0; x < board.cols; ++x) {
      const double dx = (x - knot.x) / 3, dy = y - knot.y, r2 = dx * dx + dy * dy;
      const double bent =
          y + (knot_size > 0 ? knot_size * 1.5 * (dy > 0 ? 1 : -1) * std::exp(-r2 / (8 * knot_size * knot_size)) : 0);
      const double rings = std::sin(bent * lines + wave * std::sin(x * 6.283 / board.cols + phase) + phase);
      const double dark = knot_size > 0 ? 0.45 * std::exp(-r2 / (knot_size * knot_size)) : 0;
      factor.at<float>(y, x) =
          static_cast<float>(1 - 0.05 * rings - 0.03 * std::sin(bent * lines * 3.1 + 2 * phase) - dark);
    }
  }
  Modulate(board, factor);
}

void AddGrain(cv::Mat& picture, double strength, Random& random) {
  cv::Mat grain = CloudNoise(picture.size(), {std::max(1, picture.cols / 16), 2}, random);
  grain += CloudNoise(picture.size(), {std::max(1, picture.cols / 8), 8}, random);
  Modulate(picture, grain * strength + 1);
}

}  // namespace

cv::Mat PaintPlaster(cv::Size size, const Paint& colour, Random& random) {
  cv::Mat picture(size, CV_8UC3, colour);
  cv::Mat relief = CloudNoise(size, {16, 16}, random) * 0.5 + CloudNoise(size, {4, 4}, random) * 0.5;
  const cv::Mat stains = CloudNoise(size, {size.width / 4, size.height / 4}, random);
  Modulate(picture, relief * 0.022 + stains * 0.02 + 1);
  for (int i = 0; i < 40; ++i) {  // scratches and spots of trowel and time
    const cv::Point at(static_cast<int>(random.Below(size.width)), static_cast<int>(random.Below(size.height)));
    const cv::Point to(at.x + static_cast<int>(random.Gaussian() * 12), at.y + static_cast<int>(random.Gaussian() * 5));
    cv::line(picture, at, to, colour * random.Uniform(0.82, 1.06), 1 + static_cast<int>(random.Below(2)), cv::LINE_AA);
  }
  Speckle(picture, 2, random);
  return picture;
}

cv::Mat PaintWallpaper(cv::Size size, const Paint& colour, Random& random) {
  cv::Mat picture = PaintPlaster(size, colour, random);
  const int step = size.width / 8;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const cv::Point at(x * step + step / 2, y * step + ((x & 1) ? step / 2 : 0) + step / 4);
      const Paint ink = Vary(colour * 0.88, 0.03, random);
      const double turn = random.Uniform(-12, 12);
      for (const double angle : {30.0, 90.0, 150.0}) {
        cv::ellipse(picture, at, {step / 5, step / 14}, angle + turn, 0, 360, ink, cv::FILLED, cv::LINE_AA);
      }
      cv::circle(picture, at, step / 16, Vary(colour * 0.75, 0.05, random), cv::FILLED, cv::LINE_AA);
    }
  }
  return picture;
}

cv::Mat PaintBricks(cv::Size size, Random& random) {
  const Paint mortar(172, 180, 186);
  cv::Mat picture(size, CV_8UC3, mortar);
  Speckle(picture, 10, random);
  constexpr int kCourses = 16, kBricks = 8;
  const int height = size.height / kCourses, width = size.width / kBricks, joint = std::max(1, height / 12);
  for (int row = 0; row < kCourses; ++row) {
    for (int column = 0; column < kBricks; ++column) {
      Paint colour = Vary(Paint(78, 98, 168), 0.13, random);
      if (random.Below(9) == 0) colour = Vary(Paint(62, 66, 92), 0.1, random);
      const int left = column * width + ((row & 1) ? width / 2 : 0) + joint, top = row * height + joint;
      for (const int shift : {0, -size.width}) {
        cv::rectangle(picture, cv::Rect(left + shift, top, width - 2 * joint, height - 2 * joint), colour, cv::FILLED);
        cv::line(picture, {left + shift, top + height - 2 * joint - 1},
                 {left + shift + width - 2 * joint - 1, top + height - 2 * joint - 1}, colour * 0.7,
                 std::max(1, joint / 2));
      }
    }
  }
  Modulate(picture, CloudNoise(size, {8, 8}, random) * 0.06 + CloudNoise(size, {2, 2}, random) * 0.06 + 1);
  return picture;
}

cv::Mat PaintFloorboards(cv::Size size, Random& random) {
  cv::Mat picture(size, CV_8UC3);
  constexpr int kBoards = 16;
  const int height = size.height / kBoards;
  for (int row = 0; row < kBoards; ++row) {
    const int joint = static_cast<int>(random.Uniform(0.2, 0.8) * size.width);
    for (const auto& span : {cv::Range(0, joint), cv::Range(joint, size.width)}) {
      cv::Mat board = picture(cv::Range(row * height, (row + 1) * height), span);
      PaintBoard(board, Paint(92, 134, 178), random);
      cv::rectangle(board, cv::Rect(0, 0, board.cols, board.rows), Paint(40, 62, 88), 1);
    }
  }
  AddGrain(picture, 0.028, random);
  return picture;
}

cv::Mat PaintWood(cv::Size size, const Paint& colour, Random& random) {
  cv::Mat picture(size, CV_8UC3);
  const int height = size.height / 4;
  for (int row = 0; row < 4; ++row)
    PaintBoard(picture(cv::Range(row * height, (row + 1) * height), cv::Range::all()), colour, random);
  AddGrain(picture, 0.028, random);
  return picture;
}

cv::Mat PaintCeilingTiles(cv::Size size, Random& random) {
  cv::Mat picture(size, CV_8UC3, Paint(222, 226, 228));
  for (int i = 0; i < size.area() / 160; ++i) {
    const cv::Point at(static_cast<int>(random.Below(size.width)), static_cast<int>(random.Below(size.height)));
    cv::circle(picture, at, 1 + static_cast<int>(random.Below(2)), Paint::all(random.Uniform(150, 205)), cv::FILLED,
               cv::LINE_AA);
  }
  const int step = size.width / 2;
  for (int i = 0; i < 2; ++i) {
    cv::line(picture, {i * step, 0}, {i * step, size.height}, Paint::all(178), 4);
    cv::line(picture, {0, i * step}, {size.width, i * step}, Paint::all(178), 4);
  }
  return picture;
}

cv::Mat PaintCloth(cv::Size size, const Paint& colour, Random& random) {
  cv::Mat picture(size, CV_8UC3, colour);
  const uint32_t kind = random.Below(4);
  const Paint second = Hsv(random.Uniform(0, 360), random.Uniform(0.1, 0.6), random.Uniform(0.3, 0.95));
  const int step = size.height / (8 << random.Below(2));
  for (int y = 0; y < size.height && kind == 1; y += step)
    cv::rectangle(picture, cv::Rect(0, y, size.width, step / 2), second, cv::FILLED);
  for (int at = 0; at < size.height && kind == 2; at += step) {
    cv::Mat row = picture(cv::Rect(0, at, size.width, step / 3)),
            column = picture(cv::Rect(at % size.width, 0, step / 3, size.height));
    cv::addWeighted(row, 0.5, cv::Mat(row.size(), CV_8UC3, second), 0.5, 0, row);
    cv::addWeighted(column, 0.5, cv::Mat(column.size(), CV_8UC3, second), 0.5, 0, column);
  }
  for (int y = 0; y < size.height && kind == 3; y += step) {
    for (int x = 0; x < size.width; x += step) {
      cv::circle(picture, {x + ((y / step) & 1 ? step / 2 : 0), y + step / 2}, step / 5, second, cv::FILLED,
                 cv::LINE_AA);
    }
  }
  // Folds and weave.
  const cv::Mat folds = CloudNoise(size, {size.width / 16, size.height / 4}, random);
  Modulate(picture, folds * 0.07 + CloudNoise(size, {2, 2}, random) * 0.05 + 1);
  return picture;
}

cv::Mat PaintMetal(cv::Size size, const Paint& colour, Random& random) {
  cv::Mat picture(size, CV_8UC3, colour);
  Modulate(picture, CloudNoise(size, {size.width / 4, 1}, random) * 0.03 +
                        CloudNoise(size, {size.width / 2, size.height / 2}, random) * 0.05 + 1);
  return picture;
}

cv::Mat PaintLeaf(cv::Size size, Random& random) {
  cv::Mat picture(size, CV_8UC3, Paint(48, 118, 58));
  for (int i = 0; i < 9; ++i) {
    const int x = size.width * i / 9;
    cv::line(picture, {size.width / 2, size.height * i / 9}, {0, size.height * i / 9 - size.width / 2},
             Paint(70, 160, 90), 2, cv::LINE_AA);
    cv::line(picture, {size.width / 2, size.height * i / 9}, {size.width, size.height * i / 9 - size.width / 2},
             Paint(70, 160, 90), 2, cv::LINE_AA);
    cv::circle(picture, {x, static_cast<int>(random.Below(size.height))}, 3, Paint(40, 90, 50), cv::FILLED,
               cv::LINE_AA);
  }
  cv::line(picture, {size.width / 2, 0}, {size.width / 2, size.height}, Paint(90, 180, 120), 3, cv::LINE_AA);
  Modulate(picture, CloudNoise(size, {8, 8}, random) * 0.08 + 1);
  return picture;
}

}  // namespace yorb
