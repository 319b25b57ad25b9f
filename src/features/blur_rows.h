// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace yorb::blur {

/// OpenCV's getGaussianKernel(7, 2, CV_32F).
constexpr float kWeights[7] = {0x1.1f5f62p-4f, 0x1.0c70fcp-3f, 0x1.869472p-3f, 0x1.ba95cp-3f,
                               0x1.869472p-3f, 0x1.0c70fcp-3f, 0x1.1f5f62p-4f};
constexpr int kRadius = 3;

/// Rows are read and written in blocks: so many pixels beyond their end must be there.
constexpr int kBlock = 32;

/// Bytes to floats.
void WidenPortable(const uint8_t* row, int width, float* out);
void WidenAvx2(const uint8_t* row, int width, float* out);

/// One row along x; `mirrored` starts three pixels to the left of the row.
void RowPortable(const float* mirrored, int width, float* out);
void RowAvx2(const float* mirrored, int width, float* out);

/// One row of the result from seven rows blurred along x.
void ColumnPortable(const float* const rows[7], int width, uint8_t* out);
void ColumnAvx2(const float* const rows[7], int width, uint8_t* out);

}  // namespace yorb::blur
