// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "detection/box.h"

namespace yorb {

/// One set of boxes from several looks at one picture, doubles within each suppressed, all of confidences above 0:
/// weighted boxes fusion (Solovyev, Wang, Gabruseva: "Weighted boxes fusion", Image and Vision Computing 107, 2021).
/// Boxes of one name that overlap by more than `least_overlap` (IoU) are one thing: its corners are the mean by
/// confidence, and its confidence is the mean over all looks, 0 for those that did not see it. By falling confidence.
std::vector<Box> FuseLooks(const std::vector<std::vector<Box>>& looks, double least_overlap);

}  // namespace yorb
