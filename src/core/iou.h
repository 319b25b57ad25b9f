// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace yorb {

/// The area that two boxes share, over the area that they cover together; 0 where they share none. Of anything with
/// left, top, right and bottom.
template <typename A, typename B>
double IoU(const A& a, const B& b) {
  const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  if (!(width > 0 && height > 0)) return 0;
  const double width_a = a.right - a.left, height_a = a.bottom - a.top;
  const double width_b = b.right - b.left, height_b = b.bottom - b.top;
  const double shared = width * height;
  return shared / (width_a * height_a + width_b * height_b - shared);
}

}  // namespace yorb
