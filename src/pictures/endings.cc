// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/endings.h"

#include <algorithm>
#include <initializer_list>
#include <string>

#include "core/text.h"

namespace yorb {
namespace {

bool EndsAs(std::string_view name, std::initializer_list<std::string_view> known) {
  const size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) return false;
  const std::string ending = LowerCase(std::string(name.substr(dot + 1)));
  return std::find(known.begin(), known.end(), ending) != known.end();
}

}  // namespace

bool HasPictureEnding(std::string_view name) {
  // HEIC and AVIF cannot be read, and are better named as that than passed over.
  return EndsAs(name, {"png", "jpg", "jpeg", "jpe", "jfif", "tif", "tiff", "pgm", "ppm", "pnm", "pfm", "bmp", "exr",
                       "webp", "jp2", "heic", "heif", "avif"});
}

bool HasJpegEnding(std::string_view name) { return EndsAs(name, {"jpg", "jpeg"}); }

bool HasVideoEnding(std::string_view name) {
  return EndsAs(name, {"mp4", "avi", "mkv", "mov", "webm", "m4v", "mpg", "mpeg", "wmv", "ogv", "gif", "3gp", "mts",
                       "m2ts", "flv"});
}

}  // namespace yorb
