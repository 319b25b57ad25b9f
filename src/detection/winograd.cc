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

/// Numbers along one side of a patch.
template <int kTile>
using Line = float[kTile + 2];

/// B^T d of the paper, along one axis.
YORB_WINOGRAD_INLINE void ToDomain(Line<2>& d) {
  const float a = d[0], b = d[1], c = d[2];
  d[0] = a - c, d[1] = b + c, d[2] = c - b, d[3] = b - d[3];
}
YORB_WINOGRAD_INLINE void ToDomain(Line<4>& d) {
  const float a = d[0], b = d[1], c = d[2], e = d[3], f = d[4];
  const float even = f - 4 * c, odd = e - 4 * b, near = f - c, far = 2 * (e - b);
  d[0] = 4 * a - 5 * c + f, d[1] = even + odd, d[2] = even - odd;
  d[3] = near + far, d[4] = near - far, d[5] = 4 * b - 5 * e + d[5];
}

/// A^T m of the paper, along one axis: the first `kTile` numbers are what is wanted.
YORB_WINOGRAD_INLINE void FromDomain(Line<2>& m) {
  const float a = m[0], b = m[1], c = m[2];
  m[0] = a + b + c, m[1] = b - c - m[3];
}
YORB_WINOGRAD_INLINE void FromDomain(Line<4>& m) {
  const float sum = m[1] + m[2], difference = m[1] - m[2], far_sum = m[3] + m[4], far_difference = m[3] - m[4];
  m[0] = m[0] + sum + far_sum, m[1] = difference + 2 * far_difference;
  m[2] = sum + 4 * far_sum, m[3] = difference + 8 * far_difference + m[5];
}

/// G of the paper.
constexpr double kWeightsOfTwo[4][3] = {{1, 0, 0}, {.5, .5, .5}, {.5, -.5, .5}, {0, 0, 1}};
constexpr double kWeightsOfFour[6][3] = {{1. / 4, 0, 0},
                                         {-1. / 6, -1. / 6, -1. / 6},
                                         {-1. / 6, 1. / 6, -1. / 6},
                                         {1. / 24, 1. / 12, 1. / 6},
                                         {1. / 24, -1. / 12, 1. / 6},
                                         {0, 0, 1}};

/// Where the pixels of a patch lie; `blank` stands for those outside of the picture.
template <int kTile>
struct Patch {
  static constexpr int kSide = kTile + 2;
  const float* pixels[kSide * kSide];

  Patch(const WinogradSize& size, const float* picture, const float* blank, int64_t tile) {
    const int64_t top = tile / size.tiles_x() * kTile - 1, left = tile % size.tiles_x() * kTile - 1;
    for (int64_t i = 0; i < kSide * kSide; ++i) {
      const int64_t y = top + i / kSide, x = left + i % kSide;
      const bool is_inside = y >= 0 && y < size.height && x >= 0 && x < size.width;
      pixels[i] = is_inside ? picture + (y * size.width + x) * size.pixel_step : blank;
    }
  }
};

/// Row by row, then column by column; between the two the numbers stay in `middle`.
template <int kTile>
YORB_WINOGRAD_INLINE void InputTile(const Patch<kTile>& patch, int64_t channels, float* middle, float* to,
                                    int64_t step) {
  constexpr int kSide = kTile + 2;
  for (int i = 0; i < kSide; ++i) {
    const float* const* row = patch.pixels + kSide * i;
    float* out = middle + kSide * i * channels;
    YORB_NEVER_MEET
    for (int64_t c = 0; c < channels; ++c) {
      Line<kTile> line;
      for (int j = 0; j < kSide; ++j) line[j] = row[j][c];
      ToDomain(line);
      for (int j = 0; j < kSide; ++j) out[j * channels + c] = line[j];
    }
  }
  for (int j = 0; j < kSide; ++j) {
    YORB_NEVER_MEET
    for (int64_t c = 0; c < channels; ++c) {
      Line<kTile> line;
      for (int i = 0; i < kSide; ++i) line[i] = middle[(kSide * i + j) * channels + c];
      ToDomain(line);
      for (int i = 0; i < kSide; ++i) to[(kSide * i + j) * step + c] = line[i];
    }
  }
}

template <int kTile>
YORB_WINOGRAD_INLINE void InputTiles(const WinogradSize& size, const float* picture, float* to) {
  const std::vector<float> blank(static_cast<size_t>(size.in_channels), 0.f);
  std::vector<float> middle(static_cast<size_t>(size.num_products() * size.in_channels));
  const int64_t step = size.num_tiles() * size.in_channels;
  for (int64_t tile = 0; tile < size.num_tiles(); ++tile)
    InputTile(Patch<kTile>(size, picture, blank.data(), tile), size.in_channels, middle.data(),
              to + tile * size.in_channels, step);
}

