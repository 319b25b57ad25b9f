// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "training/decode.h"
#include "training/scene.h"

namespace yorb {

/// How well one class is found.
struct ClassScore {
  int class_index = 0;
  int num_true = 0;
  double ap50 = 0;  ///< average precision at IoU 0.5
  double ap = 0;    ///< its mean over IoU 0.50, 0.55 ... 0.95
};

/// A picture's truth beside what was found in it.
struct JudgedPicture {
  std::vector<SceneBox> truth;
  std::vector<Detection> found;  ///< by falling confidence
};

/// COCO's rule: by falling confidence each box takes the best free true one; precision at 101 points of recall. Only
/// classes with truth are scored.
std::vector<ClassScore> ScoreClasses(const std::vector<JudgedPicture>& pictures, int num_classes);

}  // namespace yorb
