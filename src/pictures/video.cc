// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/video.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace yorb {

Result<Video> Video::Open(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return BadInput(path + " does not exist");
  const auto formats = LoadOtherFormats();
  if (!formats) return Failure(path + " " + formats.error().message);
  auto stream = (*formats)->OpenVideo(path);
  if (!stream) return BadInput(path + " is no video that can be decoded here; is it whole, and its codec installed?");
  return Video(std::move(stream));
}

std::optional<VideoFrame> Video::Next() {
  constexpr double kUsualRate = 30;  // pictures a second where the file does not say
  const auto picture = stream_->Next();
  if (!picture) return std::nullopt;
  const double stated_ms = picture->stated_ms, stated_rate = picture->stated_rate;
  const double rate = std::isfinite(stated_rate) && stated_rate > 0 ? stated_rate : kUsualRate;
  const double by_rate_s = static_cast<double>(num_read_) / rate;
  const bool is_stated = std::isfinite(stated_ms) && (stated_ms > 0 || num_read_ == 0);
  ++num_read_;
  rate_ = rate, last_s_ = is_stated ? stated_ms * 1e-3 : by_rate_s;
  return VideoFrame{Timestamp{std::llround(last_s_ * 1e9)}, picture->bgr};
}

std::string Video::Shortfall() const {
  // Many files state their length in seconds alone, in which sound may go on, and some of their pictures are not a
  // steady time apart: only where both number and time fall short something is missing.
  constexpr double kLeastMissing = 0.5, kLeastShare = 0.02;  // seconds; of the length
  const double stated = stream_->StatedCount();
  if (!(std::isfinite(stated) && stated > static_cast<double>(num_read_) && stated < 1e9) || num_read_ == 0) return "";
  const double length_s = stated / rate_, missing_s = length_s - last_s_ - 1 / rate_;
  if (missing_s < std::max(kLeastMissing, kLeastShare * length_s)) return "";
  return "says that it holds " + std::to_string(std::llround(stated)) + " pictures, of which " +
         std::to_string(num_read_) + " can be read; is it cut short?";
}

}  // namespace yorb
