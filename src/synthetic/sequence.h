// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "camera/image_set.h"
#include "camera/rig.h"
#include "core/result.h"
#include "geometry/trajectory.h"
#include "synthetic/camera_path.h"
#include "synthetic/mannequin.h"
#include "synthetic/render.h"
#include "synthetic/room.h"
#include "synthetic/sensor.h"

namespace yorb {

/// The camera of TUM's freiburg3 sequences, at any size of picture.
Rig SyntheticRig(int width = 640, int height = 480);

/// What to render.
struct SequenceOptions {
  PathKind path = PathKind::kXyz;
  int num_frames = 300;
  uint64_t seed = 1;   ///< decides on the room, the people's looks, the hand's tremor and the noise
  int num_people = 0;  ///< who walk through the room; at most kMaxPeople
  double noise = 1;    ///< of colour and depth; 0: exact
  RoomOptions room;    ///< its seed is not used: `seed` is
  Rig rig = SyntheticRig();
};

constexpr int kMaxPeople = 20;

/// Bad input when the options make no sequence: counts or noise out of range, a lens that cannot be straightened.
Status CheckOptions(const SequenceOptions& options);

/// A person's visible part: pixel columns [left, right), rows [top, bottom).
struct PersonBox {
  int person = 0;  ///< its number in the mask
  int left = 0, top = 0, right = 0, bottom = 0;
  int num_visible_px = 0;
};

/// Fewer visible pixels than this give no box.
constexpr int kMinVisiblePx = 150;

/// One moment of a sequence, with everything that is known about it.
struct RenderedFrame {
  ImageSet images;               ///< as the sensors deliver them
  Rigid3 world_from_cam;         ///< exact
  cv::Mat exact_depth;           ///< CV_32FC1, metres, without noise or holes
  cv::Mat mask;                  ///< CV_8UC1: 0 the room, k the k-th person
  std::vector<PersonBox> boxes;  ///< of the people in sight
};

/// A sequence that is rendered frame by frame, in any order and on any number of threads at once.
class SyntheticSequence {
 public:
  /// Builds the room, on `options.room.num_threads` threads. The options have passed CheckOptions.
  explicit SyntheticSequence(const SequenceOptions& options);

  RenderedFrame Render(int frame) const;

  int num_frames() const { return options_.num_frames; }
  int num_people() const { return static_cast<int>(people_.size()); }
  const Rig& rig() const { return options_.rig; }

  /// Colour and depth are taken at the same moment, `rig().fps` times a second.
  Timestamp TimeOf(int frame) const;
  Rigid3 WorldFromCamera(int frame) const;

  /// One pose a frame.
  Trajectory Truth() const;

 private:
  double SecondsOf(int frame) const;

  SequenceOptions options_;
  Room room_;
  CameraPath path_;
  std::vector<Mannequin> people_;
  Renderer renderer_;
};

}  // namespace yorb
