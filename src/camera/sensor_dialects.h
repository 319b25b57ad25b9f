// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "camera/key_table.h"
#include "camera/rig.h"

namespace yorb {

// The JSON files that come out of depth sensors' own software. Each reader keeps its complaint in `reader`.

/// Open3D's PinholeCameraIntrinsic ("intrinsic_matrix", column by column), and what its recorders write beside it.
bool IsOpen3d(const KeyTable& table);
Rig ReadOpen3d(KeyReader& reader);

/// librealsense's intrinsics ("ppx", "ppy", "coeffs"), as its bindings print them.
bool IsRealSense(const KeyTable& table);
Rig ReadRealSense(KeyReader& reader);

}  // namespace yorb
