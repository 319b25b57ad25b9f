// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace yorb {

constexpr double kNoFigure = std::numeric_limits<double>::quiet_NaN();  ///< where nothing was measured

/// Rows of cells as text; the first row is the head. The first `num_left` columns stand to the left, the others to the
/// right, each as wide as it must be.
std::string TextTable(const std::vector<std::vector<std::string>>& rows, size_t num_left);

/// A number with so many decimals, or "-" where there is none.
std::string NumberCell(double value, int decimals);

}  // namespace yorb
