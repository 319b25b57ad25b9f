// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace yorb {

/// Says on standard error which promise of ours is broken and where, and aborts. Use YORB_CHECK.
[[noreturn]] void CheckFailed(const char* condition, const char* message, const char* file, int line);

}  // namespace yorb

/// Stops the program in every build type when an invariant of ours is broken. Never for bad input: that is a Result.
#define YORB_CHECK(condition, message) \
  ((condition) ? static_cast<void>(0) : ::yorb::CheckFailed(#condition, (message), __FILE__, __LINE__))
