// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "training/label_rules.h"

namespace yorb {

/// A box in pixels of the picture that goes into the network.
struct SceneBox {
  float left = 0, top = 0, right = 0, bottom = 0;
  int class_index = 0;       ///< in the network's table of classes
  bool is_doubtful = false;  ///< neither rewarded nor punished

  float width() const { return right - left; }
  float height() const { return bottom - top; }
};

/// Values of a mask of people, CV_8U.
constexpr uint8_t kMaskNobody = 0, kMaskUnknown = 128, kMaskPerson = 255;

/// A picture for training with its truth.
struct Scene {
  cv::Mat pixels;  ///< CV_8UC3, BGR
  std::vector<SceneBox> boxes;
  ClassBits judged;       ///< by the network's classes
  cv::Mat people_mask{};  ///< of the picture's size; empty where boxes are all that is learnt
};

}  // namespace yorb
