// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/proto_reader.h"

#include <cstring>

namespace yorb {
namespace {

/// A number as little-endian machines keep it.
template <typename T>
T FromBytes(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

template <typename T>
std::optional<std::vector<T>> Unpacked(const ProtoField& field, ProtoField::Kind single) {
  if (field.kind == single) return std::vector<T>{FromBytes<T>(reinterpret_cast<const char*>(&field.bits))};
  if (field.kind != ProtoField::Kind::kBytes || field.bytes.size() % sizeof(T) != 0) return std::nullopt;
  std::vector<T> values(field.bytes.size() / sizeof(T));
  if (!values.empty()) std::memcpy(values.data(), field.bytes.data(), field.bytes.size());
  return values;
}

}  // namespace

Error DamagedProto() { return BadInput("is damaged or cut short"); }

float ProtoField::AsFloat() const { return FromBytes<float>(reinterpret_cast<const char*>(&bits)); }

std::optional<uint64_t> ProtoReader::Varint() {
  constexpr int kMostBytes = 10;
  uint64_t value = 0;
  for (int i = 0; i < kMostBytes && !rest_.empty(); ++i) {
    const auto byte = static_cast<unsigned char>(rest_.front());
    rest_.remove_prefix(1);
    value |= static_cast<uint64_t>(byte & 0x7f) << (7 * i);
    if (byte < 0x80) return value;
  }
  return std::nullopt;
}

std::optional<std::string_view> ProtoReader::Take(uint64_t count) {
  if (count > rest_.size()) return std::nullopt;
  const std::string_view taken = rest_.substr(0, count);
  rest_.remove_prefix(count);
  return taken;
}

std::optional<ProtoField> ProtoReader::Next() {
  if (rest_.empty() || is_damaged_) return std::nullopt;
  is_damaged_ = true;  // until the field turns out to be whole
  const auto key = Varint();
  if (!key || *key >> 3 == 0 || *key >> 32 != 0) return std::nullopt;
  ProtoField field;
  field.id = static_cast<uint32_t>(*key >> 3);
  const auto fixed = [&](ProtoField::Kind kind, size_t size) {
    field.kind = kind;
    const auto bytes = Take(size);
    if (bytes) std::memcpy(&field.bits, bytes->data(), size);
    return bytes.has_value();
  };
  bool is_whole = false;
  switch (*key & 7) {
    case 0: {
      const auto value = Varint();
      field.bits = value.value_or(0);
      is_whole = value.has_value();
      break;
    }
    case 1:
      is_whole = fixed(ProtoField::Kind::kFixed64, sizeof(uint64_t));
      break;
    case 2: {
      field.kind = ProtoField::Kind::kBytes;
      const auto length = Varint();
      const auto bytes = length ? Take(*length) : std::nullopt;
      field.bytes = bytes.value_or(std::string_view());
      is_whole = bytes.has_value();
      break;
    }
    case 5:
      is_whole = fixed(ProtoField::Kind::kFixed32, sizeof(uint32_t));
      break;
    default:
      break;
  }
  if (!is_whole) return std::nullopt;
  is_damaged_ = false;
  return field;
}

std::optional<std::vector<int64_t>> ProtoIntegers(const ProtoField& field) {
  if (field.kind == ProtoField::Kind::kVarint) return std::vector<int64_t>{field.AsInteger()};
  if (field.kind != ProtoField::Kind::kBytes) return std::nullopt;
  std::vector<int64_t> values;
  std::string_view rest = field.bytes;
  while (!rest.empty()) {
    uint64_t value = 0;
    size_t length = 0;
    for (bool is_last = false; !is_last; ++length) {
      if (length == 10 || length == rest.size()) return std::nullopt;
      const auto byte = static_cast<unsigned char>(rest[length]);
      value |= static_cast<uint64_t>(byte & 0x7f) << (7 * length);
      is_last = byte < 0x80;
    }
    rest.remove_prefix(length);
    values.push_back(static_cast<int64_t>(value));
  }
  return values;
}

std::optional<std::vector<float>> ProtoFloats(const ProtoField& field) {
  return Unpacked<float>(field, ProtoField::Kind::kFixed32);
}

std::optional<std::vector<double>> ProtoDoubles(const ProtoField& field) {
  return Unpacked<double>(field, ProtoField::Kind::kFixed64);
}

}  // namespace yorb
