// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace yorb {

/// A box as a network gives it: pixels of the network's input, a class by number.
struct RawBox {
  float left = 0, top = 0, right = 0, bottom = 0;
  float confidence = 0;
  int label = 0;
};

/// Of boxes of one class that overlap by more than `most_overlap`, the one of the highest confidence stays. By falling
/// confidence, at most `most_boxes`.
std::vector<RawBox> SuppressDoubles(std::vector<RawBox> boxes, double most_overlap, size_t most_boxes);

}  // namespace yorb
