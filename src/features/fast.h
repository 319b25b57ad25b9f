// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "features/grey_image.h"
#include "features/instructions.h"

namespace yorb {

/// The scores beside a corner; 0 where they are below the threshold.
struct NeighbourScores {
  uint8_t left = 0, right = 0, above = 0, below = 0;
};

/// A FAST corner of one pyramid level.
struct Corner {
  int x = 0, y = 0;      ///< pixels of the level
  int score = 0;         ///< the largest threshold in grey levels at which the pixel is still a corner
  float response = 0;    ///< what corners are ranked by; the detector sets it
  float dx = 0, dy = 0;  ///< where within the pixel, -0.5 to 0.5, if refined
  NeighbourScores beside;
};

/// What FAST looks for.
struct FastOptions {
  int threshold = 20;  ///< grey levels by which an arc of the ring must differ from the centre, exclusive
  int arc = 9;         ///< so many contiguous pixels of the ring of 16 make a corner; 9 to 12
  int border = 19;     ///< corners keep so many pixels away from the picture's edge; at least 4
};

/// The score of every pixel is the largest threshold at which it is a corner (0: not at `options.threshold`); corners
/// are pixels that score more than all eight neighbours. One map at a low threshold holds the corners of all higher
/// ones: those with score >= threshold, the very ones FAST finds there.
class Fast {
 public:
  /// Row by row, left to right. The result lives until the next call.
  const std::vector<Corner>& Detect(const GreyView& level, const FastOptions& options, Instructions instructions);

  /// What the last call found.
  const std::vector<Corner>& found() const { return corners_; }

 private:
  void ScoreRow(const GreyView& level, int y, const FastOptions& options, Instructions instructions);
  void TakePeaks(const GreyView& level, int y, const FastOptions& options, Instructions instructions);

  std::vector<uint8_t> rows_[3];  ///< scores of the last three rows; row y is rows_[y % 3]
  std::vector<uint32_t> peaks_;   ///< x of the corners of one row
  std::vector<Corner> corners_;
};

/// `corner` with dx and dy: the top of the parabolas through its score and those of its neighbours along x and y.
Corner Refined(Corner corner);

/// The sum of the 16 ring pixels without the brightest and the darkest: 14 times the trimmed mean of equation (3).
int TrimmedRingSum(const GreyView& level, int x, int y, Instructions instructions);

}  // namespace yorb
