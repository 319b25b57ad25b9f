// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "core/result.h"
#include "datasets/dataset.h"
#include "map/map.h"
#include "runs/make_detector.h"
#include "runs/point_cloud.h"

namespace yorb {

/// How depth pictures become a cloud.
struct DenseOptions {
  double cube_m = 0.01;               ///< side of the cubes in each of which one point stays
  std::function<bool()> should_stop;  ///< asked before each picture; may be empty
};

/// The clouds that the keyframes' depth pictures make together.
struct DenseClouds {
  std::vector<PointCloud> clouds;  ///< one a root that was asked for, in their order; coloured
  size_t num_keyframes = 0;        ///< whose pictures are in the recording
  size_t num_of_others = 0;        ///< whose time stamps are in it, but with pictures that are not theirs: left out
  size_t num_with_people = 0;      ///< of the former: pictures in which something moves by itself
  bool was_stopped = false;
};

/// Projects the depth pictures of a recording at the keyframes' time stamps into the worlds of the sub-maps with these
/// roots, by the poses and cameras of the keyframes. What moves by itself and what the user's masks name is left out,
/// so are depths too far to be trusted, and pixels at the edges of things, whose depth is a mixture, and keyframes
/// whose depths are not those of the picture: a map may go over several recordings whose time stamps are alike. Bad
/// input where no keyframe's picture is in the recording.
Result<DenseClouds> MakeDenseClouds(const Map& map, const std::vector<KeyframeId>& roots, const Dataset& dataset,
                                    const RunParts& parts, const DenseOptions& options);

}  // namespace yorb
