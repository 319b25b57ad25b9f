// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace yorb {

/// A true box, or one that a detector found.
struct JudgedBox {
  int label = 0;
  double confidence = 1;
  double left = 0, top = 0, right = 0, bottom = 0;
};

/// What is in one picture, and what was found there.
struct JudgedPicture {
  std::vector<JudgedBox> truth, found;
};

/// How well one class is found.
struct ClassScore {
  int label = 0;
  size_t num_true = 0;
  double ap50 = 0;                  ///< average precision at an overlap of .5
  double ap = 0;                    ///< mean over the overlaps .50, .55 ... .95
  std::optional<double> precision;  ///< of all boxes from the confidence up, at an overlap of .5; nothing without any
  double recall = 0;                ///< the same
};

/// The classes that occur in the truth, and their means; nothing where there is no truth at all.
struct DetectionScores {
  std::vector<ClassScore> classes;  ///< by rising label
  std::optional<double> map50, map50_95;
};

/// Scores by COCO's rules: by falling confidence every found box takes the best free true box of its class and picture
/// that it overlaps enough; precision made falling, read at 101 recalls. Of a class in one picture the 100 surest boxes
/// make its average precision. `confidence` is for precision and recall alone, which take every box from there up.
DetectionScores ScoreDetections(const std::vector<JudgedPicture>& pictures, double confidence);

/// The area under a precision-recall curve by COCO's 101 points. `hits`: by falling confidence, whether a box is right.
double AveragePrecision(const std::vector<bool>& hits, size_t num_true);

}  // namespace yorb
