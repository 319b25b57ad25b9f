// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/exif.h"

#include <algorithm>
#include <cstdint>

namespace yorb {
namespace {

constexpr int kUpright = 1;
constexpr std::string_view kExifMark("Exif\0\0", 6);

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
    if (mark == 0xe1 && segment.substr(0, 6) == kExifMark) return OrientationOfTiff(segment.substr(6));
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

/// Chunks of an even length each; the block stands behind the picture, with JPEG's mark before it or without.
int OrientationOfWebp(std::string_view bytes) {
  const TiffReader reader{bytes, true};
  size_t at = 12;
  while (at + 8 <= bytes.size()) {
    const size_t length = reader.Number(at + 4, 4);
    if (bytes.substr(at, 4) == "EXIF") {
      const std::string_view block = bytes.substr(at + 8, length);
      const bool is_marked = block.substr(0, 6) == kExifMark;
      return OrientationOfTiff(block.substr(is_marked ? 6 : 0));
    }
    at += 8 + length + length % 2;
  }
  return kUpright;
}

}  // namespace

int ExifOrientation(std::string_view bytes) {
  if (bytes.substr(0, 2) == "\xff\xd8") return OrientationOfJpeg(bytes);
  if (bytes.substr(0, 4) == "\x89PNG") return OrientationOfPng(bytes);
  if (bytes.size() >= 12 && bytes.substr(0, 4) == "RIFF" && bytes.substr(8, 4) == "WEBP")
    return OrientationOfWebp(bytes);
  return kUpright;
}

}  // namespace yorb
