// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "datasets/dataset.h"
#include "geometry/trajectory.h"

namespace yorb {

/// The pictures of one folder, in order: loose ones, or those of a sequence whose motion may be known.
struct PictureSet {
  std::string name;                  ///< the folder's own
  std::vector<std::string> paths;    ///< of loose pictures
  std::unique_ptr<Dataset> dataset;  ///< of a sequence
  Trajectory truth;                  ///< of a sequence with a groundtruth.txt

  size_t size() const { return dataset ? dataset->size() : paths.size(); }
  bool HasMotion() const { return dataset != nullptr && !truth.empty(); }
};

/// Opens a folder of pictures, a sequence (`camera` as for OpenDataset), or a single picture.
Result<PictureSet> OpenPictureSet(const std::string& place, const std::string& camera);

/// A picture, with its depth where it belongs to a sequence; empty grey where it cannot be decoded whole (warned of).
Result<ImageSet> LoadPicture(const PictureSet& set, size_t i);

/// The true pose at a moment, between its neighbours at most 0.1 s apart; nothing where the truth has a hole.
std::optional<Rigid3> TruePose(const Trajectory& truth, Timestamp time);

/// At most `count` of 0 ... `size` - 1, evenly spread; all where `count` is 0.
std::vector<size_t> Spread(size_t size, size_t count);

}  // namespace yorb
