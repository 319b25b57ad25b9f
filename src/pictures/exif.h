// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace yorb {

/// How the camera was held, as a JPEG, PNG or WebP says in its EXIF block: 1 (upright) to 8; 1 where nothing is said.
int ExifOrientation(std::string_view bytes);

}  // namespace yorb
