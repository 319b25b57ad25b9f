// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/still_picture.h"

#include <filesystem>

#include "pictures/picture_file.h"

namespace yorb {
cv::Mat Upright(const cv::Mat& picture, int orientation) {
  enum Flip { kAboutX = 0, kAboutY = 1, kBoth = -1 };
  cv::Mat turned = picture;
  if (orientation >= 5) {  // 5 to 8 lie on their side
    cv::Mat transposed;
    cv::transpose(picture, transposed);
    turned = transposed;
  }
  const auto flipped = [&turned](Flip flip) {
    cv::Mat result;
    cv::flip(turned, result, flip);
    return result;
  };
  switch (orientation) {
    case 2:
    case 6:
      return flipped(kAboutY);
    case 3:
    case 7:
      return flipped(kBoth);
    case 4:
    case 8:
      return flipped(kAboutX);
    default:
      return turned;
  }
}

Result<cv::Mat> ReadUprightPicture(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return BadInput(path + " does not exist");
  if (std::filesystem::is_directory(path, ignored)) return BadInput(path + " is a folder, a picture is expected");
  const StoredPicture stored = ReadPictureFile(path);
  if (!stored.fault.empty()) return BadInput(path + " " + stored.fault);
  auto picture = ToColourAndGrey(stored.pixels, path);
  if (!picture) return picture.error();
  return Upright(picture->colour.empty() ? picture->grey : picture->colour, stored.orientation);
}

}  // namespace yorb
