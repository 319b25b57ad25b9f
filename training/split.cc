// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/split.h"

#include <algorithm>

#include "core/random.h"
#include "core/text.h"

namespace yorb {

Result<SplitRatio> ParseSplitRatio(const std::string& text) {
  constexpr long long kMost = 1000;
  const std::vector<std::string_view> parts = SplitAt(text, ':');
  const auto train = ParseInteger(parts.front()), val = ParseInteger(parts.back());
  if (parts.size() != 2 || !train || !val || *train < 1 || *val < 1 || *train > kMost || *val > kMost)
    return BadInput("the split '" + OneLine(text) + "' is none such as 4:1, training against validation");
  return SplitRatio{static_cast<int>(*train), static_cast<int>(*val)};
}

Split SplitFiles(std::vector<LabelledFile> files, const SplitRatio& ratio, uint64_t seed) {
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.picture < b.picture; });
  Random random(seed);
  for (size_t i = files.size(); i > 1; --i) std::swap(files[i - 1], files[random.Below(static_cast<uint32_t>(i))]);
  const size_t whole = static_cast<size_t>(ratio.train + ratio.val);
  const size_t num_val = (files.size() * static_cast<size_t>(ratio.val) + whole / 2) / whole;
  const auto middle = files.end() - static_cast<std::ptrdiff_t>(num_val);
  return {{files.begin(), middle}, {middle, files.end()}};
}

}  // namespace yorb
