// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "features/keypoint.h"

namespace yorb {

/// How many of the 256 bits differ. The room is compiled with -mpopcnt where the machine is an x86 (part of
/// x86-64-v2, the project's baseline), and so is whatever links it: four instructions a word, no table.
inline int HammingDistance(const Descriptor& a, const Descriptor& b) {
  return __builtin_popcountll(a[0] ^ b[0]) + __builtin_popcountll(a[1] ^ b[1]) + __builtin_popcountll(a[2] ^ b[2]) +
         __builtin_popcountll(a[3] ^ b[3]);
}

/// The distances from `query` to `count` rows, written to `distances`: for brute force over many rows. Uses the widest
/// instructions the processor has (VPOPCNTDQ, AVX2, popcnt); all give the same numbers.
void HammingDistances(const Descriptor& query, const Descriptor* rows, size_t count, uint16_t* distances);

/// The ways to do it, for tests and benchmarks.
namespace hamming {
using Path = void (*)(const Descriptor& query, const Descriptor* rows, size_t count, uint16_t* distances);

void Portable(const Descriptor& query, const Descriptor* rows, size_t count, uint16_t* distances);

/// Null where the processor or the build has no such instructions.
Path Avx2();
Path Avx512();
}  // namespace hamming

}  // namespace yorb
