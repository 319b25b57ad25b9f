// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "core/result.h"

namespace yorb {

/// `--size 320x256`, width before height, multiples of 32; empty where it is left out.
Result<cv::Size> ReadPictureSize(const std::optional<std::string>& text);

}  // namespace yorb
