// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/body.h"

namespace yorb {

/// Where the body in a box may be, the likeliest depth first, three at the most: what fills the middle of the box and,
/// unlike the wall behind and the desk in front, does not go on outside of it. `last_metres`: where it was in the
/// picture before, if it was seen there. Empty where too little was measured.
std::vector<BodySign> FindBodies(const BodySearch& search, const Box& box, std::optional<float> last_metres);

/// Whether enough was measured around a box, outside of all boxes, to tell a body from a wall.
bool HasSurroundings(const BodySearch& search, const Box& box);

/// Whether what lies around a box is mostly at the depth of the body: then it is a wall. So may be a box without
/// surroundings.
bool GoesOnAround(const BodySearch& search, const Box& box, const BodyPlane& body);

}  // namespace yorb
