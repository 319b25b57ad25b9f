// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/schedule.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/text.h"

namespace yorb {
namespace {

constexpr long long kLargestSide = 1280;

std::optional<cv::Size> ParseSize(std::string_view text) {
  const std::vector<std::string_view> sides = SplitAt(text, 'x');
  if (sides.size() != 2) return std::nullopt;
  const auto width = ParseInteger(sides.front()), height = ParseInteger(sides.back());
  const auto is_side = [](const auto& side) { return side && *side >= 32 && *side <= kLargestSide && *side % 32 == 0; };
  if (!is_side(width) || !is_side(height)) return std::nullopt;
  return cv::Size(static_cast<int>(*width), static_cast<int>(*height));
}

std::optional<SizePhase> ParsePhase(std::string_view text) {
  const std::vector<std::string_view> parts = SplitAt(text, ':');
  const auto until = parts.size() == 2 ? ParseDouble(parts[1]) : std::optional<double>(1.0);
  if (parts.size() > 2 || !until || !(*until > 0) || *until > 1) return std::nullopt;
  SizePhase phase{*until, {}};
  for (const std::string_view word : SplitAt(parts.front(), '+')) {
    const std::optional<cv::Size> size = ParseSize(word);
    if (!size) return std::nullopt;
    phase.sizes.push_back(*size);
  }
  return phase;
}

}  // namespace

Result<std::vector<SizePhase>> ParseSizePhases(const std::string& text) {
  std::vector<SizePhase> phases;
  for (const std::string_view field : SplitAt(text, ',')) {
    const std::optional<SizePhase> phase = ParsePhase(field);
    if (!phase || (!phases.empty() && phase->until <= phases.back().until))
      return BadInput("the size '" + OneLine(field) +
                      "' is none such as 320x256 (multiples of 32), 320x256+320x320 (in turn) or 224x192:0.4 (used "
                      "until 0.4 of the training is done)");
    phases.push_back(*phase);
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
  const std::vector<cv::Size>& sizes = phase != options_.phases.end() ? phase->sizes : options_.phases.back().sizes;
  return sizes[static_cast<size_t>(step) % sizes.size()];
}

}  // namespace yorb
