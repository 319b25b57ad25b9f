// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Room: system. Wires the stages into one river; the public door.
// Takes: Config, Rig, ImageSets. Gives: FrameRecords, map snapshots, the trajectory. Owns: threads, channels, the log
// of frames. Runs on: the caller's thread and, but for inline mode, its own. May not: read pictures or write results.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "camera/image_set.h"
#include "core/result.h"
#include "detection/detector.h"
#include "dynamics/remover.h"
#include "geometry/trajectory.h"
#include "map/event.h"
#include "places/vocabulary.h"
#include "system/config.h"

namespace yorb {

class Map;
class Pipeline;
using MapSnapshot = std::shared_ptr<const Map>;

/// A part of the map with a world of its own.
struct SubmapReport {
  KeyframeId root;        ///< not valid where nothing is known yet
  Trajectory trajectory;  ///< confirmed frames, world_from_cam by the newest map; see Config::smooth
  Trajectory keyframes;
};

/// What a run has come to so far.
struct SlamReport {
  std::vector<FrameRecord> frames;  ///< in the order of time, one a pushed picture that was not dropped
  std::map<std::string, std::vector<double>>
      stage_ms;                       ///< "extract", "track", "frame_total", "mapping", "local_ba" ...
  std::vector<SubmapReport> submaps;  ///< the one with most frames first; never empty
  size_t num_keyframes = 0, num_landmarks = 0, num_loops = 0;
  size_t num_landmarks_gone = 0;  ///< that turned out to move, and left the map

  /// Of the sub-map with most frames.
  const Trajectory& trajectory() const { return submaps.front().trajectory; }
  const Trajectory& keyframes() const { return submaps.front().keyframes; }
};

/// What was decided about the points of one picture.
struct Watched {
  const ImageSet& images;
  const std::vector<Keypoint>& points;   ///< all that were extracted
  const std::vector<Verdict>& verdicts;  ///< one a point
  const MovingAreas& areas;
};

/// What a system gets from outside.
struct SlamParts {
  MapSnapshot map;                               ///< to go on from, or to be located in; null: a new one is begun
  std::unique_ptr<Detector> detector;            ///< null: with `full`, geometry alone finds what moves
  MotionTable motions = MotionTable::Default();  ///< how the classes of its boxes move
  VocabularyPtr vocabulary;                      ///< null: no place is recognised by its words
  std::function<void(const Watched&)> watch;     ///< called for each picture, on the thread that tracks; may be empty
};

/// A SLAM system for one camera.
class Slam {
 public:
  /// Bad input where the configuration or the rig cannot work, or the rig is not the one that a map to go on from was
  /// made with (to be located in a map, any will do).
  static Result<std::unique_ptr<Slam>> Create(const Config& config, const Rig& rig, SlamParts parts = {});

  /// Bad input where this camera cannot go on with, or be located in, that map; Create looks, too.
  static Status CheckMap(const Config& config, const Map& map, const Rig& rig);

  /// Ends the threads; what was pushed and not yet worked off is dropped (call Finish first to keep it).
  ~Slam();

  /// Hands over the next picture; its size must be the rig's, its kind that of ImageSet, and its time later than the
  /// one before (else bad input, and the picture is left out). Inline: returns when all is done. Offline: waits for
  /// room. Live: never waits; false when the picture was dropped.
  Result<bool> Push(ImageSet images);

  /// Waits until everything pushed is worked off, and ends the threads. Push must not be called afterwards.
  void Finish();

  /// Why a stage broke off (out of memory, say), after which Push fails; fine while all is well.
  Status Fault() const;

  /// The newest map; never null, valid for as long as it is held.
  MapSnapshot Snapshot() const;

  /// Where the run stands; at any time, from any thread.
  SlamReport Report() const;

  /// How many frames have been worked off; cheap, for progress bars.
  size_t NumFramesDone() const;

 private:
  Slam(const Config& config, const Rig& rig, SlamParts parts);

  std::unique_ptr<Pipeline> pipeline_;
  int width_ = 0, height_ = 0;
  std::optional<Timestamp> newest_;
};

}  // namespace yorb
