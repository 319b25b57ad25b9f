// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/schedule.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"

namespace yorb {
namespace {

constexpr long long kLargestSide = 1280;

}  // namespace

Result<std::vector<SizePhase>> ParseSizePhases(const std::string& text) {
  std::vector<SizePhase> phases;
  for (const std::string_view field : SplitAt(text, ',')) {
    const std::vector<std::string_view> parts = SplitAt(field, ':');
    const std::vector<std::string_view> sides = SplitAt(parts.front(), 'x');
    const auto width = ParseInteger(sides.front()), height = ParseInteger(sides.back());
    const auto until = parts.size() == 2 ? ParseDouble(parts[1]) : std::optional<double>(1.0);
    const auto is_side = [](const auto& side) {
      return side && *side >= 32 && *side <= kLargestSide && *side % 32 == 0;
    };
    const double last = phases.empty() ? 0 : phases.back().until;
    if (parts.size() > 2 || sides.size() != 2 || !is_side(width) || !is_side(height) || !until || !(*until > last) ||
        *until > 1)
      return BadInput("the size '" + OneLine(field) +
                      "' is none such as 320x256 (multiples of 32) or 224x192:0.4 (used until "
                      "0.4 of the training is done)");
    phases.push_back({*until, cv::Size(static_cast<int>(*width), static_cast<int>(*height))});
  }
  phases.back().until = 1;
  return phases;
}

double Schedule::Progress(int64_t step) const {
  const double done = options_.num_steps > 0 ? static_cast<double>(step) / static_cast<double>(options_.num_steps)
                                             : Seconds() / (60 * options_.minutes);
  return std::clamp(done, 0.0, 1.0);
}

double Schedule::Rate(int64_t step) const {
  const double warmup = std::min(
      1.0, (1.0 + static_cast<double>(step)) / static_cast<double>(std::max<int64_t>(1, options_.num_warmup_steps)));
  const double cosine = 0.5 * (1 + std::cos(M_PI * Progress(step)));
  return warmup * (options_.last_rate + (1 - options_.last_rate) * cosine);
}

cv::Size Schedule::SizeAt(int64_t step) const {
  const double progress = Progress(step);
  const auto phase = std::find_if(options_.phases.begin(), options_.phases.end(),
                                  [&](const SizePhase& p) { return progress < p.until; });
  return phase != options_.phases.end() ? phase->size : options_.phases.back().size;
}

}  // namespace yorb
