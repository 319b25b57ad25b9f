// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// A. Lavin, S. Gray: Fast Algorithms for Convolutional Neural Networks, CVPR 2016, section 4.1.
#include "detection/winograd.h"

#include <algorithm>

#if defined(__x86_64__) && defined(__GNUC__)
#define YORB_WINOGRAD_AVX2 __attribute__((target("avx2,fma")))
#define YORB_WINOGRAD_INLINE __attribute__((always_inline)) inline
#else
#define YORB_WINOGRAD_INLINE inline
#endif

// What is read and what is written in a loop never meets: too much for a compiler to see, or to test.
#if defined(__clang__)
#define YORB_NEVER_MEET _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define YORB_NEVER_MEET _Pragma("GCC ivdep")
#else
#define YORB_NEVER_MEET
#endif

namespace yorb {
namespace {

/// The four pixels of a row of a patch, one channel: B^T d of the paper, along one axis.
struct Four {
  float a, b, c, d;
};
YORB_WINOGRAD_INLINE Four ToDomain(const Four& p) { return {p.a - p.c, p.b + p.c, p.c - p.b, p.b - p.d}; }

/// Where the rows and columns of a patch lie; `blank` stands for those outside of the picture.
struct Patch {
  const float* pixels[16];
};

Patch PatchAt(const WinogradSize& size, const float* picture, const float* blank, int64_t tile) {
  const int64_t top = tile / size.tiles_x() * 2 - 1, left = tile % size.tiles_x() * 2 - 1;
  Patch patch;
  for (int64_t i = 0; i < 16; ++i) {
    const int64_t y = top + i / 4, x = left + i % 4;
    const bool is_inside = y >= 0 && y < size.height && x >= 0 && x < size.width;
    patch.pixels[i] = is_inside ? picture + (y * size.width + x) * size.pixel_step : blank;
  }
  return patch;
}

YORB_WINOGRAD_INLINE void InputTile(const Patch& patch, int64_t channels, float* to, int64_t step) {
  YORB_NEVER_MEET
  for (int64_t c = 0; c < channels; ++c) {
    Four rows[4];
    for (int i = 0; i < 4; ++i) {
      const float* const* p = patch.pixels + 4 * i;
      rows[i] = ToDomain({p[0][c], p[1][c], p[2][c], p[3][c]});
    }
    const Four columns[4] = {
        ToDomain({rows[0].a, rows[1].a, rows[2].a, rows[3].a}), ToDomain({rows[0].b, rows[1].b, rows[2].b, rows[3].b}),
        ToDomain({rows[0].c, rows[1].c, rows[2].c, rows[3].c}), ToDomain({rows[0].d, rows[1].d, rows[2].d, rows[3].d})};
    for (int i = 0; i < 4; ++i) {
      to[(0 + i) * step + c] = columns[i].a;
      to[(4 + i) * step + c] = columns[i].b;
      to[(8 + i) * step + c] = columns[i].c;
      to[(12 + i) * step + c] = columns[i].d;
    }
  }
}

YORB_WINOGRAD_INLINE void InputTiles(const WinogradSize& size, const float* picture, float* to) {
  const std::vector<float> blank(static_cast<size_t>(size.in_channels), 0.f);
  const int64_t step = size.num_tiles() * size.in_channels;
  for (int64_t tile = 0; tile < size.num_tiles(); ++tile)
    InputTile(PatchAt(size, picture, blank.data(), tile), size.in_channels, to + tile * size.in_channels, step);
}

/// A^T m of the paper, along one axis: four products to two pixels.
struct Two {
  float a, b;
};
YORB_WINOGRAD_INLINE Two FromDomain(float a, float b, float c, float d) { return {a + b + c, b - c - d}; }

YORB_WINOGRAD_INLINE void OutputTile(const float* from, int64_t step, const WinogradEnd& end, int64_t channels,
                                     float* const (&to)[4]) {
  YORB_NEVER_MEET
  for (int64_t c = 0; c < channels; ++c) {
    Two columns[4];
    for (int i = 0; i < 4; ++i) {
      const float* p = from + i * step + c;
      columns[i] = FromDomain(p[0], p[4 * step], p[8 * step], p[12 * step]);
    }
    const Two upper = FromDomain(columns[0].a, columns[1].a, columns[2].a, columns[3].a);
    const Two lower = FromDomain(columns[0].b, columns[1].b, columns[2].b, columns[3].b);
    const float bias = end.bias[c];
    to[0][c] = std::min(std::max(upper.a + bias, end.least), end.most);
    to[1][c] = std::min(std::max(upper.b + bias, end.least), end.most);
    to[2][c] = std::min(std::max(lower.a + bias, end.least), end.most);
    to[3][c] = std::min(std::max(lower.b + bias, end.least), end.most);
  }
}

YORB_WINOGRAD_INLINE void OutputTiles(const WinogradSize& size, const float* products, const WinogradEnd& end,
                                      float* picture) {
  const auto channels = static_cast<size_t>(size.out_channels);
  const std::vector<float> no_bias(channels, 0.f);
  const WinogradEnd sure{end.bias != nullptr ? end.bias : no_bias.data(), end.least, end.most};
  std::vector<float> outside(channels);  // for the last row or column of a picture of odd size
  const int64_t step = size.num_tiles() * size.out_channels;
  for (int64_t tile = 0; tile < size.num_tiles(); ++tile) {
    const int64_t y = tile / size.tiles_x() * 2, x = tile % size.tiles_x() * 2;
    const auto at = [&](int64_t row, int64_t column) {
      return row < size.height && column < size.width ? picture + (row * size.width + column) * size.out_channels
                                                      : outside.data();
    };
    float* const to[4] = {at(y, x), at(y, x + 1), at(y + 1, x), at(y + 1, x + 1)};
    OutputTile(products + tile * size.out_channels, step, sure, size.out_channels, to);
  }
}

#if defined(YORB_WINOGRAD_AVX2)
YORB_WINOGRAD_AVX2 void InputTilesAvx2(const WinogradSize& size, const float* picture, float* to) {
  InputTiles(size, picture, to);
}
YORB_WINOGRAD_AVX2 void OutputTilesAvx2(const WinogradSize& size, const float* products, const WinogradEnd& end,
                                        float* picture) {
  OutputTiles(size, products, end, picture);
}
bool HasAvx2() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
#endif

}  // namespace

std::vector<float> WinogradWeights(const std::vector<float>& weights, int64_t out_channels, int64_t in_channels) {
  const double g[4][3] = {{1, 0, 0}, {.5, .5, .5}, {.5, -.5, .5}, {0, 0, 1}};
  const int64_t plane = out_channels * in_channels;
  std::vector<float> turned(static_cast<size_t>(kWinogradProducts * plane));
  for (int64_t i = 0; i < plane; ++i) {
    const float* kernel = weights.data() + 9 * i;
    for (int64_t k = 0; k < kWinogradProducts; ++k) {
      double sum = 0;
      for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 3; ++x) sum += g[k / 4][y] * g[k % 4][x] * static_cast<double>(kernel[3 * y + x]);
      }
      turned[static_cast<size_t>(k * plane + i)] = static_cast<float>(sum);
    }
  }
  return turned;
}

void WinogradInput(const WinogradSize& size, const float* picture, float* to) {
#if defined(YORB_WINOGRAD_AVX2)
  if (HasAvx2()) return InputTilesAvx2(size, picture, to);
#endif
  InputTiles(size, picture, to);
}

void WinogradOutput(const WinogradSize& size, const float* products, const WinogradEnd& end, float* picture) {
#if defined(YORB_WINOGRAD_AVX2)
  if (HasAvx2()) return OutputTilesAvx2(size, products, end, picture);
#endif
  OutputTiles(size, products, end, picture);
}

}  // namespace yorb
