// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/still_picture.h"

#include <filesystem>
#include <fstream>
#include <utility>

#include "pictures/picture_file.h"

namespace yorb {
namespace {

constexpr int kUpright = 1;

/// Reads whole numbers of either byte order; zero beyond the end.
struct TiffReader {
  std::string_view bytes;
  bool is_little = false;

  uint32_t Number(size_t at, size_t size) const {
    uint32_t value = 0;
    for (size_t i = 0; i < size; ++i) {
      const size_t place = at + (is_little ? size - 1 - i : i);
      value = value << 8 | (place < bytes.size() ? static_cast<unsigned char>(bytes[place]) : 0u);
    }
    return value;
  }
};

/// The orientation in a TIFF directory, which is what EXIF consists of.
int OrientationOfTiff(std::string_view bytes) {
  constexpr uint32_t kOrientationTag = 0x0112, kMostEntries = 512;
  if (bytes.size() < 8) return kUpright;
  const TiffReader reader{bytes, bytes.substr(0, 2) == "II"};
  const size_t directory = reader.Number(4, 4);
  const uint32_t count = std::min(reader.Number(directory, 2), kMostEntries);
  for (uint32_t i = 0; i < count; ++i) {
    const size_t entry = directory + 2 + 12 * size_t{i};
    if (reader.Number(entry, 2) != kOrientationTag) continue;
    const uint32_t value = reader.Number(entry + 8, 2);
    return value >= 1 && value <= 8 ? static_cast<int>(value) : kUpright;
  }
  return kUpright;
}

int OrientationOfJpeg(std::string_view bytes) {
  const TiffReader reader{bytes, false};
  size_t at = 2;
  while (at + 4 <= bytes.size() && reader.Number(at, 1) == 0xff) {
    const uint32_t mark = reader.Number(at + 1, 1), length = reader.Number(at + 2, 2);
    if (mark == 0xda) break;  // the picture begins
    if (mark == 0xff) {
      ++at;
      continue;
    }
    const std::string_view segment = bytes.substr(at + 4, length < 2 ? 0 : length - 2);
    if (mark == 0xe1 && segment.substr(0, 6) == std::string_view("Exif\0\0", 6))
      return OrientationOfTiff(segment.substr(6));
    at += 2 + size_t{length};
  }
  return kUpright;
}

int OrientationOfPng(std::string_view bytes) {
  const TiffReader reader{bytes, false};
  size_t at = 8;
  while (at + 12 <= bytes.size()) {
    const size_t length = reader.Number(at, 4);
    const std::string_view name = bytes.substr(at + 4, 4);
    if (name == "eXIf") return OrientationOfTiff(bytes.substr(at + 8, length));
    if (length > bytes.size()) break;
    at += 12 + length;
  }
  return kUpright;
}

/// The beginning of a file, far enough for its EXIF block.
std::string HeadOf(const std::string& path) {
  constexpr size_t kHead = 1 << 18;
  std::ifstream stream(path, std::ios::binary);
  std::string head(kHead, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<size_t>(stream.gcount()));
  return head;
}

}  // namespace

int ExifOrientation(std::string_view bytes) {
  if (bytes.substr(0, 2) == "\xff\xd8") return OrientationOfJpeg(bytes);
  if (bytes.substr(0, 4) == "\x89PNG") return OrientationOfPng(bytes);
  return kUpright;
}

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
  return Upright(picture->colour.empty() ? picture->grey : picture->colour, ExifOrientation(HeadOf(path)));
}

}  // namespace yorb
