// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "core/random.h"
#include "core/result.h"
#include "training/scene.h"

namespace yorb {

/// How people are pasted into pictures.
struct PeopleOptions {
  double share = 0.4;       ///< of the pictures
  int most = 3;             ///< people a picture
  double least_size = 0.2;  ///< height of a person in heights of the picture; they come evenly in its logarithm
  double largest_size = 2.8;
  double cut_share = 0.35;       ///< of the people, whose lower or side part is hidden by a straight edge
  double occluded_share = 0.35;  ///< of the people, before whom a piece of the picture or a dark plate stands
};

/// Cut-outs of people, CV_8UC4 with their transparency.
Result<std::vector<cv::Mat>> ReadCutouts(const std::string& folder);

/// Pastes people: near and far, in front of one another, cut by what would stand before them, partly out of the
/// picture. Boxes that they hide go; the mask of people, where the scene has one, is painted.
void PastePeople(const std::vector<cv::Mat>& cutouts, int person_class, const PeopleOptions& options, Scene& scene,
                 Random& random);

}  // namespace yorb
