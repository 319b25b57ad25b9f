// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "detection/box_file.h"
#include "detection/detector.h"

namespace yorb {

/// The boxes of a file in the place of a network's.
class FileDetector : public Detector {
 public:
  /// Gives every moment of the file to the nearest frame within 15 ms. `frames`: the recording's time stamps, rising.
  /// Moments that fit no frame are counted in one warning; bad input where none of several fits.
  static Result<std::unique_ptr<FileDetector>> Make(const BoxFile& file, const std::vector<Timestamp>& frames);

  /// Boxes that were found in a picture of another size are scaled, with a warning; bad input where its sides are in
  /// another proportion.
  Result<Detections> Detect(const ImageSet& images) override;

  size_t num_unmatched() const { return num_unmatched_; }  ///< boxes that fit no frame

 private:
  FileDetector() = default;
  Status Scale(TimedBoxes& moment, int width, int height);

  std::string path_, rows_;
  std::map<Timestamp, std::vector<TimedBoxes>> by_frame_;
  bool names_all_ = false;
  bool has_told_of_outside_ = false, has_told_of_size_ = false;
  size_t num_unmatched_ = 0;
};

}  // namespace yorb
