// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>

namespace yorb {

/// Whether all numbers of a row are finite.
template <typename Row>
bool AllFinite(const Row& row) {
  return std::all_of(std::begin(row), std::end(row), [](auto value) { return std::isfinite(value); });
}

}  // namespace yorb
