// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/picture_size.h"

#include <string>

#include "core/text.h"
#include "detection/network.h"

namespace yorb {

Result<cv::Size> ReadPictureSize(const std::optional<std::string>& text) {
  if (!text) return cv::Size();
  const auto parts = SplitAt(*text, 'x');
  const auto width = ParseInteger(parts.front()), height = ParseInteger(parts.back());
  const auto is_sound = [&](const std::optional<long long>& size) {
    return size && *size > 0 && *size <= kLargestSize && *size % kCellSize == 0;
  };
  if (parts.size() > 2 || !is_sound(width) || !is_sound(height))
    return BadInput("--size " + *text + " must be WIDTHxHEIGHT, multiples of " + std::to_string(kCellSize) + " up to " +
                    std::to_string(kLargestSize) + ", such as 320x256");
  return cv::Size(static_cast<int>(*width), static_cast<int>(*height));
}

}  // namespace yorb
