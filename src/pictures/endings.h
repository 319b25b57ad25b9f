// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace yorb {

/// Whether a name ends as picture files do (.png, .jpg, .tiff ...), in letters of either case.
bool HasPictureEnding(std::string_view name);

/// Whether it ends as JPEGs do.
bool HasJpegEnding(std::string_view name);

/// Whether it ends as video files do (.mp4, .avi, .mkv ...).
bool HasVideoEnding(std::string_view name);

}  // namespace yorb
