// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/video.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

namespace yorb {

bool HasVideoEnding(std::string_view name) {
  std::string ending = std::filesystem::path(name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const char* known : {".mp4", ".avi", ".mkv", ".mov", ".webm", ".m4v", ".mpg", ".mpeg", ".wmv", ".ogv", ".gif"}) {
    if (ending == known) return true;
  }
  return false;
}

Result<Video> Video::Open(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return BadInput(path + " does not exist");
  cv::VideoCapture capture;
  bool is_open = false;
  try {
    is_open = capture.open(path);
  } catch (const cv::Exception&) {
  }
  if (!is_open) return BadInput(path + " is no video that can be decoded here; is it whole, and its codec installed?");
  return Video(capture);
}

std::optional<VideoFrame> Video::Next() {
  constexpr double kUsualRate = 30;  // pictures a second where the file does not say
  cv::Mat bgr;
  if (!capture_.read(bgr) || bgr.empty()) return std::nullopt;
  const double stated_ms = capture_.get(cv::CAP_PROP_POS_MSEC), stated_rate = capture_.get(cv::CAP_PROP_FPS);
  const double rate = std::isfinite(stated_rate) && stated_rate > 0 ? stated_rate : kUsualRate;
  const double by_rate_s = static_cast<double>(num_read_) / rate;
  const bool is_stated = std::isfinite(stated_ms) && (stated_ms > 0 || num_read_ == 0);
  ++num_read_;
  return VideoFrame{Timestamp{std::llround((is_stated ? stated_ms * 1e-3 : by_rate_s) * 1e9)}, bgr.clone()};
}

}  // namespace yorb
