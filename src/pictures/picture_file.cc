// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/picture_file.h"

#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <opencv2/imgproc.hpp>
#include <string_view>

#include "core/text.h"
#include "pictures/endings.h"
#include "pictures/exif.h"
#include "pictures/jpeg.h"
#include "pictures/other_formats.h"
#include "pictures/png.h"

namespace yorb {
namespace {

constexpr std::streamoff kLargestFile = 1 << 30;  // bytes; OpenCV counts them in an int
const char* const kCut = "is cut short";
const char* const kDamaged = "is damaged";

unsigned Byte(std::string_view bytes, size_t at) { return static_cast<unsigned char>(bytes[at]); }

/// Walks over the headers to the first scan, then wants the end-of-image mark behind it: an embedded preview in the
/// headers has an end mark of its own.
std::string FaultOfJpeg(std::string_view bytes) {
  constexpr unsigned kStartOfScan = 0xda;
  size_t at = 2;
  while (at + 4 <= bytes.size()) {
    if (Byte(bytes, at) != 0xff) return kDamaged;
    const unsigned mark = Byte(bytes, at + 1);
    if (mark == 0xff) {  // padding
      ++at;
      continue;
    }
    if (mark == kStartOfScan) {
      const bool has_end = bytes.rfind(std::string_view("\xff\xd9", 2)) != std::string_view::npos &&
                           bytes.rfind(std::string_view("\xff\xd9", 2)) > at;
      return has_end ? "" : kCut;
    }
    at += 2 + (Byte(bytes, at + 2) << 8 | Byte(bytes, at + 3));
  }
  return kCut;
}

/// Walks from chunk to chunk until IEND.
std::string FaultOfPng(std::string_view bytes) {
  size_t at = 8;
  while (at + 12 <= bytes.size()) {
    const size_t length = static_cast<size_t>(Byte(bytes, at)) << 24 | Byte(bytes, at + 1) << 16 |
                          Byte(bytes, at + 2) << 8 | Byte(bytes, at + 3);
    const std::string_view name = bytes.substr(at + 4, 4);
    if (name == "IEND") return "";
    if (length > bytes.size() - at - 12) return kCut;
    at += 12 + length;
  }
  return kCut;
}

std::string KindOf(const cv::Mat& picture) {
  const char* const depths[] = {"8-bit",        "8-bit signed", "16-bit",       "16-bit signed",
                                "32-bit whole", "32-bit float", "64-bit float", "16-bit float"};
  const int channels = picture.channels();
  return std::string(depths[picture.depth() & 7]) + " with " + std::to_string(channels) +
         (channels == 1 ? " channel" : " channels");
}

}  // namespace

std::string SizeText(const cv::Size& size) { return SizeText(size.width, size.height); }

std::string FaultOfPictureBytes(const std::string& bytes) {
  const std::string_view view = bytes;
  if (view.empty()) return "is empty (0 bytes)";
  if (view.substr(0, 2) == "\xff\xd8") return FaultOfJpeg(view);
  if (view.substr(0, 8) == "\x89PNG\r\n\x1a\n") return FaultOfPng(view);
  if (view.substr(0, 4) == "\x89PNG") return "is damaged (its line ends were converted)";
  if (view.substr(0, 6) == "\x93NUMPY") return "is a numpy array, a picture is expected";
  if (view.substr(0, 24) == "version https://git-lfs.")
    return "is a Git LFS pointer, the picture itself was not fetched";
  if (view.find_first_not_of('\0') == std::string_view::npos) return "holds zero bytes only";
  return "";
}

namespace {

DecodedPicture DecodeCommon(const std::string& bytes) {
  try {
    if (bytes.compare(0, 2, "\xff\xd8") == 0) return DecodeJpeg(bytes);
    if (bytes.compare(0, 4, "\x89PNG") == 0) return DecodePng(bytes);
  } catch (const std::exception&) {  // more pixels than memory
    return {DecodedPicture::Kind::kDamaged, {}};
  }
  return {};
}

/// Of bytes that nobody could make a picture of.
std::string FaultOfUndecoded(std::string_view bytes) {
  constexpr unsigned kIsAnimated = 2;
  const std::string_view brand = bytes.size() < 12 || bytes.substr(4, 4) != "ftyp" ? "" : bytes.substr(8, 4);
  for (const char* unread : {"heic", "heix", "mif1", "msf1", "avif", "avis"}) {
    if (brand == unread) return "is HEIC or AVIF, which are not read; save it as JPEG or PNG";
  }
  const bool is_webp = bytes.size() > 20 && bytes.substr(0, 4) == "RIFF" && bytes.substr(8, 8) == "WEBPVP8X";
  if (is_webp && (Byte(bytes, 20) & kIsAnimated) != 0) return "is an animated WebP, which is not read; save it as GIF";
  return "cannot be decoded";
}

/// By what the bytes begin with; whatever is left over goes to the other formats.
StoredPicture Decode(const std::string& bytes) {
  DecodedPicture picture = DecodeCommon(bytes);
  if (picture.kind == DecodedPicture::Kind::kDamaged) return {{}, kDamaged};
  if (picture.kind == DecodedPicture::Kind::kWhole) return {picture.pixels, ""};
  const auto others = LoadOtherFormats();
  if (!others) return {{}, others.error().message};
  picture.pixels = (*others)->Decode(bytes);
  return {picture.pixels, picture.pixels.empty() ? FaultOfUndecoded(bytes) : ""};
}

}  // namespace

StoredPicture ReadPictureFile(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored))
    return {{}, "is no regular file"};  // a named pipe would never open
  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = stream ? static_cast<std::streamoff>(stream.tellg()) : -1;
  if (size < 0 || size > kLargestFile) return {{}, "cannot be opened"};
  std::string bytes(static_cast<size_t>(size), '\0');
  stream.seekg(0);
  if (size > 0 && !stream.read(bytes.data(), size)) return {{}, "cannot be read"};
  const std::string fault = FaultOfPictureBytes(bytes);
  if (!fault.empty()) return {{}, fault};
  StoredPicture picture = Decode(bytes);
  picture.orientation = ExifOrientation(bytes);
  return picture;
}

