// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "datasets/dataset.h"
#include "datasets/light.h"

namespace yorb {

/// A recording under another light: the colour pictures change while they are read, all else stays.
class LightDataset : public Dataset {
 public:
  /// `source` must live longer.
  LightDataset(const Dataset& source, const MovingLight& light) : source_(source), light_(light) {}

  size_t size() const override { return source_.size(); }
  Timestamp TimeOf(size_t i) const override { return source_.TimeOf(i); }
  std::string PictureName(size_t i) const override { return source_.PictureName(i); }
  const Rig& rig() const override { return source_.rig(); }
  Result<LoadedFrame> Load(size_t i) const override;

 private:
  const Dataset& source_;
  MovingLight light_;
};

}  // namespace yorb
