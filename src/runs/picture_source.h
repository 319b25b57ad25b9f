// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "core/result.h"
#include "core/time.h"

namespace yorb {

/// One picture of a source.
struct SourcePicture {
  std::string image;              ///< its file, or the video's
  std::string name;               ///< relative to the source, for results: "a/b.jpg", "clip_000012.png"
  std::optional<Timestamp> time;  ///< of a sequence or a video
  cv::Mat pixels;                 ///< 8-bit, grey or BGR, as a viewer shows it
};

/// A picture, a folder of pictures, a sequence or a video, read one picture at a time.
class PictureSource {
 public:
  virtual ~PictureSource() = default;

  /// Whether there is another picture.
  virtual bool HasNext() = 0;

  /// Reads it. Bad input for a picture that cannot be read; those behind it may be fine.
  virtual Result<SourcePicture> Next() = 0;

  /// How many pictures are left; 0 where that is not known before they are read (a video).
  virtual size_t NumLeft() const { return 0; }
};

/// Opens what a path names. Bad input where it is missing, a folder without pictures, or no kind that is known.
Result<std::unique_ptr<PictureSource>> OpenPictureSource(const std::string& path);

}  // namespace yorb
