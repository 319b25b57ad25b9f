// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "core/random.h"
#include "training/class_table.h"
#include "training/pack.h"
#include "training/scene.h"

namespace yorb {

/// How pictures are put together for training.
struct ComposeOptions {
  double mosaic = 0.5;            ///< share of pictures that are mosaics of four
  double zoom = 1;                ///< mean enlargement of single pictures against one that just fits
  double log_scale = 0.5;         ///< half the range of the zoom's logarithm: 0.6 to 1.65
  double log_aspect = 0.12;       ///< half the range of the logarithm of width against height
  double squashed_aspect = 0.35;  ///< the same for pictures that were made square: 4:3 and 3:4 lie within
  double close_up = 0.25;         ///< share of single pictures that look closely at one of their things
  double most_close_up = 3;       ///< times that they are enlarged, at most; 1.3 at least
  double flip = 0.5;              ///< share of mirrored pictures
  double kept_part = 0.2;         ///< a box of which less than this is in view is doubtful
};

/// One picture, augmented by itself, and with it its mask of people where it has one; nothing is judged.
Scene ComposeSingle(const PackedPicture& picture, const cv::Mat& people_mask, const cv::Size& size,
                    const ComposeOptions& options, Random& random);

/// Brings packed pictures into a network's input size.
class Composer {
 public:
  /// `packs` name their classes each in its own way; those that `table` lacks are dropped.
  Composer(std::vector<std::shared_ptr<const Pack>> packs, const ClassTable& table);

  size_t size() const { return places_.size(); }

  /// Picture `index`, augmented, and on some draws three others with it.
  Scene Compose(size_t index, const cv::Size& size, const ComposeOptions& options, Random& random) const;

  /// Picture `index` letterboxed, as it is.
  Scene Letterbox(size_t index, const cv::Size& size) const;

 private:
  struct Place {
    int pack = 0;
    size_t index = 0;
  };
  struct Source {
    PackedPicture picture;  // boxes with the network's class numbers
    ClassBits judged;
  };
  Source GetSource(size_t index) const;

  std::vector<std::shared_ptr<const Pack>> packs_;
  std::vector<std::vector<int>> class_of_;  // of each pack: the table's number for the pack's, or -1
  std::vector<Place> places_;
};

}  // namespace yorb
