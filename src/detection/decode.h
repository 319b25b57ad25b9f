// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/result.h"
#include "detection/engine.h"
#include "detection/head_layout.h"
#include "detection/nms.h"

namespace yorb {

/// How outputs become boxes.
struct DecodeOptions {
  double confidence = 0.25;        ///< boxes below it are left out
  bool takes_all_classes = false;  ///< every class above the confidence makes a box of its own, not only the best
  bool is_logits = false;          ///< of maps: the sigmoid is still to come
  std::vector<float> anchors;      ///< of raw maps: width, height in px, three a map, by rising stride
};

/// YOLOv5's anchors for the strides 8, 16 and 32, px.
const std::vector<float>& StandardAnchors();

/// The boxes that the outputs of a network hold, doubles included, in pixels of the network's input. Bad input, in
/// words that follow the file's name, where scores are no numbers or no probabilities.
Result<std::vector<RawBox>> DecodeBoxes(const std::vector<TensorView>& outputs, const HeadLayout& layout,
                                        const DecodeOptions& options);

/// Whether boxes of rows seem to be fractions of the picture in place of pixels: none reaches out of the top left
/// corner.
bool LookLikeFractions(const std::vector<RawBox>& boxes);

/// Of raw maps whose anchors and values share an axis: the channels of objectness, and the number from which on a cell
/// is looked at. All else in the other cells is not read.
struct ObjectnessRead {
  std::vector<int64_t> channels;
  float least = 0;
};
ObjectnessRead ObjectnessOf(int64_t num_channels, const DecodeOptions& options);

/// Whether the last number of each end-to-end row is whole: the shape alone does not say so (RT-DETR with two classes
/// has rows of six, too).
bool HaveClassNumbers(const TensorView& rows);

/// Whether numbers of raw maps are logits: sigmoids never leave 0 to 1.
bool LookLikeLogits(const std::vector<TensorView>& outputs, const HeadLayout& layout);

}  // namespace yorb
