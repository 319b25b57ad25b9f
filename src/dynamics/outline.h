// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/body.h"

namespace yorb {

/// Whether the surface of a body goes on, unbroken, across most of the borders of its box: then it is a wall or a
/// cupboard beside which somebody stood. Borders at the edge of the picture or within other boxes say nothing.
bool GoesOnBeyond(const BodySearch& search, const Box& box, const BodyPlane& body);

}  // namespace yorb