/// Column by column, then row by row.
template <int kTile>
YORB_WINOGRAD_INLINE void OutputTile(const float* from, int64_t step, const WinogradEnd& end, int64_t channels,
                                     float* middle, float* const (&to)[kTile * kTile]) {
  constexpr int kSide = kTile + 2;
  for (int j = 0; j < kSide; ++j) {
    YORB_NEVER_MEET
    for (int64_t c = 0; c < channels; ++c) {
      Line<kTile> line;
      for (int i = 0; i < kSide; ++i) line[i] = from[(kSide * i + j) * step + c];
      FromDomain(line);
      for (int i = 0; i < kTile; ++i) middle[(kSide * i + j) * channels + c] = line[i];
    }
  }
  for (int i = 0; i < kTile; ++i) {
    const float* row = middle + kSide * i * channels;
    YORB_NEVER_MEET
    for (int64_t c = 0; c < channels; ++c) {
      Line<kTile> line;
      for (int j = 0; j < kSide; ++j) line[j] = row[j * channels + c];
      FromDomain(line);
      for (int j = 0; j < kTile; ++j)
        to[kTile * i + j][c] = std::min(std::max(line[j] + end.bias[c], end.least), end.most);
    }
  }
}

template <int kTile>
YORB_WINOGRAD_INLINE void OutputTiles(const WinogradSize& size, const float* products, const WinogradEnd& end,
                                      float* picture) {
  const auto channels = static_cast<size_t>(size.out_channels);
  const std::vector<float> no_bias(channels, 0.f);
  const WinogradEnd sure{end.bias != nullptr ? end.bias : no_bias.data(), end.least, end.most};
  std::vector<float> outside(channels);  // for what lies beyond the picture's last rows and columns
  std::vector<float> middle(static_cast<size_t>(size.num_products()) * channels);
  const int64_t step = size.num_tiles() * size.out_channels;
  for (int64_t tile = 0; tile < size.num_tiles(); ++tile) {
    const int64_t y = tile / size.tiles_x() * kTile, x = tile % size.tiles_x() * kTile;
    float* to[kTile * kTile];
    for (int64_t i = 0; i < kTile * kTile; ++i) {
      const int64_t row = y + i / kTile, column = x + i % kTile;
      const bool is_inside = row < size.height && column < size.width;
      to[i] = is_inside ? picture + (row * size.width + column) * size.out_channels : outside.data();
    }
    OutputTile<kTile>(products + tile * size.out_channels, step, sure, size.out_channels, middle.data(), to);
  }
}

YORB_WINOGRAD_INLINE void AnyInputTiles(const WinogradSize& size, const float* picture, float* to) {
  size.tile == 4 ? InputTiles<4>(size, picture, to) : InputTiles<2>(size, picture, to);
}
YORB_WINOGRAD_INLINE void AnyOutputTiles(const WinogradSize& size, const float* products, const WinogradEnd& end,
                                         float* picture) {
  size.tile == 4 ? OutputTiles<4>(size, products, end, picture) : OutputTiles<2>(size, products, end, picture);
}

#if defined(YORB_WINOGRAD_AVX2)
YORB_WINOGRAD_AVX2 void InputTilesAvx2(const WinogradSize& size, const float* picture, float* to) {
  AnyInputTiles(size, picture, to);
}
YORB_WINOGRAD_AVX2 void OutputTilesAvx2(const WinogradSize& size, const float* products, const WinogradEnd& end,
                                        float* picture) {
  AnyOutputTiles(size, products, end, picture);
}
bool HasAvx2() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
#endif

}  // namespace

int64_t BestWinogradTile(int64_t height, int64_t width) {
  constexpr int64_t kLeastPatches = 16;
  const WinogradSize small{height, width, 1, 1, 1, 2}, large{height, width, 1, 1, 1, 4};
  const bool is_less = large.num_tiles() * large.num_products() < small.num_tiles() * small.num_products();
  return is_less && large.num_tiles() >= kLeastPatches ? 4 : 2;
}

std::vector<float> WinogradWeights(const std::vector<float>& weights, const WinogradSize& size) {
  const double(*g)[3] = size.tile == 4 ? kWeightsOfFour : kWeightsOfTwo;
  const int64_t plane = size.out_channels * size.in_channels, side = size.tile + 2;
  std::vector<float> turned(static_cast<size_t>(size.num_products() * plane));
  for (int64_t i = 0; i < plane; ++i) {
    const float* kernel = weights.data() + 9 * i;
    for (int64_t k = 0; k < size.num_products(); ++k) {
      double sum = 0;
      for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 3; ++x) sum += g[k / side][y] * g[k % side][x] * static_cast<double>(kernel[3 * y + x]);
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
  AnyInputTiles(size, picture, to);
}

void WinogradOutput(const WinogradSize& size, const float* products, const WinogradEnd& end, float* picture) {
#if defined(YORB_WINOGRAD_AVX2)
  if (HasAvx2()) return OutputTilesAvx2(size, products, end, picture);
#endif
  AnyOutputTiles(size, products, end, picture);
}

}  // namespace yorb
