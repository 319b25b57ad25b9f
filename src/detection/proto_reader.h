// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace yorb {

/// One field of a protocol buffer message, as the wire has it.
struct ProtoField {
  enum class Kind { kVarint, kFixed32, kFixed64, kBytes };
  uint32_t id = 0;
  Kind kind = Kind::kVarint;
  uint64_t bits = 0;       ///< of a number
  std::string_view bytes;  ///< of a text, a message or a packed list

  float AsFloat() const;
  int64_t AsInteger() const { return static_cast<int64_t>(bits); }
};

/// Walks over the fields of one message. ONNX files need no more of protocol buffers than this, and every length is
/// compared with what is left of the file.
class ProtoReader {
 public:
  explicit ProtoReader(std::string_view message) : rest_(message) {}

  /// The next field; nothing at the end, and where the bytes are no message.
  std::optional<ProtoField> Next();

  /// Whether the end came too early, or something stood there that is no field.
  bool is_damaged() const { return is_damaged_; }

 private:
  std::optional<uint64_t> Varint();
  std::optional<std::string_view> Take(uint64_t count);

  std::string_view rest_;
  bool is_damaged_ = false;
};

/// What is said of a file whose messages end too early.
Error DamagedProto();

/// The numbers of a repeated field: a packed list, or the one number of an unpacked entry.
std::optional<std::vector<int64_t>> ProtoIntegers(const ProtoField& field);
std::optional<std::vector<float>> ProtoFloats(const ProtoField& field);
std::optional<std::vector<double>> ProtoDoubles(const ProtoField& field);

}  // namespace yorb
