// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "detection/detector.h"
#include "features/orb_extractor.h"
#include "looping/looping_options.h"
#include "mapping/mapping_options.h"
#include "places/places_options.h"
#include "tracking/tracking_options.h"

namespace yorb {

/// Chosen by runs among people: below it boxes of nobody cost more points than the people that they add, above it
/// people are missed; weaker ones, down to half of it, go on with what was seen.
inline DetectionOptions DetectionInRuns() {
  DetectionOptions options;
  options.confidence = 0.3;
  options.faint_confidence = 0.15;
  options.interval_s = 0.08;
  return options;
}

/// How the stages run; all modes run the same functions.
enum class Mode {
  kInline,   ///< one thread: same seed, same bits
  kOffline,  ///< threads; streams wait, no frame is left out
  kLive,     ///< threads; frames that come too fast are dropped
};

/// Every value that a run depends on, given back in RUNDIR/config.yaml.
struct Config {
  /// inline: one thread, same seed, same bits; offline: threads, no frame left out; live: frames that come too fast for
  /// the tracker are dropped
  std::string mode = "offline";
  /// what is done about moving things: full: their boxes are followed, within them depth tells the body from the
  /// background, and what else moves is found by geometry; paper: points in their boxes go; exact: the same with given
  /// boxes; off: nothing
  std::string dynamics = "full";
  std::string detections;  ///< a file of boxes in the detector's place; empty: the detector
  std::string masks;       ///< a folder of masks, or one for all frames: what is not to be used; empty: none
  std::string load_map;    ///< a file of `--save-map` to go on from; empty: a new map is begun
  /// true: the camera is only located in `load_map`, also in single pictures; nothing is added or changed
  bool localize_only = false;
  /// true: trajectory.txt holds the likeliest path of a camera in hand; false: each pose as its own picture gave it
  bool smooth = true;
  int64_t seed = 1;        ///< of everything that is drawn by chance: RANSAC in relocalisation
  int64_t max_frames = 0;  ///< only so many pictures from the start of a sequence; 0: all
  DetectionOptions detection = DetectionInRuns();
  FeatureOptions features;
  TrackingOptions tracking;
  MappingOptions mapping;
  LoopingOptions looping;
  PlacesOptions places;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("mode", self.mode, OneOf({"inline", "offline", "live"}));
    visit("dynamics", self.dynamics, OneOf({"off", "paper", "full", "exact"}));
    visit("detections", self.detections, AnyValue());
    visit("masks", self.masks, AnyValue());
    visit("load_map", self.load_map, AnyValue());
    visit("localize_only", self.localize_only, AnyValue());
    visit("smooth", self.smooth, AnyValue());
    visit("seed", self.seed, Range(0, 9e15));
    visit("max_frames", self.max_frames, Range(0, 9e15));
    visit("detection", self.detection);
    visit("features", self.features);
    visit("tracking", self.tracking);
    visit("mapping", self.mapping);
    visit("looping", self.looping);
    visit("places", self.places);
  }
};

/// The confidence from which a box alone speaks for a body: of the network's boxes; those of a file all do.
inline double SureConfidence(const Config& config) {
  return config.detections.empty() ? config.detection.confidence : 0;
}

}  // namespace yorb
