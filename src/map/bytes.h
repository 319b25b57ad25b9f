// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace yorb {

/// Numbers in a row of bytes, the least significant byte first on every machine.
namespace little_endian {

#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
constexpr bool kIsNative = true;
#else
constexpr bool kIsNative = false;
#endif

/// Copies `count` numbers between memory and a file's bytes.
template <typename T>
void Copy(const void* from, size_t count, void* to) {
  static_assert(std::is_arithmetic_v<T>, "numbers only");
  if (count == 0) return;
  std::memcpy(to, from, count * sizeof(T));
  if (kIsNative) return;
  auto* bytes = static_cast<unsigned char*>(to);
  for (size_t i = 0; i < count; ++i, bytes += sizeof(T)) std::reverse(bytes, bytes + sizeof(T));
}

}  // namespace little_endian

/// Puts numbers and texts one after the other.
class ByteWriter {
 public:
  template <typename T>
  void Put(T value) {
    PutRow(&value, 1);
  }

  /// The numbers alone; how many there are the reader must know.
  template <typename T>
  void PutRow(const T* first, size_t count) {
    const size_t size = bytes_.size();
    bytes_.resize(size + count * sizeof(T));
    little_endian::Copy<T>(first, count, bytes_.data() + size);
  }

  void PutText(std::string_view text) {
    Put(static_cast<uint32_t>(text.size()));
    PutRow(text.data(), text.size());
  }

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Takes them out again. Bytes that are not there read as zeros, and `ok` is false from then on; nothing is allocated
/// that the bytes which are left could not fill.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : left_(bytes) {}

  template <typename T>
  T Get() {
    T value{};
    TakeRow(&value, 1);
    return value;
  }

  template <typename T>
  std::vector<T> GetRow(size_t count) {
    std::vector<T> row(Fits(count, sizeof(T)) ? count : 0);
    TakeRow(row.data(), row.size());
    return row;
  }

  /// Into memory that is there: `count` numbers.
  template <typename T>
  void TakeRow(T* first, size_t count) {
    if (!Fits(count, sizeof(T))) return;
    little_endian::Copy<T>(left_.data(), count, first);
    left_.remove_prefix(count * sizeof(T));
  }

  std::string GetText() {
    const auto count = Get<uint32_t>();
    if (!Fits(count, 1)) return {};
    std::string text(left_.substr(0, count));
    left_.remove_prefix(count);
    return text;
  }

  /// A number of rows that follow, of `row_bytes` at least each.
  size_t GetCount(size_t row_bytes) {
    const auto count = Get<uint32_t>();
    return Fits(count, row_bytes) ? count : 0;
  }

  bool ok() const { return ok_; }

  /// Whether all that was asked for was there, and nothing is left.
  bool IsReadWhole() const { return ok_ && left_.empty(); }

 private:
  bool Fits(size_t count, size_t bytes_each) {
    if (count > left_.size() / bytes_each) ok_ = false;
    return ok_;
  }

  std::string_view left_;
  bool ok_ = true;
};

}  // namespace yorb
