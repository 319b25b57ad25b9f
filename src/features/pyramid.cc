// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/pyramid.h"

#include <cmath>
#include <cstring>

namespace yorb {

void ResizeTaps::Set(int source, int target) {
  if (source_size == source && static_cast<int>(first.size()) == target) return;
  source_size = source;
  first.resize(static_cast<size_t>(target));
  weight.resize(static_cast<size_t>(target));
  const double scale = 1.0 / (static_cast<double>(target) / source);
  for (int i = 0; i < target; ++i) {
    const double position = scale * (i + 0.5) - 0.5;
    const int whole = static_cast<int>(std::floor(position));
    const bool inside = whole >= 0 && whole < source - 1;
    const size_t index = static_cast<size_t>(i);
    first[index] = inside ? whole : (whole < 0 ? 0 : source - 1);
    weight[index] = inside ? static_cast<uint16_t>(std::lrint((position - whole) * 256)) : uint16_t{0};
  }
}

const uint16_t* Resizer::RowOf(const GreyView& source, int y, Instructions) {
  const int slot = y & 1;
  std::vector<uint16_t>& row = row_[slot];
  if (row_y_[slot] == y) return row.data();
  row_y_[slot] = y;
  const uint8_t* from = source.Row(y);
  for (size_t i = 0; i < columns_.first.size(); ++i) {
    const uint8_t* pair = from + columns_.first[i];
    const int weight = columns_.weight[i];
    row[i] = static_cast<uint16_t>(weight == 0 ? pair[0] * 256 : pair[0] * (256 - weight) + pair[1] * weight);
  }
  return row.data();
}

GreyView Resizer::Shrink(const GreyView& source, int width, int height, Instructions instructions) {
  target_.Resize(width, height);
  columns_.Set(source.width, width);
  rows_.Set(source.height, height);
  for (int slot = 0; slot < 2; ++slot) {
    row_[slot].resize(static_cast<size_t>(width));
    row_y_[slot] = -1;
  }
  for (int y = 0; y < height; ++y) {
    const int first = rows_.first[static_cast<size_t>(y)];
    const uint32_t weight = rows_.weight[static_cast<size_t>(y)];
    const uint16_t* upper = RowOf(source, first, instructions);
    const uint16_t* lower = weight == 0 ? upper : RowOf(source, first + 1, instructions);
    uint8_t* out = target_.Row(y);
    for (int x = 0; x < width; ++x) {
      out[x] = static_cast<uint8_t>((upper[x] * (256 - weight) + lower[x] * weight + 32768) >> 16);
    }
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
