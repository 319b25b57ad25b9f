// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace yorb {

/// A 64-bit sum over bytes that tells contents apart and finds damage: every step is one to one, so that a change in
/// one word is always seen. Not meant against forgery.
class Digest {
 public:
  void Add(uint64_t word) {
    value_ = (value_ ^ word) * 0x9e3779b97f4a7c15ull;
    value_ ^= value_ >> 29;
  }

  /// Bytes, by eights; what is missing to the last eight counts as zeros, and their number is added, too.
  void Add(const void* bytes, size_t size) {
    const auto* next = static_cast<const unsigned char*>(bytes);
    for (size_t left = size; left > 0;) {
      uint64_t word = 0;
      const size_t taken = left < sizeof word ? left : sizeof word;
      std::memcpy(&word, next, taken);
      Add(word);
      next += taken;
      left -= taken;
    }
    Add(static_cast<uint64_t>(size));
  }

  uint64_t value() const { return value_; }

 private:
  uint64_t value_ = 0xcbf29ce484222325ull;
};

}  // namespace yorb
