// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "core/result.h"
#include "training/picture_set.h"

namespace yorb {

/// A picture in which it is known, pixel by pixel, where people are.
struct MaskedPicture {
  cv::Mat pixels;       ///< CV_8UC3, BGR
  cv::Mat people_mask;  ///< of the same size; see `Scene`
};

/// The pictures of DIR/images, sorted, and as `labels` their masks DIR/masks/NAME.png. Bad input where one has no mask.
Result<std::vector<LabelledFile>> FindMaskedFiles(const std::string& folder);

/// Bad input where a file cannot be read, or the mask has more than one channel. What is neither 0, 128 nor 255 in a
/// mask counts as the nearest of these.
Result<MaskedPicture> ReadMaskedPicture(const LabelledFile& file);

/// People of these pictures as cut-outs (CV_8UC4): what is connected in a mask, large enough, and not among things of
/// which it is unknown whether they belong to it.
Result<std::vector<cv::Mat>> CutOutPeople(const std::vector<LabelledFile>& files);

/// Pictures of sets that belong together, for draws: a name begins with its set's and "_". The root of its size weighs
/// a set, so that large ones do not drown the small.
class SetsOfPictures {
 public:
  explicit SetsOfPictures(const std::vector<LabelledFile>& files);

  /// The picture that a number from 0 to 1 stands for, and one for the choice within its set. There must be pictures.
  const LabelledFile& Draw(double set, double within) const;

 private:
  std::vector<std::vector<LabelledFile>> sets_;
  double total_weight_ = 0;
};

}  // namespace yorb
