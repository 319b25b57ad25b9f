// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/result.h"
#include "datasets/dataset.h"
#include "system/config.h"
#include "system/slam.h"

namespace yorb {

/// What a run needs beside the pictures.
struct RunParts {
  SlamParts slam;
  size_t num_boxes_unmatched = 0;  ///< of a box file, that fit no frame
  /// Weaker boxes of the detector count only where they go on from stronger ones: `full` asks the network for faint
  /// ones, too, and whoever removes by these boxes must say so to its Remover. A file's boxes are all sure.
  double sure_confidence = 0;
};

/// The vocabulary, the map to go on from, the detector that a run needs, and how its classes move: none with `dynamics`
/// off; the boxes of `detections` where a file is named (exact needs one); else the network. Bad input names file and
/// remedy.
Result<RunParts> MakeParts(const Config& config, const Dataset& dataset);

}  // namespace yorb
