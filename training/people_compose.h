// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "core/random.h"
#include "core/result.h"
#include "training/compose.h"
#include "training/people.h"
#include "training/people_masks.h"
#include "training/people_scenes.h"
#include "training/photometric.h"
#include "training/scene.h"

namespace yorb {

/// How pictures are put together that teach where people are.
struct PeopleSceneOptions {
  double masked = 0.28;   ///< share of pictures with masks
  double peopled = 0.24;  ///< share of scenes with people in boxes; the rest are empty ones, people pasted into most
  ComposeOptions compose{.zoom = 1.35, .log_scale = 0.6};
  PeopleOptions people{.share = 0.85, .most = 4, .least_size = 0.25};
  double pasted_among_people = 0.3;  ///< share of the scenes with people that get more of them
  PhotometricOptions light{.saturation = 0.4, .blur = 0.4, .noise = 0.5, .most_noise = 9, .jpeg = 0.5};
};

/// Puts such pictures together. Any thread may call it.
class PeopleComposer {
 public:
  /// There must be masked pictures; where one kind of scenes is missing, the other takes its share.
  PeopleComposer(const std::vector<LabelledFile>& masked, PlainScenes scenes, std::vector<cv::Mat> cutouts,
                 const PeopleSceneOptions& options);

  /// A picture with its mask of people, for an input of `size`. Bad input where a file cannot be read.
  Result<Scene> Compose(const cv::Size& size, Random& random) const;

 private:
  enum class Kind { kMasked, kPeopled, kEmpty };
  Kind DrawKind(Random& random) const;

  SetsOfPictures masked_;
  PlainScenes scenes_;
  std::vector<cv::Mat> cutouts_;
  PeopleSceneOptions options_;
};

/// A picture with its mask as a detector would see it.
Scene LetterboxMasked(const MaskedPicture& picture, const cv::Size& size);

}  // namespace yorb
