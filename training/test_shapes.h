// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "core/random.h"
#include "training/pack.h"

namespace yorb {

/// Pictures of 128 x 96 px with two to four bright shapes on noise: discs are class 0, squares class 1.
inline std::vector<PackItem> MakeShapePictures(int count, uint64_t seed) {
  std::vector<PackItem> items;
  for (int i = 0; i < count; ++i) {
    Random random(seed, static_cast<uint64_t>(i));
    PackItem item;
    item.pixels = cv::Mat(96, 128, CV_8UC3);
    cv::RNG(random.Next()).fill(item.pixels, cv::RNG::UNIFORM, 60, 120);
    item.judged.set();
    const int columns = 2 + static_cast<int>(random.Below(3));
    for (int c = 0; c < columns; ++c) {
      const int radius = 8 + static_cast<int>(random.Below(7));
      const int x = (2 * c + 1) * 128 / (2 * columns), y = 20 + static_cast<int>(random.Below(56));
      const cv::Scalar color(random.Uniform(0, 50), random.Uniform(150, 255), random.Uniform(150, 255));
      const bool is_square = random.Below(2) == 1;
      if (is_square)
        cv::rectangle(item.pixels, {x - radius, y - radius}, {x + radius, y + radius}, color, cv::FILLED);
      else
        cv::circle(item.pixels, {x, y}, radius, color, cv::FILLED);
      const float side = 2.0f * static_cast<float>(radius) + 1;
      item.boxes.push_back({(static_cast<float>(x) + 0.5f) / 128, (static_cast<float>(y) + 0.5f) / 96, side / 128,
                            side / 96, static_cast<int16_t>(is_square), 0});
    }
    items.push_back(item);
  }
  return items;
}

/// The same as a pack in a file.
inline std::shared_ptr<const Pack> MakeShapePack(const std::string& path, int count, uint64_t seed) {
  auto writer = PackWriter::Create(path, {"disc", "square"});
  if (!writer) return nullptr;
  for (const PackItem& item : MakeShapePictures(count, seed)) {
    if (!(*writer)->Add(item)) return nullptr;
  }
  if (!(*writer)->Finish()) return nullptr;
  const auto pack = Pack::Open(path);
  return pack ? *pack : nullptr;
}

}  // namespace yorb
