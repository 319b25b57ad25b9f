// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "camera/image_set.h"
#include "features/frame.h"
#include "features/orb_extractor.h"
#include "features/trim.h"

namespace yorb {

/// From pictures to a Frame: extraction, trimming to the wanted number, undistortion, depth of each
/// point, grid. Between the first two, whoever wants may take points away.
class FrameBuilder {
 public:
  FrameBuilder(const FeatureOptions& options, const Rig& rig);

  /// More points than are wanted, where over-extraction is asked for. `images` must have the rig's picture size (the
  /// caller has checked it).
  Features Extract(const ImageSet& images, const PointFilter& may_use = {}) {
    return extractor_.Extract(images.grey, may_use);
  }

  /// The frame of those features of `images` that are left, and of those that were taken away (`suspects`).
  FramePtr Build(FrameId id, const ImageSet& images, Features features, Features suspects = {}) const;

  FramePtr Build(FrameId id, const ImageSet& images) { return Build(id, images, Extract(images)); }

 private:
  OrbExtractor extractor_;
  size_t wanted_;
  TrimBy trim_by_;
  std::shared_ptr<const Rig> rig_;
  std::shared_ptr<const ScaleTable> scales_;
  PixelBounds bounds_;
};

}  // namespace yorb
