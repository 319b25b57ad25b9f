// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/result.h"
#include "core/time.h"
#include "pictures/other_formats.h"

namespace yorb {

/// One picture of a video.
struct VideoFrame {
  Timestamp time;  ///< since the beginning of the video
  cv::Mat bgr;
};

/// A video file, read from its first picture to its last.
class Video {
 public:
  /// Bad input where the file is missing or no video that can be decoded here.
  static Result<Video> Open(const std::string& path);

  /// The next picture; nothing at the end.
  std::optional<VideoFrame> Next();

  /// At its end: in words, that the file says it holds more; empty where it does not.
  std::string Shortfall() const;

 private:
  explicit Video(std::unique_ptr<VideoStream> stream) : stream_(std::move(stream)) {}

  std::unique_ptr<VideoStream> stream_;
  size_t num_read_ = 0;
  double rate_ = 0, last_s_ = 0;  ///< pictures a second, and the time of the last one
};

}  // namespace yorb
