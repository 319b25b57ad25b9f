// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/time.h"

namespace yorb {

/// One thing that is right or wrong with a recording.
struct Finding {
  enum class Level {
    kFine,
    kWarning,  ///< a run is possible; the result may suffer
    kError,    ///< a run would be refused, or could give no pose
  };
  Level level = Level::kFine;
  std::string topic;  ///< "layout", "stamps", "pairs", "files", "camera", "pictures", "depth", "truth"
  std::string text;
};

/// The pictures of one list in numbers; what cannot be said is absent.
struct ListFacts {
  size_t count = 0;
  std::optional<double> rate_hz;
  std::optional<double> longest_gap_s;
  std::optional<Timestamp> first, last;
};

/// What a look at a recording without running SLAM shows.
struct SequenceCheck {
  std::string folder;
  ListFacts colour, depth;
  std::optional<size_t> num_pairs;               ///< within 20 ms
  std::optional<double> median_pair_distance_s;  ///< of all pairs, be they farther apart
  std::optional<int> width, height;              ///< of the colour pictures
  std::string camera;                            ///< empty where none could be chosen
  size_t num_sampled = 0, num_unreadable = 0;
  std::optional<double> depth_p5_m, depth_median_m, depth_p95_m, depth_hole_share;
  std::optional<double> truth_share;  ///< of the colour pictures with a true pose near
  std::vector<Finding> findings;

  bool is_usable() const;
};

/// Looks at a recording: its lists, its files, its camera, a sample of its pictures, and its truth.
SequenceCheck CheckSequence(const std::string& folder, const std::string& camera);

/// The check as lines for a reader, and as JSON (null where nothing can be said).
std::string CheckText(const SequenceCheck& check);
std::string CheckJson(const SequenceCheck& check);

}  // namespace yorb
