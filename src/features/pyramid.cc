// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/pyramid.h"

#include <cmath>
#include <cstring>

namespace yorb {
namespace resize {
namespace {

constexpr int kLanes = 8;
constexpr int kOffset = 32768;  // makes 16-bit values signed, as wide multiplications want them

size_t RoundUp(int count, int multiple) { return static_cast<size_t>((count + multiple - 1) / multiple * multiple); }

}  // namespace

void Taps::Set(int source, int target) {
  if (source_size == source && size == target) return;
  source_size = source, size = target;
  const size_t padded = RoundUp(target, kBlock);
  first.assign(padded, source - 1);
  weight.assign(padded, 0);
  const double scale = 1.0 / (static_cast<double>(target) / source);
  for (int i = 0; i < target; ++i) {
    const double position = scale * (i + 0.5) - 0.5;
    const int whole = static_cast<int>(std::floor(position));
    const bool has_second = whole >= 0 && whole < source - 1;
    first[static_cast<size_t>(i)] = has_second ? whole : (whole < 0 ? 0 : source - 1);
    if (has_second) weight[static_cast<size_t>(i)] = static_cast<int16_t>(std::lrint((position - whole) * 256));
  }

  start.resize(padded / kLanes);
  first_lane.assign(2 * padded, 0x80);  // 0x80 shuffles a zero in
  second_lane.assign(2 * padded, 0x80);
  fits_lanes = true;
  for (size_t i = 0; i < padded; ++i) {
    if (i % kLanes == 0) start[i / kLanes] = first[i];
    const int lane = first[i] - start[i / kLanes];
    fits_lanes = fits_lanes && lane < 15;
    first_lane[2 * i] = static_cast<uint8_t>(lane);
    second_lane[2 * i] = static_cast<uint8_t>(lane + 1);
  }
}

void RowPortable(const uint8_t* source, const Taps& taps, int16_t* out) {
  for (size_t i = 0; i < static_cast<size_t>(taps.size); ++i) {
    const uint8_t* pair = source + taps.first[i];
    const int weight = taps.weight[i];
    const int second = weight == 0 ? 0 : pair[1] - pair[0];  // there may be no pair[1]
    out[i] = static_cast<int16_t>(pair[0] * 256 + second * weight - kOffset);
  }
}

void BetweenPortable(const int16_t* upper, const int16_t* lower, int weight, int width, uint8_t* out) {
  for (int x = 0; x < width; ++x) {
    const int sum = upper[x] * (256 - weight) + lower[x] * weight + kOffset * 256;
    out[x] = static_cast<uint8_t>((sum + 32768) >> 16);
  }
}

}  // namespace resize

const int16_t* Resizer::RowOf(const GreyView& source, int y, Instructions instructions) {
  std::vector<int16_t>& row = row_[y % 2];
  if (row_y_[y % 2] == y) return row.data();
  row_y_[y % 2] = y;
  const bool is_wide = instructions == Instructions::kAvx2 && columns_.fits_lanes;
  (is_wide ? resize::RowAvx2 : resize::RowPortable)(source.Row(y), columns_, row.data());
  return row.data();
}

GreyView Resizer::Shrink(const GreyView& source, int width, int height, Instructions instructions) {
  target_.Resize(width, height);
  columns_.Set(source.width, width);
  rows_.Set(source.height, height);
  for (int slot = 0; slot < 2; ++slot) {
    row_[slot].resize(static_cast<size_t>(width + 2 * resize::kBlock));
    row_y_[slot] = -1;
  }
  const auto between = instructions == Instructions::kAvx2 ? resize::BetweenAvx2 : resize::BetweenPortable;
  for (int y = 0; y < height; ++y) {
    const int first = rows_.first[static_cast<size_t>(y)], weight = rows_.weight[static_cast<size_t>(y)];
    const int16_t* upper = RowOf(source, first, instructions);
    const int16_t* lower = weight == 0 ? upper : RowOf(source, first + 1, instructions);
    between(upper, lower, weight, width, target_.Row(y));
  }
  return target_.View();
}

void Pyramid::Build(const GreyView& picture, int levels, double factor, Instructions instructions) {
  const size_t count = static_cast<size_t>(levels);
  views_.assign(count, GreyView{});
  resizers_.resize(count);
  if (picture.empty()) return;
  picture_.Resize(picture.width, picture.height);
  for (int y = 0; y < picture.height; ++y) {
    std::memcpy(picture_.Row(y), picture.Row(y), static_cast<size_t>(picture.width));
  }
  views_[0] = picture_.View();
  for (size_t level = 1; level < count; ++level) {
    const float scale = static_cast<float>(std::pow(factor, static_cast<double>(level)));
    const int width = static_cast<int>(std::lrint(static_cast<float>(picture.width) / scale));
    const int height = static_cast<int>(std::lrint(static_cast<float>(picture.height) / scale));
    if (width < 1 || height < 1) return;
    views_[level] = resizers_[level].Shrink(views_[level - 1], width, height, instructions);
  }
}

}  // namespace yorb
