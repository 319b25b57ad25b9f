// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/body.h"

namespace yorb {

/// Whether nearly all that is measured in a box lies in one plane that goes on beside or above it, and on no side ends
/// before something farther away: a poster, a screen or a picture of somebody, and nobody who stands there. Not said of
/// what is too far away to tell a body from the wall that it leans on.
bool LiesInAWall(const BodySearch& search, const Box& box);

}  // namespace yorb
