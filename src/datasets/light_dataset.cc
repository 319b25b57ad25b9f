// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/light_dataset.h"

#include <opencv2/imgproc.hpp>

namespace yorb {

Result<LoadedFrame> LightDataset::Load(size_t i) const {
  auto frame = source_.Load(i);
  if (!frame || !frame->images) return frame;
  const double seconds = SecondsBetween(source_.TimeOf(0), source_.TimeOf(i));
  ImageSet& images = *frame->images;
  if (images.colour.empty()) {
    images.grey = InLight(light_, i, seconds, images.grey);
    return frame;
  }
  const cv::Mat changed = InLight(light_, i, seconds, images.colour);
  if (changed.data == images.colour.data) return frame;
  images.colour = changed;
  cv::Mat grey;
  cv::cvtColor(changed, grey, cv::COLOR_BGR2GRAY);
  images.grey = grey;
  return frame;
}

}  // namespace yorb
