// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/files.h"
#include "core/result.h"
#include "experiments/features.h"

namespace yorb {

/// Figures 3 and 5 to 7 of the paper from the middle picture of a set, as PNG files in `folder`, and the counts of
/// corners over brightness as an SVG file. Names begin with the set's.
Result<std::vector<FileToWrite>> FeatureFigures(const PictureSet& set, const FeatureOptions& ours,
                                                const std::string& folder);

}  // namespace yorb
