// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/result.h"

namespace yorb {

/// The size that an SVG file of ours states.
struct SvgSize {
  double width = 0, height = 0;
};

/// The width and height of a drawing that SvgCanvas made; zero for other texts.
SvgSize SizeOfSvg(const std::string& svg);

/// An SVG file of ours as a PNG file's content, `zoom` pixels a unit. Failure where it cannot be drawn, or where the
/// library for it is not installed.
Result<std::string> PngFromSvg(const std::string& svg, double zoom);

}  // namespace yorb
