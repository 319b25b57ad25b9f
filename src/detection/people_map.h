// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "detection/engine.h"
#include "detection/letterbox.h"

namespace yorb {

/// Whether an output may be a map of people: (1, 1, height, width).
bool IsPeopleMap(const TensorView& output);

/// How likely each part of a picture shows somebody: CV_8UC1, a pixel a cell of an even grid over the whole picture, of
/// about the cells of the network; 255 is a person beyond doubt. `logits`: the map of people over the network's input.
cv::Mat PeopleIn(const TensorView& logits, const Letterbox& fit);

}  // namespace yorb
