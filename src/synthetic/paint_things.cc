// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "synthetic/paint.h"

namespace yorb {
namespace {

cv::Rect Inside(const cv::Rect& field, int margin) {
  return {field.x + margin, field.y + margin, std::max(1, field.width - 2 * margin),
          std::max(1, field.height - 2 * margin)};
}

void PaintSpine(cv::Mat& picture, const cv::Rect& field, Random& random) {
  const double hue = random.Uniform(0, 360);
  const Paint cover = Hsv(hue, random.Uniform(0.1, 0.8), random.Uniform(0.2, 0.9));
  const Paint ink = cover[0] + cover[1] + cover[2] > 330 ? Paint(30, 30, 40) : Hsv(45, random.Uniform(0, 0.6), 0.92);
  cv::rectangle(picture, field, cover, cv::FILLED);
  for (int i = 0; i < 3; ++i) {
    if (random.Below(2) == 0) continue;
    const int y = field.y + static_cast<int>(field.height * random.Uniform(0.04, 0.95));
    cv::rectangle(picture, cv::Rect(field.x, y, field.width, 2 + static_cast<int>(random.Below(5))), ink, cv::FILLED);
  }
  // The title runs along the spine: written on a lying field, then turned.
  const int length = static_cast<int>(field.height * random.Uniform(0.35, 0.6)), width = field.width * 3 / 5;
  cv::Mat title(width, length, CV_8UC3, cover);
  if (random.Below(2) == 0) {
    DrawWord(title, RandomWord(6 + random.Below(6), random), {2, 2, length - 4, width - 4}, ink);
  } else {
    DrawMarks(title, {2, 2, length - 4, width - 4}, std::max(6, width / 2), ink, random);
  }
  cv::rotate(title, title, cv::ROTATE_90_CLOCKWISE);
  title.copyTo(picture(cv::Rect(field.x + (field.width - width) / 2, field.y + field.height / 6, width, length)));
  cv::rectangle(picture, field, cover * 0.6, 1);
}

}  // namespace

cv::Mat PaintRug(cv::Size size, Random& random) {
  const double hue = random.Uniform(340, 400);
  const Paint ground = Hsv(hue, 0.65, 0.5), light = Hsv(hue + 30, 0.3, 0.8), dark = Hsv(hue + 200, 0.5, 0.25);
  cv::Mat picture(size, CV_8UC3, ground);
  const int unit = size.width / 32;
  for (int ring = 0; ring < 3; ++ring) {
    cv::rectangle(picture, Inside({0, 0, size.width, size.height}, unit * (1 + 2 * ring)), ring % 2 ? light : dark,
                  std::max(2, unit / 3));
  }
  const auto motif = [&](cv::Point at, int radius, const Paint& inner) {
    cv::fillConvexPoly(picture,
                       std::vector<cv::Point>{
                           {at.x - radius, at.y}, {at.x, at.y - radius}, {at.x + radius, at.y}, {at.x, at.y + radius}},
                       light, cv::LINE_AA);
    cv::fillConvexPoly(picture,
                       std::vector<cv::Point>{{at.x - radius * 2 / 3, at.y},
                                              {at.x, at.y - radius * 2 / 3},
                                              {at.x + radius * 2 / 3, at.y},
                                              {at.x, at.y + radius * 2 / 3}},
                       dark, cv::LINE_AA);
    cv::circle(picture, at, std::max(1, radius / 3), inner, cv::FILLED, cv::LINE_AA);
  };
  for (int x = 4 * unit; x < size.width; x += 3 * unit) {
    for (const int y : {4 * unit, size.height - 4 * unit})
      motif({x, y}, unit, Hsv(hue + 60 * random.Below(6), 0.5, 0.7));
  }
  for (int i = 0; i < 40; ++i) {
    const cv::Point at(6 * unit + static_cast<int>(random.Below(std::max(1, size.width - 12 * unit))),
                       6 * unit + static_cast<int>(random.Below(std::max(1, size.height - 12 * unit))));
    motif(at, unit / 2 + static_cast<int>(random.Below(unit + 1)), Hsv(hue + 60 * random.Below(6), 0.5, 0.8));
  }
  Modulate(picture, CloudNoise(size, {2, 2}, random) * 0.08 +
                        CloudNoise(size, {size.width / 8, size.height / 8}, random) * 0.04 + 1);
  return picture;
}

cv::Mat PaintBookSpines(cv::Size size, int columns, int rows, Random& random) {
  cv::Mat picture(size, CV_8UC3);
  const int width = size.width / columns, height = size.height / rows;
  for (int i = 0; i < columns * rows; ++i)
    PaintSpine(picture, {i % columns * width, i / columns * height, width, height}, random);
  Modulate(picture, CloudNoise(size, {4, 16}, random) * 0.05 + 1);
  return picture;
}

cv::Mat PaintPage(cv::Size size, Random& random) {
  cv::Mat picture(size, CV_8UC3, Paint(232, 240, 243));
  const int w = size.width, h = size.height, line = std::max(6, h / 34);
  DrawWord(picture, RandomWord(7 + random.Below(5), random), {w / 10, h / 20, w * 6 / 10, h / 14}, Paint(40, 30, 30));
  const int figure = h / 4 + static_cast<int>(random.Below(h / 4));
  DrawMarks(picture, {w / 10, h / 7, w * 8 / 10, figure - h / 7}, line, Paint(60, 50, 50), random);
  cv::rectangle(picture, cv::Rect(w / 8, figure, w * 3 / 4, h / 5), Hsv(random.Uniform(0, 360), 0.25, 0.85),
                cv::FILLED);
  for (int i = 0; i < 8; ++i) {
    const int bar = static_cast<int>(random.Below(h / 6));
    cv::rectangle(picture, cv::Rect(w / 7 + i * w / 11, figure + h / 5 - bar, w / 16, bar),
                  Hsv(random.Uniform(0, 360), 0.6, 0.6), cv::FILLED);
  }
  DrawMarks(picture, {w / 10, figure + h / 4, w * 8 / 10, h - figure - h / 4 - h / 14}, line, Paint(60, 50, 50),
            random);
  return picture;
}

cv::Mat PaintScreen(cv::Size size, Random& random) {
  const double hue = random.Uniform(180, 260);
  const int w = size.width, h = size.height;
  cv::Mat picture(size, CV_8UC3, Hsv(hue, 0.6, 0.45));
  Modulate(picture, CloudNoise(size, {w / 4, h / 4}, random) * 0.25 + 1);
  for (int i = 0; i < 3; ++i) {
    const cv::Rect window(static_cast<int>(w * (0.05 + 0.28 * i)), static_cast<int>(h * random.Uniform(0.06, 0.25)),
                          static_cast<int>(w * random.Uniform(0.3, 0.38)),
                          static_cast<int>(h * random.Uniform(0.5, 0.65)));
    const bool is_dark = random.Below(2) == 0;
    cv::rectangle(picture, window, is_dark ? Paint(46, 40, 38) : Paint(240, 240, 238), cv::FILLED);
    cv::rectangle(picture, cv::Rect(window.x, window.y, window.width, h / 24), Hsv(hue + 60 * i, 0.5, 0.7), cv::FILLED);
    for (int k = 0; k < 3; ++k) {
      const cv::Rect block(window.x + w / 50, window.y + h / 16 + k * window.height * 3 / 10, window.width - w / 25,
                           window.height / 4);
      DrawMarks(picture, block, std::max(8, h / 28), Hsv(60 + 100 * k, 0.45, is_dark ? 0.85 : 0.35), random);
    }
  }
  cv::rectangle(picture, cv::Rect(0, h - h / 18, w, h / 18), Paint(70, 60, 56), cv::FILLED);
  for (int i = 0; i < 9; ++i)
    cv::rectangle(picture, cv::Rect(w / 60 + i * w / 22, h - h / 22, w / 32, h / 26), Hsv(40 * i, 0.6, 0.9),
                  cv::FILLED);
  cv::rectangle(picture, cv::Rect({0, 0}, size), Paint(24, 24, 24), w / 36);
  return picture;
}

cv::Mat PaintKeyboard(cv::Size size, Random& random) {
  cv::Mat picture(size, CV_8UC3, Paint(44, 42, 42));
  constexpr int kColumns = 16, kRows = 5;
  const int width = size.width / kColumns, height = size.height / kRows;
  for (int i = 0; i < kColumns * kRows; ++i) {
    const cv::Rect key = Inside({i % kColumns * width, i / kColumns * height, width, height}, std::max(1, width / 10));
    cv::rectangle(picture, key, Paint::all(random.Uniform(80, 105)), cv::FILLED);
    DrawWord(picture, RandomWord(1, random), Inside(key, width / 4), Paint::all(220));
  }
  return picture;
}

cv::Mat PaintDoor(cv::Size size, const Paint& colour, Random& random) {
  cv::Mat picture = PaintWood(size, colour, random);
  const int w = size.width, h = size.height;
  for (const cv::Rect& panel :
       {cv::Rect(w / 8, h / 14, w * 3 / 4, h * 2 / 5), cv::Rect(w / 8, h * 6 / 11, w * 3 / 4, h * 2 / 5)}) {
    cv::rectangle(picture, panel, colour * 0.55, std::max(2, w / 40));
    cv::rectangle(picture, Inside(panel, w / 24), colour * 1.2, std::max(2, w / 60));
  }
  cv::rectangle(picture, cv::Rect({0, 0}, size), colour * 0.6, w / 24);
  return picture;
}

cv::Mat PaintDrawers(cv::Size size, const Paint& colour, int columns, int rows, Random& random) {
  cv::Mat picture = PaintWood(size, colour, random);
  const int width = size.width / columns, height = size.height / rows;
  for (int i = 0; i < columns * rows; ++i) {
    const cv::Rect front(i % columns * width, i / columns * height, width, height);
    cv::rectangle(picture, Inside(front, 2), colour * 0.45, std::max(2, size.width / 100));
    const cv::Point knob(front.x + width / 2, front.y + height / 3);
    cv::rectangle(picture, knob - cv::Point(width / 9, height / 40 + 2), knob + cv::Point(width / 9, height / 40 + 2),
                  Paint::all(200), cv::FILLED);
    cv::rectangle(picture, knob - cv::Point(width / 9, -height / 40), knob + cv::Point(width / 9, height / 30 + 2),
                  Paint::all(70), cv::FILLED);
    if (random.Below(3) == 0)
      DrawMarks(picture, {front.x + width / 3, front.y + height / 2, width / 3, height / 4}, std::max(8, height / 12),
                Paint(240, 240, 240), random);
  }
  return picture;
}

cv::Mat PaintWindow(cv::Size size, Random& random) {
  cv::Mat picture = PaintLandscape(size, random);
  picture.convertTo(picture, -1, 0.6, 95);  // the bright outside
  const int w = size.width, h = size.height;
  const Paint frame(238, 240, 240);
  cv::rectangle(picture, cv::Rect({0, 0}, size), frame, w / 12);
  cv::line(picture, {w / 2, 0}, {w / 2, h}, frame, w / 20);
  cv::line(picture, {0, h / 3}, {w, h / 3}, frame, w / 28);
  cv::rectangle(picture, cv::Rect(w / 24, h / 24, w * 11 / 12, h * 11 / 12), Paint::all(150), 2);
  cv::line(picture, {w / 2 - w / 40, 0}, {w / 2 - w / 40, h}, Paint::all(160), 2);
  return picture;
}

cv::Mat PaintHead(cv::Size size, const Paint& skin, const Paint& hair, Random& random) {
  cv::Mat picture(size, CV_8UC3, skin);
  const int w = size.width, h = size.height, middle = w / 2;
  // v runs from the crown (0) to the chin (1), u once round the head.
  cv::rectangle(picture, cv::Rect(0, 0, w, h * 3 / 10), hair, cv::FILLED);
  cv::rectangle(picture, cv::Rect(0, 0, w * 3 / 10, h * 7 / 10), hair, cv::FILLED);
  cv::rectangle(picture, cv::Rect(w * 7 / 10, 0, w * 3 / 10, h * 7 / 10), hair, cv::FILLED);
  for (const int side : {-1, 1}) {
    const cv::Point eye(middle + side * w / 14, h * 47 / 100);
    cv::ellipse(picture, eye, {w / 34, h / 34}, 0, 0, 360, Paint::all(240), cv::FILLED, cv::LINE_AA);
    cv::circle(picture, eye, std::max(1, h / 40), Paint(60, 50, 40), cv::FILLED, cv::LINE_AA);
    cv::line(picture, eye - cv::Point(w / 28, h / 14), eye + cv::Point(w / 28, -h / 14), hair * 0.8,
             std::max(1, h / 50), cv::LINE_AA);
  }
  cv::line(picture, {middle, h * 47 / 100}, {middle + w / 60, h * 62 / 100}, skin * 0.75, std::max(1, w / 90),
           cv::LINE_AA);
  cv::ellipse(picture, {middle, h * 74 / 100}, {w / 20, h / 50}, 0, 0, 360, Paint(100, 90, 180), cv::FILLED,
              cv::LINE_AA);
  Modulate(picture, CloudNoise(size, {4, 16}, random) * 0.05 + 1);
  return picture;
}

cv::Mat PaintPackage(cv::Size size, Random& random) {
  const Paint cover = Hsv(random.Uniform(0, 360), random.Uniform(0.3, 0.8), random.Uniform(0.4, 0.9));
  cv::Mat picture(size, CV_8UC3, cover);
  const int w = size.width, h = size.height;
  cv::rectangle(picture, cv::Rect(0, h / 6, w, h / 4), Hsv(random.Uniform(0, 360), 0.6, 0.9), cv::FILLED);
  DrawWord(picture, RandomWord(4 + random.Below(4), random), {w / 10, h / 5, w * 8 / 10, h / 6}, Paint::all(25));
  cv::circle(picture, {w / 2, h * 6 / 10}, w / 6, Hsv(random.Uniform(0, 360), 0.5, 0.95), cv::FILLED, cv::LINE_AA);
  DrawMarks(picture, {w / 10, h * 3 / 4, w * 8 / 10, h / 5}, std::max(6, h / 16), Paint::all(240), random);
  cv::rectangle(picture, cv::Rect({0, 0}, size), cover * 0.6, 2);
  return picture;
}

}  // namespace yorb
