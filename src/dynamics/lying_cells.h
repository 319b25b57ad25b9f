// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/body.h"

namespace yorb {

/// Marks kLying where a surface lies flat below the camera, as desks and floors do: it comes nearer towards the lower
/// edge of the picture, steadily and over some width. Bodies stand: seen from above, they are nearer at the head. Thin
/// things, such as the upper side of a shoulder, and small ones, such as a belly near the camera, are not marked.
CellMask MarkLying(const DepthCells& depth);

}  // namespace yorb
