// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "features/fast.h"

namespace yorb {

/// How the corners of one level are chosen.
struct CornerOptions {
  bool is_adaptive = true;  ///< thresholds by equation (3), for each pixel; otherwise the fixed ones
  int high = 20, low = 7;   ///< grey levels; not adaptive
  double alpha = 0.7;       ///< the first threshold is alpha times the trimmed mean of the ring: equation (3)
  double alpha_low = 0.07;  ///< the second one, of the same kind
  int noise = 4;            ///< grey levels that a corner must exceed under any light; adaptive
  /// The candidates are so many times the corners asked for, the strongest for their neighbourhood that pass the second
  /// threshold; 0: two thresholds cell by cell. Adaptive only.
  double choice = 1.2;
  int arc = 9;      ///< contiguous ring pixels that make a corner
  int border = 19;  ///< pixels that stay empty along the edges
};

/// Whether a corner of a level may be used; empty: all may.
using CornerFilter = std::function<bool(const Corner&)>;

/// FAST with two thresholds: a cell of about 30 px in which the first one finds nothing gets the corners of the second.
/// Where that leaves fewer than `enough` corners, the strongest of all others join them, so that no picture starves
/// (adaptive only: the fixed thresholds stay as ORB-SLAM2 has them).
/// With `choice` the first threshold is not asked, as which cells it leaves empty changes with every additive light,
/// and with that the corners themselves. The candidates are then the strongest for their neighbourhood: light that
/// scales the contrast of a part of the picture changes neither their number nor which they are.
class CornerDetector {
 public:
  /// Row by row, left to right. The result lives until the next call.
  const std::vector<Corner>& Detect(const GreyView& level, const CornerOptions& options, int enough,
                                    Instructions instructions, const CornerFilter& may_use = {});

  /// What `Detect` would give for the same level with another filter; all corners are known from the last call.
  const std::vector<Corner>& DetectAgain(const GreyView& level, const CornerOptions& options, int enough,
                                         Instructions instructions, const CornerFilter& may_use);

  /// All corners that pass the first threshold, and no others: what the paper counts under changing light.
  const std::vector<Corner>& DetectFirst(const GreyView& level, const CornerOptions& options,
                                         Instructions instructions);

 private:
  /// What a corner of the score map has passed.
  enum class Class : uint8_t { kNoise, kSecond, kFirst, kChosen };

  void Classify(const std::vector<Corner>& found, const GreyView& level, const CornerOptions& options,
                Instructions instructions);
  void FindCells(const std::vector<Corner>& found, const GreyView& level, int border);
  size_t ChooseByCells(const std::vector<Corner>& found, const GreyView& level, int border);
  void ChooseStrongest(const std::vector<Corner>& found, size_t count);
  void MeasureStrength(const std::vector<Corner>& found, const GreyView& level, int border);
  void ChooseByStrength(const std::vector<Corner>& found, const GreyView& level, const CornerOptions& options,
                        size_t enough, Instructions instructions);
  void TakeCorners(const std::vector<Corner>& found);

  Fast fast_;
  std::vector<Class> classes_;          ///< of each corner of the score map
  std::vector<uint32_t> cells_;         ///< of each corner of the score map
  std::vector<uint32_t> column_cells_;  ///< of each x
  std::vector<uint8_t> has_first_;      ///< whether the first threshold finds anything in a cell
  std::vector<float> strength_;         ///< of each corner of the score map, beside its neighbourhood
  std::vector<uint64_t> refused_;       ///< ranks of the strongest that do not pass the second threshold
  std::vector<uint64_t> ranks_;         ///< strength and index of a corner in one number: the stronger the larger
  std::vector<uint32_t> rest_;          ///< indices of corners that are not chosen
  std::vector<Corner> usable_;          ///< of the score map, where not all may be used
  std::vector<Corner> corners_;
};

}  // namespace yorb
