// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/body.h"

namespace yorb {

/// Whether the surface of a body goes on, unbroken, far beyond its box: then it is a wall or a cupboard beside which
/// somebody stood. A body that its box cuts goes on a little. Other boxes and the edge of the picture end it.
bool GoesOnBeyond(const BodySearch& search, const Box& box, const BodyPlane& body);

}  // namespace yorb
