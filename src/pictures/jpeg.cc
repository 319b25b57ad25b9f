// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/jpeg.h"

#include <jerror.h>
#include <jpeglib.h>

#include <csetjmp>
#include <cstdlib>

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

/// The same for encoding.
struct Encoding {
  jpeg_error_mgr errors{};
  std::jmp_buf leave{};
  jpeg_compress_struct info{};
  unsigned char* bytes = nullptr;  // of the library's making
  unsigned long size = 0;

  ~Encoding() {
    jpeg_destroy_compress(&info);
    std::free(bytes);
  }
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
[[noreturn]] void LeaveEncoding(j_common_ptr info) { std::longjmp(reinterpret_cast<Encoding*>(info->err)->leave, 1); }
}

bool IsCommon(const jpeg_decompress_struct& info) {
  const bool is_grey = info.num_components == 1, is_colour = info.num_components == 3;
  return (is_grey || is_colour) && info.data_precision == 8 &&
         static_cast<double>(info.image_width) * info.image_height < kMostPixels;
}

/// The part that the library may leave by a jump: nothing in it may need a destructor.
DecodedPicture::Kind DecodeInto(const std::string& bytes, Decoding& decoding, cv::Mat& pixels) {
  jpeg_decompress_struct& info = decoding.info;
  if (setjmp(decoding.leave) != 0) return DecodedPicture::Kind::kDamaged;
  jpeg_create_decompress(&info);
  jpeg_mem_src(&info, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&info, TRUE);
  if (!IsCommon(info)) return DecodedPicture::Kind::kUncommon;
  const bool is_grey = info.num_components == 1;
  info.out_color_space = is_grey ? JCS_GRAYSCALE : JCS_EXT_BGR;
  pixels.create(static_cast<int>(info.image_height), static_cast<int>(info.image_width), is_grey ? CV_8UC1 : CV_8UC3);
  jpeg_start_decompress(&info);
  while (info.output_scanline < info.output_height && !decoding.is_damaged) {
    JSAMPROW row = pixels.ptr(static_cast<int>(info.output_scanline));
    jpeg_read_scanlines(&info, &row, 1);
  }
  if (decoding.is_damaged) return DecodedPicture::Kind::kDamaged;
  jpeg_finish_decompress(&info);
  return decoding.is_damaged ? DecodedPicture::Kind::kDamaged : DecodedPicture::Kind::kWhole;
}

/// As above.
bool EncodeInto(const cv::Mat& picture, int quality, Encoding& encoding) {
  jpeg_compress_struct& info = encoding.info;
  if (setjmp(encoding.leave) != 0) {
    encoding.bytes = nullptr;  // where the memory ran out, the library may have freed it
    return false;
  }
  jpeg_create_compress(&info);
  jpeg_mem_dest(&info, &encoding.bytes, &encoding.size);
  info.image_width = static_cast<JDIMENSION>(picture.cols);
  info.image_height = static_cast<JDIMENSION>(picture.rows);
  info.input_components = picture.channels();
  info.in_color_space = picture.channels() == 1 ? JCS_GRAYSCALE : JCS_EXT_BGR;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, quality, TRUE);
  jpeg_start_compress(&info, TRUE);
  for (int y = 0; y < picture.rows; ++y) {
    JSAMPROW row = const_cast<unsigned char*>(picture.ptr(y));
    jpeg_write_scanlines(&info, &row, 1);
  }
  jpeg_finish_compress(&info);
  return true;
}

}  // namespace

DecodedPicture DecodeJpeg(const std::string& bytes) {
  Decoding decoding;
  decoding.info.err = jpeg_std_error(&decoding.errors);
  decoding.errors.emit_message = NoteJpegMessage;
  decoding.errors.output_message = SayNothingOfJpeg;
  decoding.errors.error_exit = LeaveJpeg;
  DecodedPicture picture;
  picture.kind = DecodeInto(bytes, decoding, picture.pixels);
  if (picture.kind != DecodedPicture::Kind::kWhole) picture.pixels.release();
  return picture;
}

Result<std::string> EncodeJpeg(const cv::Mat& picture, int quality) {
  Encoding encoding;
  encoding.info.err = jpeg_std_error(&encoding.errors);
  encoding.errors.output_message = SayNothingOfJpeg;
  encoding.errors.error_exit = LeaveEncoding;
  const bool is_of_jpeg = picture.type() == CV_8UC1 || picture.type() == CV_8UC3;
  if (!is_of_jpeg || !EncodeInto(picture, quality, encoding)) return Failure("the picture cannot be encoded as JPEG");
  return std::string(reinterpret_cast<const char*>(encoding.bytes), encoding.size);
}

}  // namespace yorb
