// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#if defined(__x86_64__) && defined(__GNUC__)
/// Marks a function that may use AVX2 and FMA intrinsics, whatever the rest of the build targets. Each helper needs the
/// mark; lambdas do not inherit it.
#define YORB_AVX2 __attribute__((target("avx2,fma")))
#endif

namespace yorb {

/// Which processor instructions a stage uses. Results are equal to the bit.
enum class Instructions { kPortable, kAvx2 };

/// The widest that this processor and this build have.
inline Instructions BestInstructions() {
#if defined(YORB_AVX2)
  const bool can = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return can ? Instructions::kAvx2 : Instructions::kPortable;
#else
  return Instructions::kPortable;
#endif
}

}  // namespace yorb
