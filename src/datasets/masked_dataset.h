// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "datasets/dataset.h"

namespace yorb {

/// A recording with the user's own masks: what is not 0 in them is not to be used. In masks of several colours, or with
/// a palette, that is whatever is not black; transparency does not count.
class MaskedDataset : public Dataset {
 public:
  /// `masks`: one PNG for all frames, or a folder of PNGs that are named as the colour pictures (a.png or a.jpg.png
  /// for a.jpg) or by their time stamps, to the millisecond. Bad input where it is missing, no mask of the folder
  /// belongs to a frame, none can be read, or the first one is of another size than the pictures; frames without one
  /// are counted in a warning. `source` must live longer.
  static Result<std::unique_ptr<MaskedDataset>> Open(const Dataset& source, const std::string& masks);

  size_t size() const override { return source_.size(); }
  Timestamp TimeOf(size_t i) const override { return source_.TimeOf(i); }
  std::string PictureName(size_t i) const override { return source_.PictureName(i); }
  const Rig& rig() const override { return source_.rig(); }

  /// Bad input where a mask is of another size than its picture. One that cannot be read is warned of and counted as
  /// skipped, and its frame used as a whole.
  Result<LoadedFrame> Load(size_t i) const override;

 private:
  explicit MaskedDataset(const Dataset& source) : source_(source) {}

  const Dataset& source_;
  std::vector<std::string> files_;  ///< of each frame; empty: none
};

}  // namespace yorb
