// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/time.h"

namespace yorb {

/// Colour and depth pictures farther apart than this do not belong together; TUM's own limit.
constexpr double kMaxPairDifference = 0.02;

/// For each colour stamp the index of the depth stamp that belongs to it, or -1. The nearest pair is made first and
/// each depth stamp is given once; only where depth is slower than colour does the rest share. Both lists must be
/// sorted.
std::vector<int> Associate(const std::vector<Timestamp>& colour, const std::vector<Timestamp>& depth,
                           double max_difference = kMaxPairDifference);

}  // namespace yorb
