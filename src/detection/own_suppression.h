// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detection/network.h"

namespace yorb {

/// Of a network that takes its doubles out itself (exports with nms=True, YOLOv7's with end2end), the part before that:
/// how many boxes are left is not known beforehand, and the limits that the file has in it are not those of the
/// options. Its output becomes the value that holds all boxes. Nothing changes where no value of a layout that is read
/// stands before it.
void LeaveOutOwnSuppression(Network& network);

}  // namespace yorb
