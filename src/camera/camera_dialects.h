// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "camera/key_table.h"
#include "camera/rig.h"
#include "core/result.h"

namespace yorb {

/// Tells the dialect of a camera file by its keys and reads it. See camera_io.h for the dialects and what each may say.
Result<Rig> RigFromKeys(const KeyTable& table);

}  // namespace yorb
