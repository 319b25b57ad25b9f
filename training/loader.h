// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <opencv2/core.hpp>
#include <vector>

#include "training/batch.h"
#include "training/compose.h"
#include "training/people.h"
#include "training/photometric.h"

namespace yorb {

struct LoaderOptions {
  int batch_size = 16;
  uint64_t seed = 1;
  ComposeOptions compose;
  PeopleOptions people;
  PhotometricOptions light;
  bool is_augmented = true;  ///< false: letterboxed pictures as they are
  bool is_pinned = false;    ///< see MakeBatch
};

/// Makes the batches of a training one after the other. What batch `step` holds depends on the seed and the step alone
/// (and on the size asked for), so that a resumed training goes on as it would have.
class Loader {
 public:
  /// `size_at` gives the input size of a step.
  Loader(std::shared_ptr<const Composer> composer, std::vector<cv::Mat> cutouts, const ClassTable& table,
         const LoaderOptions& options, std::function<cv::Size(int64_t)> size_at);

  Batch Make(int64_t step);

 private:
  size_t PictureAt(int64_t position);

  std::shared_ptr<const Composer> composer_;
  std::vector<cv::Mat> cutouts_;
  int person_class_, num_classes_;
  LoaderOptions options_;
  std::function<cv::Size(int64_t)> size_at_;
  int64_t epoch_ = -1;
  std::vector<size_t> order_;  // of the pictures in this epoch
};

}  // namespace yorb
