// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/blur.h"

#include <algorithm>
#include <cmath>

#include "features/blur_rows.h"

namespace yorb {
namespace {

using blur::kRadius;

/// -1 is 1, -2 is 2, size is size - 2.
int Mirror(int i, int size) {
  if (size == 1) return 0;
  while (i < 0 || i >= size) i = i < 0 ? -i : 2 * size - 2 - i;
  return i;
}

/// a * b + c with one rounding. The product of two floats is exact in double; the sum is rounded at 53 bits first,
/// which changes a result once in 2^29, and then by one part in 2^24.
float MultiplyAdd(float a, float b, float c) { return static_cast<float>(static_cast<double>(a) * b + c); }

}  // namespace

namespace blur {

void WidenPortable(const uint8_t* row, int width, float* out) {
  for (int x = 0; x < width; ++x) out[x] = row[x];
}

void RowPortable(const float* mirrored, int width, float* out) {
  for (int x = 0; x < width; ++x) {
    float sum = kWeights[0] * mirrored[x];
    for (int i = 1; i < 7; ++i) sum = MultiplyAdd(kWeights[i], mirrored[x + i], sum);
    out[x] = sum;
  }
}

void ColumnPortable(const float* const rows[7], int width, uint8_t* out) {
  for (int x = 0; x < width; ++x) {
    float sum = kWeights[3] * rows[3][x];
    for (int i = 1; i <= kRadius; ++i) sum = MultiplyAdd(kWeights[3 + i], rows[3 + i][x] + rows[3 - i][x], sum);
    out[x] = static_cast<uint8_t>(std::min(std::lrint(sum), 255l));
  }
}

}  // namespace blur

void Blur::BlurRow(const GreyView& source, int y, Instructions instructions) {
  const bool is_wide = instructions == Instructions::kAvx2;
  const int width = source.width;
  const uint8_t* row = source.Row(y);
  float* mirrored = mirrored_.data() + kRadius;
  (is_wide ? blur::WidenAvx2 : blur::WidenPortable)(row, width, mirrored);
  for (int i = 1; i <= kRadius; ++i) {
    mirrored[-i] = row[Mirror(-i, width)];
    mirrored[width - 1 + i] = row[Mirror(width - 1 + i, width)];
  }
  (is_wide ? blur::RowAvx2 : blur::RowPortable)(mirrored_.data(), width, rows_[y % 7].data());
}

GreyView Blur::Apply(const GreyView& source, Instructions instructions) {
  target_.Resize(source.width, source.height);
  const size_t padded = static_cast<size_t>(source.width + 2 * blur::kBlock);
  mirrored_.resize(padded);
  for (std::vector<float>& row : rows_) row.resize(padded);
  int next = 0;
  for (int y = 0; y < source.height; ++y) {
    for (; next <= std::min(y + kRadius, source.height - 1); ++next) BlurRow(source, next, instructions);
    const float* rows[7];
    for (int i = 0; i < 7; ++i) rows[i] = rows_[Mirror(y + i - kRadius, source.height) % 7].data();
    const auto column = instructions == Instructions::kAvx2 ? blur::ColumnAvx2 : blur::ColumnPortable;
    column(rows, source.width, target_.Row(y));
  }
  return target_.View();
}

}  // namespace yorb
