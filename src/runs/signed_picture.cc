// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/signed_picture.h"

#include <zlib.h>

#include <cstdint>
#include <string_view>

#include "core/text.h"
#include "places/digest.h"

namespace yorb {
namespace {

constexpr std::string_view kPng = "\x89PNG", kJpeg = "\xff\xd8";
constexpr size_t kPngEnd = 12;  // bytes of its last chunk, IEND

std::string BigEndian(uint32_t number, size_t size) {
  std::string bytes;
  for (size_t i = 0; i < size; ++i) bytes += static_cast<char>(number >> 8 * (size - 1 - i));
  return bytes;
}

/// The checksum of PNG's chunks.
uint32_t Crc(std::string_view bytes) {
  return static_cast<uint32_t>(crc32_z(0, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

bool IsPng(std::string_view file) { return file.substr(0, kPng.size()) == kPng && file.size() >= kPngEnd; }

bool IsJpeg(std::string_view file) { return file.substr(0, kJpeg.size()) == kJpeg && file.size() >= 6; }

/// The line as a segment or chunk of the format; empty where there is none for it. Its size does not depend on what is
/// signed.
std::string Signature(const std::string& file, const std::string& source) {
  Digest digest;
  digest.Add(source.data(), source.size());
  digest.Add(file.data(), file.size());
  const std::string line = "yorb detect " + HexText(digest.value());
  if (IsJpeg(file)) return "\xff\xfe" + BigEndian(static_cast<uint32_t>(line.size() + 2), 2) + line;
  if (!IsPng(file)) return "";
  const std::string content = "Software" + std::string(1, '\0') + line, chunk = "tEXt" + content;
  return BigEndian(static_cast<uint32_t>(content.size()), 4) + chunk + BigEndian(Crc(chunk), 4);
}

/// Where the line stands in a file that has `signature_size` bytes of it already: in a JPEG behind its first segment,
/// in a PNG before its last chunk.
size_t PlaceIn(std::string_view file, size_t signature_size) {
  if (IsPng(file)) return file.size() < kPngEnd + signature_size ? 0 : file.size() - kPngEnd - signature_size;
  const auto byte = [&](size_t at) { return static_cast<size_t>(static_cast<unsigned char>(file[at])); };
  return IsJpeg(file) ? 4 + (byte(4) << 8 | byte(5)) : 0;
}

}  // namespace

std::string SignedPicture(const std::string& file, const std::string& source) {
  const size_t place = PlaceIn(file, 0);
  if (place > file.size()) return file;
  return file.substr(0, place) + Signature(file, source) + file.substr(place);
}

bool IsSignedPicture(const std::string& file, const std::string& source) {
  const size_t size = Signature(file, source).size(), place = PlaceIn(file, size);
  if (size == 0 || place + size > file.size()) return false;
  const std::string unsigned_file = file.substr(0, place) + file.substr(place + size);
  return SignedPicture(unsigned_file, source) == file;
}

}  // namespace yorb