Result<std::string> EncodePictureFor(const std::string& path, const cv::Mat& picture, int jpeg_quality) {
  auto bytes = HasJpegEnding(path) ? EncodeJpeg(picture, jpeg_quality) : EncodePng(picture);
  if (!bytes) return Failure(path + ": " + bytes.error().message);
  return bytes;
}

int UsedBits(const cv::Mat& stored) {
  const int channels = stored.channels(), num_used = channels == 4 ? 3 : channels;
  unsigned all = 0;
  for (int y = 0; y < stored.rows; ++y) {
    const auto* row = stored.ptr<uint16_t>(y);
    for (int x = 0; x < stored.cols; ++x) {
      for (int k = 0; k < num_used; ++k) all |= row[x * channels + k];
    }
  }
  int bits = 8;
  while (all >> bits != 0) bits += 2;
  return bits;
}

Result<ColourAndGrey> ToColourAndGrey(const cv::Mat& stored, const std::string& path, std::optional<int> bits) {
  cv::Mat bytes = stored;
  if (stored.depth() == CV_16U) {
    const int used = bits ? *bits : UsedBits(stored);
    stored.convertTo(bytes, CV_8U, 255.0 / ((1 << used) - 1));
  }
  ColourAndGrey picture;
  if (bytes.type() == CV_8UC1) {
    picture.grey = bytes;
  } else if (bytes.type() == CV_8UC3 || bytes.type() == CV_8UC4) {
    if (bytes.channels() == 4) cv::cvtColor(bytes, picture.colour, cv::COLOR_BGRA2BGR);
    if (bytes.channels() == 3) picture.colour = bytes;
    cv::cvtColor(picture.colour, picture.grey, cv::COLOR_BGR2GRAY);
  } else {
    return BadInput(path + " is " + KindOf(stored) + "; colour pictures are 8-bit or 16-bit grey, RGB or RGBA");
  }
  return picture;
}

Status CheckDepth(const cv::Mat& stored, const cv::Size& colour_size, const std::string& path) {
  if (stored.type() != CV_16UC1 && stored.type() != CV_32FC1) {
    return BadInput(path + " is " + KindOf(stored) +
                    "; depth must be 16-bit with 1 channel, or 32-bit float metres: save it anew without conversion");
  }
  if (stored.size() != colour_size) {
    return BadInput(path + " is " + SizeText(stored.size()) + " and its colour picture " + SizeText(colour_size) +
                    "; depth must be registered to the colour picture and of its size");
  }
  return Status::Ok();
}

}  // namespace yorb
