// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/onnx_tensor.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <utility>

#include "core/text.h"
#include "detection/proto_reader.h"

namespace yorb {
namespace {

/// The fields of a TensorProto before its numbers are made of them.
struct RawTensor {
  OnnxTensor tensor;
  int64_t type = 0;
  bool is_external = false;
  std::string_view raw;
  std::vector<float> floats;
  std::vector<double> doubles;
  std::vector<int64_t> ints;
  std::map<std::string, std::string> external;
};

template <typename T>
bool Append(std::vector<T>& all, const std::optional<std::vector<T>>& more) {
  if (!more) return false;
  all.insert(all.end(), more->begin(), more->end());
  return true;
}

bool ReadExternalEntry(std::string_view message, RawTensor& raw) {
  ProtoReader reader(message);
  std::string key, value;
  while (const auto field = reader.Next()) {
    if (field->id == 1) key = std::string(field->bytes);
    if (field->id == 2) value = std::string(field->bytes);
  }
  raw.external[key] = value;
  return !reader.is_damaged();
}

std::optional<RawTensor> ReadFields(std::string_view message) {
  RawTensor raw;
  ProtoReader reader(message);
  bool is_fine = true;
  while (const auto field = reader.Next()) {
    switch (field->id) {
      case 1:
        is_fine &= Append(raw.tensor.dims, ProtoIntegers(*field));
        break;
      case 2:
        raw.type = field->AsInteger();
        break;
      case 4:
        is_fine &= Append(raw.floats, ProtoFloats(*field));
        break;
      case 5:
      case 7:
      case 11:
        is_fine &= Append(raw.ints, ProtoIntegers(*field));
        break;
      case 8:
        raw.tensor.name = std::string(field->bytes);
        break;
      case 9:
        raw.raw = field->bytes;
        break;
      case 10:
        is_fine &= Append(raw.doubles, ProtoDoubles(*field));
        break;
      case 13:
        is_fine &= ReadExternalEntry(field->bytes, raw);
        break;
      case 14:
        raw.is_external = field->AsInteger() == 1;
        break;
      default:
        break;
    }
  }
  if (reader.is_damaged() || !is_fine) return std::nullopt;
  return raw;
}

float FloatOfHalf(uint16_t half) {
  const uint32_t sign = static_cast<uint32_t>(half & 0x8000u) << 16;
  const uint32_t exponent = half >> 10 & 0x1fu, mantissa = half & 0x3ffu;
  uint32_t bits = sign;
  if (exponent == 0x1f) {
    bits |= 0x7f800000u | mantissa << 13;
  } else if (exponent != 0) {
    bits |= (exponent + 112) << 23 | mantissa << 13;
  } else {  // zero, or too small to have a leading one
    const float small = static_cast<float>(mantissa) * 0x1.0p-24f;
    return sign != 0 ? -small : small;
  }
  float value;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

template <typename From, typename To>
void Convert(std::string_view raw, std::vector<To>& to) {
  to.resize(raw.size() / sizeof(From));
  for (size_t i = 0; i < to.size(); ++i) {
    From value;
    std::memcpy(&value, raw.data() + i * sizeof(From), sizeof(From));
    to[i] = static_cast<To>(value);
  }
}

void ConvertHalves(std::string_view raw, float (*from_half)(uint16_t), std::vector<float>& to) {
  std::vector<uint16_t> halves;
  Convert<uint16_t>(raw, halves);
  to.clear();
  for (const uint16_t half : halves) to.push_back(from_half(half));
}

/// The upper half of a float.
float FloatOfBfloat(uint16_t upper) {
  const uint32_t bits = static_cast<uint32_t>(upper) << 16;
  float value;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

/// Texts, complex numbers and those of 8 or 4 bits are not.
bool IsRead(int64_t type) {
  return (type >= kOnnxFloat && type <= kOnnxUint64 && type != kOnnxText) || type == kOnnxBfloat16;
}

/// Numbers that stand in `raw_data`, or in another file.
void FromRaw(std::string_view raw, int64_t type, OnnxTensor& tensor) {
  switch (type) {
    case kOnnxFloat:
      Convert<float>(raw, tensor.floats);
      break;
    case kOnnxFloat16:
      ConvertHalves(raw, FloatOfHalf, tensor.floats);
      break;
    case kOnnxBfloat16:
      ConvertHalves(raw, FloatOfBfloat, tensor.floats);
      break;
    case kOnnxDouble:
      Convert<double>(raw, tensor.floats);
      break;
    case kOnnxUint8:
    case kOnnxBool:
      Convert<uint8_t>(raw, tensor.ints);
      break;
    case kOnnxInt8:
      Convert<int8_t>(raw, tensor.ints);
      break;
    case kOnnxUint16:
      Convert<uint16_t>(raw, tensor.ints);
      break;
    case kOnnxInt16:
      Convert<int16_t>(raw, tensor.ints);
      break;
    case kOnnxInt32:
      Convert<int32_t>(raw, tensor.ints);
      break;
    case kOnnxInt64:
    case kOnnxUint64:
      Convert<int64_t>(raw, tensor.ints);
      break;
    case kOnnxUint32:
      Convert<uint32_t>(raw, tensor.ints);
      break;
    default:
      break;
  }
}

/// Numbers that stand in fields of their type.
void FromFields(RawTensor& raw) {
  OnnxTensor& tensor = raw.tensor;
  if (tensor.is_whole) {
    tensor.ints = std::move(raw.ints);
  } else if (raw.type == kOnnxFloat16 || raw.type == kOnnxBfloat16) {
    const auto from_half = raw.type == kOnnxFloat16 ? FloatOfHalf : FloatOfBfloat;
    for (const int64_t bits : raw.ints) tensor.floats.push_back(from_half(static_cast<uint16_t>(bits)));
  } else if (raw.type == kOnnxDouble) {
    tensor.floats.assign(raw.doubles.begin(), raw.doubles.end());
  } else {
    tensor.floats = std::move(raw.floats);
  }
}

/// The bytes of weights that stand in a file beside the network's.
Result<std::string> ReadExternal(const RawTensor& raw, const std::string& folder) {
  namespace fs = std::filesystem;
  const auto entry = [&](const char* key) {
    const auto found = raw.external.find(key);
    return found == raw.external.end() ? std::string() : found->second;
  };
  const std::string location = entry("location");
  const fs::path name = fs::path(location).lexically_normal();
  if (location.empty() || name.is_absolute() || *name.begin() == "..")
    return BadInput("keeps weights in '" + location + "', which is no file beside it");
  const std::string path = (fs::path(folder) / name).string();
  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  if (!stream) {
    return BadInput("keeps its weights in " + path +
                    ", which is not there; put it beside the network, or export again " + "as one file");
  }
  const auto size = static_cast<int64_t>(stream.tellg());
  const int64_t offset = ParseInteger(entry("offset")).value_or(0);
  const int64_t length = ParseInteger(entry("length")).value_or(size - offset);
  if (offset < 0 || length < 0 || offset > size || length > size - offset)
    return BadInput("keeps its weights in " + path + ", which is too short; export again as one file");
  std::string bytes(static_cast<size_t>(length), '\0');
  stream.seekg(offset);
  if (length > 0 && !stream.read(bytes.data(), length))
    return BadInput("keeps its weights in " + path + ", which cannot be read");
  return bytes;
}

/// How many numbers the dimensions make; nothing where they cannot be.
std::optional<size_t> CountOf(const std::vector<int64_t>& dims) {
  constexpr int64_t kMost = int64_t{1} << 31;
  int64_t count = 1;
  for (const int64_t dim : dims) {
    if (dim < 0 || (dim > 0 && count > kMost / dim)) return std::nullopt;
    count *= dim;
  }
  return static_cast<size_t>(count);
}

}  // namespace

Result<OnnxTensor> ParseOnnxTensor(std::string_view message, const std::string& folder) {
  auto raw = ReadFields(message);
  if (!raw) return DamagedProto();
  const auto count = CountOf(raw->tensor.dims);
  if (!count) return DamagedProto();
  if (!IsRead(raw->type))
    return BadInput("holds numbers of a type that is not read (" + std::to_string(raw->type) +
                    " of ONNX); export it with weights of 32 or 16 bits");
  raw->tensor.is_whole = !IsFloatType(raw->type);
  raw->tensor.type = static_cast<int>(raw->type);
  if (raw->is_external) {
    const auto bytes = ReadExternal(*raw, folder);
    if (!bytes) return bytes.error();
    FromRaw(*bytes, raw->type, raw->tensor);
  } else if (!raw->raw.empty()) {
    FromRaw(raw->raw, raw->type, raw->tensor);
  } else {
    FromFields(*raw);
  }
  if (raw->tensor.size() != *count) return DamagedProto();
  return std::move(raw->tensor);
}

}  // namespace yorb
