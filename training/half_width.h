// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace yorb {

/// Whether libtorch convolves in bfloat16 on the CPU in this thread ("autocast").
bool IsHalfWidth();
void SetHalfWidth(bool is_half);

/// Half width for as long as this lives, or full width.
class HalfWidth {
 public:
  explicit HalfWidth(bool is_half) : was_half_(IsHalfWidth()) { SetHalfWidth(is_half); }
  ~HalfWidth() { SetHalfWidth(was_half_); }
  HalfWidth(const HalfWidth&) = delete;
  HalfWidth& operator=(const HalfWidth&) = delete;

 private:
  bool was_half_;
};

}  // namespace yorb
