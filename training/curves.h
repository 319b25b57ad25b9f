// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/result.h"

namespace yorb {

/// The curves of a training as an SVG sheet, from the logs in its folder: the three losses, the learning rate, and the
/// scores on each watched set, over the part of the training that was done. Bad input when the folder holds no log.
Result<std::string> CurvesSvg(const std::string& folder);

}  // namespace yorb
