// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "features/keypoint.h"

namespace yorb {

/// Which points stay when more were extracted than are wanted (the paper's over-extraction: the moving ones have gone
/// by then, and enough must be left).
enum class TrimBy {
  kResponse,  ///< those of the highest response, wherever they are: the paper's rule
  kSpread,    ///< those of the highest response as long as no part of the picture takes more than its share
};

/// Keeps `wanted` points, in the order in which they were; all of them where there are no more.
Features Trim(Features features, size_t wanted, TrimBy by);

}  // namespace yorb
