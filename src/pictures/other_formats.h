// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "core/result.h"

namespace yorb {

/// The pictures of an open video, one after another.
class VideoStream {
 public:
  struct Picture {
    cv::Mat bgr;
    double stated_ms = 0,
           stated_rate = 0;  ///< what the file says of its time and of pictures a second; may be nonsense
  };

  virtual ~VideoStream() = default;

  /// The next picture; nothing at the end.
  virtual std::optional<Picture> Next() = 0;

  /// How many pictures the file says, or lets guess, that it holds; may be nonsense.
  virtual double StatedCount() const = 0;
};

/// What decodes pictures that are neither PNG nor JPEG, and videos. OpenCV does, with some 220 libraries behind it
/// (GDAL, DICOM, ffmpeg): linked to, they would cost every start of the program a third of a second and 60 MB. So they
/// are behind a module, yorb_codecs.so, which is loaded when the first such file is met.
class OtherFormats {
 public:
  virtual ~OtherFormats() = default;

  /// The picture as stored; empty where the bytes are none that is known. Any number of threads may call it.
  virtual cv::Mat Decode(const std::string& bytes) const = 0;

  /// The video in a file; null where it cannot be opened.
  virtual std::unique_ptr<VideoStream> OpenVideo(const std::string& path) const = 0;
};

/// The module, loaded once. Failure, with the remedy, where it is not installed.
Result<const OtherFormats*> LoadOtherFormats();

}  // namespace yorb
