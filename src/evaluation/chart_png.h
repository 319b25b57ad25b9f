// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/result.h"

namespace yorb {

/// An SVG file of ours as a PNG file's content, `zoom` pixels a unit. Failure where it cannot be drawn.
Result<std::string> PngFromSvg(const std::string& svg, double zoom);

}  // namespace yorb
