// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// For tests of the room.
#pragma once

namespace yorb {

constexpr int kWidth = 640, kHeight = 480;  ///< of the pictures
constexpr double kMetresPerUnit = 0.0002;   ///< of depth pictures of whole numbers

}  // namespace yorb
