// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/result.h"
#include "training/label_rules.h"
#include "training/picture_set.h"

namespace yorb {

struct BuildPackOptions {
  int long_side_px = 320;
  std::string class_list;  ///< the set's own list of classes
  std::string teacher;     ///< folder of a teacher's boxes with confidence, NAME.txt each; may be empty
  std::vector<LabelRule> rules;
};

/// What went into a pack.
struct PackCounts {
  size_t num_pictures = 0, num_boxes = 0, num_doubtful = 0;
};

/// Reads, reduces and packs labelled pictures into the file `path`. Bad input for a picture or a label that cannot be
/// read. `progress` hears how many are done.
Result<PackCounts> BuildPack(const std::vector<LabelledFile>& files, const std::string& path,
                             const BuildPackOptions& options, const std::function<void(size_t)>& progress);

}  // namespace yorb
