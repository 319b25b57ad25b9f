// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace yorb {

/// Which processor instructions a stage uses. Results are equal to the bit.
enum class Instructions { kPortable, kAvx2 };

/// The widest that this processor and this build have.
inline Instructions BestInstructions() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") ? Instructions::kAvx2 : Instructions::kPortable;
#else
  return Instructions::kPortable;
#endif
}

}  // namespace yorb
