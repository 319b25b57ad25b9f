// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/text_table.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"

namespace yorb {

std::string TextTable(const std::vector<std::vector<std::string>>& rows, size_t num_left) {
  std::vector<size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (size_t k = 0; k < row.size(); ++k) {
      const std::string padding(widths[k] - row[k].size(), ' ');
      line += (k > 0 ? "  " : "") + (k < num_left ? row[k] + padding : padding + row[k]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string NumberCell(double value, int decimals) { return std::isfinite(value) ? FormatFixed(value, decimals) : "-"; }

}  // namespace yorb
