// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/png.h"

#include <png.h>

#include <csetjmp>
#include <cstring>

namespace yorb {
namespace {

extern "C" {
[[noreturn]] void LeavePng(png_structp png, png_const_charp) { png_longjmp(png, 1); }
void SayNothingOfPng(png_structp, png_const_charp) {}
}

/// Bytes in memory, from which the library takes what it asks for.
struct Source {
  const std::string& bytes;
  size_t at = 0;
};

extern "C" {
void TakeBytes(png_structp png, png_bytep data, size_t size) {
  Source& source = *static_cast<Source*>(png_get_io_ptr(png));
  if (size > source.bytes.size() - source.at) png_error(png, "the end");
  std::memcpy(data, source.bytes.data() + source.at, size);
  source.at += size;
}
void AppendBytes(png_structp png, png_bytep data, size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}
void FlushNothing(png_structp) {}
}

/// One decoding or encoding of the library's, which leaves by a jump where something is wrong.
class Png {
 public:
  enum class Way { kRead, kWrite };

  explicit Png(Way way) : way_(way) {
    png = way == Way::kRead ? png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, LeavePng, SayNothingOfPng)
                            : png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, LeavePng, SayNothingOfPng);
    if (png != nullptr) info = png_create_info_struct(png);
  }
  ~Png() { way_ == Way::kRead ? png_destroy_read_struct(&png, &info, nullptr) : png_destroy_write_struct(&png, &info); }
  Png(const Png&) = delete;
  Png& operator=(const Png&) = delete;

  png_structp png = nullptr;
  png_infop info = nullptr;

 private:
  Way way_;
};

/// Asks the library for rows as OpenCV lays them out, and says of what type they are.
int AskForRows(png_structp png, png_infop info) {
  const int kind = png_get_color_type(png, info), bits = png_get_bit_depth(png, info);
  const bool is_palette = kind == PNG_COLOR_TYPE_PALETTE, is_colour = (kind & PNG_COLOR_MASK_COLOR) != 0;
  const bool has_transparent = is_colour && png_get_valid(png, info, PNG_INFO_tRNS) != 0;
  const bool has_alpha = (kind & PNG_COLOR_MASK_ALPHA) != 0 || has_transparent;
  if (is_palette) png_set_palette_to_rgb(png);
  if (has_transparent) png_set_tRNS_to_alpha(png);
  if (!is_colour && bits < 8) png_set_expand_gray_1_2_4_to_8(png);
  if (!is_colour && has_alpha) png_set_gray_to_rgb(png);
  if (is_colour) png_set_bgr(png);
  if (bits == 16) png_set_swap(png);  // the file has the high byte first
  return CV_MAKETYPE(bits == 16 ? CV_16U : CV_8U, has_alpha ? 4 : is_colour ? 3 : 1);
}

/// The part that the library may leave by a jump: nothing in it may need a destructor.
DecodedPicture::Kind DecodeInto(png_structp png, png_infop info, Source& source, cv::Mat& pixels) {
  if (setjmp(png_jmpbuf(png)) != 0) return DecodedPicture::Kind::kDamaged;
  png_set_read_fn(png, &source, TakeBytes);
  png_read_info(png, info);
  const png_uint_32 width = png_get_image_width(png, info), height = png_get_image_height(png, info);
  if (static_cast<double>(width) * height >= kMostPixels) return DecodedPicture::Kind::kUncommon;
  const int type = AskForRows(png, info);
  const int num_passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  pixels.create(static_cast<int>(height), static_cast<int>(width), type);
  for (int pass = 0; pass < num_passes; ++pass) {
    for (int y = 0; y < pixels.rows; ++y) png_read_row(png, pixels.ptr(y), nullptr);
  }
  png_read_end(png, nullptr);
  return DecodedPicture::Kind::kWhole;
}

int KindOf(int num_channels) {
  return num_channels == 1 ? PNG_COLOR_TYPE_GRAY : num_channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA;
}

/// As above.
bool EncodeInto(png_structp png, png_infop info, const cv::Mat& picture, std::string& bytes) {
  constexpr int kQuick = 1;
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_write_fn(png, &bytes, AppendBytes, FlushNothing);
  png_set_compression_level(png, kQuick);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
  png_set_IHDR(png, info, static_cast<png_uint_32>(picture.cols), static_cast<png_uint_32>(picture.rows),
               picture.depth() == CV_16U ? 16 : 8, KindOf(picture.channels()), PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  png_set_bgr(png);
  if (picture.depth() == CV_16U) png_set_swap(png);
  for (int y = 0; y < picture.rows; ++y) png_write_row(png, picture.ptr(y));
  png_write_end(png, nullptr);
  return true;
}

}  // namespace

DecodedPicture DecodePng(const std::string& bytes) {
  const Png reading(Png::Way::kRead);
  DecodedPicture picture{DecodedPicture::Kind::kDamaged, {}};
  Source source{bytes};
  if (reading.info != nullptr) picture.kind = DecodeInto(reading.png, reading.info, source, picture.pixels);
  if (picture.kind != DecodedPicture::Kind::kWhole) picture.pixels.release();
  return picture;
}

Result<std::string> EncodePng(const cv::Mat& picture) {
  const int channels = picture.channels();
  const bool is_of_png = (picture.depth() == CV_8U || picture.depth() == CV_16U) && channels != 2 && channels <= 4;
  const Png writing(Png::Way::kWrite);
  std::string bytes;
  if (!is_of_png || writing.info == nullptr || !EncodeInto(writing.png, writing.info, picture, bytes))
    return Failure("the picture cannot be encoded as PNG");
  return bytes;
}

}  // namespace yorb
