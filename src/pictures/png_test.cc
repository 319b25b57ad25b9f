// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/png.h"

#include <gtest/gtest.h>
#include <png.h>

#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "pictures/test_folder.h"

namespace yorb {
namespace {

using Kind = DecodedPicture::Kind;

std::string BytesOf(const std::vector<unsigned char>& bytes) { return {bytes.begin(), bytes.end()}; }

cv::Mat OpenCvReads(const std::string& bytes) {
  return cv::imdecode(std::vector<unsigned char>(bytes.begin(), bytes.end()), cv::IMREAD_UNCHANGED);
}

void ExpectSame(const cv::Mat& ours, const cv::Mat& theirs) {
  ASSERT_EQ(ours.type(), theirs.type());
  ASSERT_EQ(ours.size(), theirs.size());
  EXPECT_EQ(cv::norm(ours, theirs, cv::NORM_INF), 0);
}

/// A PNG of any kind, as libpng writes it: rows of random bytes.
struct Form {
  int kind, bits, interlace = PNG_INTERLACE_NONE;
  bool has_transparent = false;
};

std::string Written(const Form& form) {
  constexpr png_uint_32 kWidth = 21, kHeight = 13;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  std::string bytes;
  png_set_write_fn(
      png, &bytes,
      [](png_structp to, png_bytep data, size_t size) {
        static_cast<std::string*>(png_get_io_ptr(to))->append(reinterpret_cast<const char*>(data), size);
      },
      [](png_structp) {});
  png_set_IHDR(png, info, kWidth, kHeight, form.bits, form.kind, form.interlace, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  std::vector<png_color> palette(size_t{1} << std::min(form.bits, 8));
  for (size_t i = 0; i < palette.size(); ++i)
    palette[i] = {static_cast<png_byte>(i * 7), static_cast<png_byte>(255 - i), static_cast<png_byte>(i * 3 + 1)};
  png_byte transparent[] = {0, 128};
  png_color_16 transparent_colour{0, 12, 34, 56, 0};
  if (form.kind == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
  if (form.has_transparent && form.kind == PNG_COLOR_TYPE_PALETTE) png_set_tRNS(png, info, transparent, 2, nullptr);
  if (form.has_transparent && form.kind == PNG_COLOR_TYPE_RGB) png_set_tRNS(png, info, nullptr, 0, &transparent_colour);
  png_write_info(png, info);
  cv::Mat rows(kHeight, 8 * kWidth, CV_8UC1);
  cv::RNG(7).fill(rows, cv::RNG::UNIFORM, 0, 256);
  const int num_passes = png_set_interlace_handling(png);
  for (int pass = 0; pass < num_passes; ++pass) {
    for (int y = 0; y < rows.rows; ++y) png_write_row(png, rows.ptr(y));
  }
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

TEST(Png, EveryKindIsTheBitsThatOpenCvGives) {
  const Form forms[] = {
      {PNG_COLOR_TYPE_GRAY, 1},
      {PNG_COLOR_TYPE_GRAY, 2},
      {PNG_COLOR_TYPE_GRAY, 4},
      {PNG_COLOR_TYPE_GRAY, 8},
      {PNG_COLOR_TYPE_GRAY, 16},
      {PNG_COLOR_TYPE_GRAY, 16, PNG_INTERLACE_ADAM7},
      {PNG_COLOR_TYPE_GRAY_ALPHA, 8},
      {PNG_COLOR_TYPE_GRAY_ALPHA, 16},
      {PNG_COLOR_TYPE_RGB, 8},
      {PNG_COLOR_TYPE_RGB, 16},
      {PNG_COLOR_TYPE_RGB, 8, PNG_INTERLACE_ADAM7},
      {PNG_COLOR_TYPE_RGB_ALPHA, 8},
      {PNG_COLOR_TYPE_RGB_ALPHA, 16},
      {PNG_COLOR_TYPE_PALETTE, 1},
      {PNG_COLOR_TYPE_PALETTE, 4},
      {PNG_COLOR_TYPE_PALETTE, 8},
      {PNG_COLOR_TYPE_PALETTE, 8, PNG_INTERLACE_NONE, true},
      {PNG_COLOR_TYPE_RGB, 8, PNG_INTERLACE_NONE, true},
      {PNG_COLOR_TYPE_RGB, 16, PNG_INTERLACE_NONE, true},
  };
  for (const Form& form : forms) {
    SCOPED_TRACE("kind " + std::to_string(form.kind) + ", " + std::to_string(form.bits) + " bits");
    const std::string bytes = Written(form);
    const DecodedPicture ours = DecodePng(bytes);
    ASSERT_EQ(ours.kind, Kind::kWhole);
    ExpectSame(ours.pixels, OpenCvReads(bytes));
  }
}

TEST(Png, WhatWeWriteComesBack) {
  for (const int type : {CV_8UC1, CV_8UC3, CV_8UC4, CV_16UC1, CV_16UC3}) {
    cv::Mat whole(30, 40, type);
    cv::RNG(3).fill(whole, cv::RNG::UNIFORM, 0, CV_MAT_DEPTH(type) == CV_8U ? 256 : 65536);
    const cv::Mat part = whole(cv::Rect(3, 4, 17, 11));  // its rows do not follow one another in memory
    for (const cv::Mat& picture : {whole, part}) {
      const auto bytes = EncodePng(picture);
      ASSERT_TRUE(bytes) << type;
      ExpectSame(DecodePng(*bytes).pixels, picture);
      ExpectSame(OpenCvReads(*bytes), picture);
    }
  }
  for (const cv::Mat& picture : {cv::Mat(4, 4, CV_32FC1), cv::Mat(4, 4, CV_8UC2), cv::Mat()})
    EXPECT_FALSE(EncodePng(picture));
}

TEST(Png, AnyByteThatIsWrongIsDamageOrOutsideOfThePicture) {
  std::vector<unsigned char> written;
  ASSERT_TRUE(cv::imencode(".png", TestColour(1, 20, 15), written));
  const std::string whole = BytesOf(written);
  const cv::Mat picture = DecodePng(whole).pixels;
  size_t num_damaged = 0;
  for (size_t at = 8; at < whole.size(); ++at) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x55);
    const DecodedPicture read = DecodePng(bytes);
    EXPECT_EQ(read.pixels.empty(), read.kind != Kind::kWhole) << at;
    if (read.kind == Kind::kWhole) ExpectSame(read.pixels, picture);
    num_damaged += read.kind == Kind::kDamaged;
  }
  EXPECT_GT(num_damaged, whole.size() * 9 / 10);
  for (size_t size = 0; size < whole.size() - 12; ++size)
    EXPECT_EQ(DecodePng(whole.substr(0, size)).kind, Kind::kDamaged) << size;
}

}  // namespace
}  // namespace yorb
