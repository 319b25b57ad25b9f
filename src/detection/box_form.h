// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "detection/engine.h"
#include "detection/head_layout.h"

namespace yorb {

/// What the numbers of boxes are seen to be.
struct SeenForm {
  BoxForm form = BoxForm::kCentre;
  bool are_fractions = false;  ///< of the input, in place of pixels
};

/// What the numbers of boxes are, of a layout with a row for each cell, by what the network gives for a picture of
/// nothing: the boxes of most cells lie about them then. Nothing where they lie elsewhere, where that tells no form
/// from another, or where few cells have boxes.
std::optional<SeenForm> BoxFormOf(const std::vector<TensorView>& outputs, const HeadLayout& layout,
                                  const HeadFacts& facts);

/// Whether the objectness of all rows that have a box is 1, as YOLOv6 writes it, which has none.
bool IsObjectnessOne(const TensorView& rows);

}  // namespace yorb
