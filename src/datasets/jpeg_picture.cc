// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/jpeg_picture.h"

#include <jerror.h>
#include <jpeglib.h>

#include <csetjmp>

namespace yorb {
namespace {

/// One decoding, and what the library said of it. The library's handlers find it behind its error manager.
struct Decoding {
  jpeg_error_mgr errors{};  // first: the library knows this address alone
  std::jmp_buf leave{};
  jpeg_decompress_struct info{};
  bool is_damaged = false;

  ~Decoding() { jpeg_destroy_decompress(&info); }
};

Decoding& Of(j_common_ptr info) { return *reinterpret_cast<Decoding*>(info->err); }

bool IsDamage(const jpeg_error_mgr& errors) {
  constexpr int kStrayBytes = 32;
  switch (errors.msg_code) {
    case JWRN_EXTRANEOUS_DATA:
      return errors.msg_parm.i[0] > kStrayBytes;
    case JWRN_BOGUS_PROGRESSION:
    case JWRN_HIT_MARKER:
    case JWRN_HUFF_BAD_CODE:
    case JWRN_JPEG_EOF:
    case JWRN_MUST_RESYNC:
      return true;
    default:
      return false;
  }
}

extern "C" {
void NoteJpegMessage(j_common_ptr info, int level) {
  if (level < 0 && IsDamage(*info->err)) Of(info).is_damaged = true;
}
void SayNothingOfJpeg(j_common_ptr) {}
[[noreturn]] void LeaveJpeg(j_common_ptr info) { std::longjmp(Of(info).leave, 1); }
}

bool IsCommon(const jpeg_decompress_struct& info) {
  constexpr double kMostPixels = 1 << 28;
  const bool is_grey = info.num_components == 1, is_colour = info.num_components == 3;
  return (is_grey || is_colour) && info.data_precision == 8 &&
         static_cast<double>(info.image_width) * info.image_height < kMostPixels;
}

/// The part that the library may leave by a jump: nothing in it may need a destructor.
JpegPicture::Kind DecodeInto(const std::string& bytes, Decoding& decoding, cv::Mat& pixels) {
  jpeg_decompress_struct& info = decoding.info;
  if (setjmp(decoding.leave) != 0) return JpegPicture::Kind::kDamaged;
  jpeg_create_decompress(&info);
  jpeg_mem_src(&info, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&info, TRUE);
  if (!IsCommon(info)) return JpegPicture::Kind::kUncommon;
  const bool is_grey = info.num_components == 1;
  info.out_color_space = is_grey ? JCS_GRAYSCALE : JCS_EXT_BGR;
  pixels.create(static_cast<int>(info.image_height), static_cast<int>(info.image_width), is_grey ? CV_8UC1 : CV_8UC3);
  jpeg_start_decompress(&info);
  while (info.output_scanline < info.output_height && !decoding.is_damaged) {
    JSAMPROW row = pixels.ptr(static_cast<int>(info.output_scanline));
    jpeg_read_scanlines(&info, &row, 1);
  }
  if (decoding.is_damaged) return JpegPicture::Kind::kDamaged;
  jpeg_finish_decompress(&info);
  return decoding.is_damaged ? JpegPicture::Kind::kDamaged : JpegPicture::Kind::kWhole;
}

}  // namespace

JpegPicture DecodeJpeg(const std::string& bytes) {
  Decoding decoding;
  decoding.info.err = jpeg_std_error(&decoding.errors);
  decoding.errors.emit_message = NoteJpegMessage;
  decoding.errors.output_message = SayNothingOfJpeg;
  decoding.errors.error_exit = LeaveJpeg;
  JpegPicture picture;
  picture.kind = DecodeInto(bytes, decoding, picture.pixels);
  if (picture.kind != JpegPicture::Kind::kWhole) picture.pixels.release();
  return picture;
}

}  // namespace yorb
