// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// For tests only.
#pragma once

#include <string>
#include <vector>

#include "datasets/depth_watch.h"
#include "synthetic/sequence.h"

namespace yorb {

/// A small synthetic room, rendered in memory.
class RoomDataset : public Dataset {
 public:
  explicit RoomDataset(int num_frames, int num_people = 0) : sequence_(Options(num_frames, num_people)) {
    for (int i = 0; i < num_frames; ++i) frames_.push_back(sequence_.Render(i));
  }
  size_t size() const override { return frames_.size(); }
  Timestamp TimeOf(size_t i) const override { return sequence_.TimeOf(static_cast<int>(i)); }
  std::string PictureName(size_t i) const override { return std::to_string(i); }
  const Rig& rig() const override { return sequence_.rig(); }
  Result<LoadedFrame> Load(size_t i) const override {
    LoadedFrame frame;
    frame.images = frames_[i].images;
    frame.depth = GlanceAt(frame.images->depth);
    return frame;
  }
  Trajectory Truth() const { return sequence_.Truth(); }
  const std::vector<RenderedFrame>& frames() const { return frames_; }

 private:
  static SequenceOptions Options(int num_frames, int num_people) {
    SequenceOptions options;
    options.num_frames = num_frames;
    options.num_people = num_people;
    options.rig = SyntheticRig(320, 240);
    options.noise = 0.5;
    return options;
  }
  SyntheticSequence sequence_;
  std::vector<RenderedFrame> frames_;
};

}  // namespace yorb
