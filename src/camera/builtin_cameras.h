// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "camera/rig.h"
#include "core/result.h"

namespace yorb {

/// The names of the cameras in our configs/cameras, sorted; empty where the folder is not found.
std::vector<std::string> BuiltinCameraNames();

/// The file of a configuration known by name, such as ("cameras", "tum_fr1"). Bad input lists the known names.
Result<std::string> FindConfigFile(const std::string& kind, const std::string& name);

/// What `--camera` names: a built-in camera, else a camera file.
Result<Rig> ReadCamera(const std::string& name_or_file);

}  // namespace yorb
