// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Room: datasets. From files on disk to ImageSets in the order of time.
// Takes: a folder, a camera. Gives: Dataset, LoadedFrame, a SequenceCheck. Owns: nothing but lists of names.
// Runs on: whichever thread calls; Load may be called from several. May not: know features, maps or results.
#pragma once

#include <optional>
#include <string>

#include "camera/image_set.h"
#include "camera/rig.h"
#include "core/result.h"

namespace yorb {

/// What a look at a few pixels of a depth picture shows.
struct DepthGlance {
  bool has_picture = false;   ///< a depth picture belongs to the frame and was decoded
  bool is_float = false;      ///< metres, no depth factor applied
  double measured_share = 0;  ///< of the pixels looked at
  double median_m = 0;        ///< of the measured ones; 0 where there are none
};

/// What became of one frame when it was read.
struct LoadedFrame {
  std::optional<ImageSet> images;  ///< nothing: the colour picture cannot be decoded whole, the frame is left out
  int num_skipped = 0;             ///< pictures of this frame that could not be decoded whole; each was warned of
  DepthGlance depth;
  int orientation = 1;  ///< of the colour picture's EXIF block, which is not applied: the camera saw it as it is stored
};

/// A recording: frames in the order of time, read one at a time. Stereo, EuRoC, KITTI and video come in here too.
class Dataset {
 public:
  virtual ~Dataset() = default;

  /// How many colour pictures the list names: the frames that coverage refers to.
  virtual size_t size() const = 0;

  /// When frame i was taken; strictly increasing.
  virtual Timestamp TimeOf(size_t i) const = 0;

  /// The colour picture of frame i as its list names it: for messages, masks and detections.
  virtual std::string PictureName(size_t i) const = 0;

  /// The camera, fitted to the pictures' size; its fps is the list's where the camera file states none.
  virtual const Rig& rig() const = 0;

  /// Reads frame i from disk. An error means that the run cannot go on (depth of a wrong kind, a picture of another
  /// size than those before). May be called from any thread.
  virtual Result<LoadedFrame> Load(size_t i) const = 0;
};

}  // namespace yorb
