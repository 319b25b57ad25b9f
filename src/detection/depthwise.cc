// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/depthwise.h"

#include <algorithm>

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>
#if !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // false alarms of gcc 12 within its own AVX-512 header
#pragma GCC diagnostic ignored "-Wuninitialized"
#endif
#define YORB_DEPTHWISE_AVX512 __attribute__((target("avx512f")))
#endif

namespace yorb {
namespace {

constexpr int64_t kLanes = 16;

int64_t NumGroups(const DepthwiseSize& size) { return (size.channels + kLanes - 1) / kLanes; }
int64_t PaddedWidth(const DepthwiseSize& size) { return (size.out_width - 1) * size.stride + size.kernel; }
int64_t PaddedHeight(const DepthwiseSize& size) { return (size.out_height - 1) * size.stride + size.kernel; }

#if defined(YORB_DEPTHWISE_AVX512)

/// What a group of sixteen channels is computed from, and how it ends.
struct Group {
  const float* padded;
  const float* weights;
  const float* bias;
  float least, most;
  __mmask16 mask;  ///< of the channels that there are
};

/// Copies a group of channels to where it is padded; the padding is there already.
YORB_DEPTHWISE_AVX512 void Lay(const DepthwiseSize& size, const float* from, __mmask16 mask, float* padded) {
  const int64_t width = PaddedWidth(size);
  const int64_t rows = std::min(size.height, PaddedHeight(size) - size.top),
                columns = std::min(size.width, width - size.left);
  for (int64_t y = 0; y < rows; ++y) {
    for (int64_t x = 0; x < columns; ++x) {
      const __m512 pixel = _mm512_maskz_loadu_ps(mask, from + (y * size.width + x) * size.pixel_step);
      _mm512_storeu_ps(padded + ((y + size.top) * width + x + size.left) * kLanes, pixel);
    }
  }
}

/// `kCount` neighbouring pixels of the result; `from`: the first of those that the first one is made of.
template <int kKernel, int kStride, int kCount>
YORB_DEPTHWISE_AVX512 inline void Pixels(const Group& group, const float* from, int64_t row_step, float* to,
                                         int64_t step) {
  __m512 sums[kCount];
  for (int i = 0; i < kCount; ++i) sums[i] = _mm512_loadu_ps(group.bias);
  for (int y = 0; y < kKernel; ++y) {
    for (int x = 0; x < kKernel; ++x) {
      const __m512 weight = _mm512_loadu_ps(group.weights + (y * kKernel + x) * kLanes);
      for (int i = 0; i < kCount; ++i) {
        const __m512 pixel = _mm512_loadu_ps(from + y * row_step + (i * kStride + x) * kLanes);
        sums[i] = _mm512_fmadd_ps(weight, pixel, sums[i]);
      }
    }
  }
  const __m512 least = _mm512_set1_ps(group.least), most = _mm512_set1_ps(group.most);
  for (int i = 0; i < kCount; ++i) {
    const __m512 limited = _mm512_min_ps(_mm512_max_ps(sums[i], least), most);
    _mm512_mask_storeu_ps(to + i * step, group.mask, limited);
  }
}

template <int kKernel, int kStride>
YORB_DEPTHWISE_AVX512 void Convolve(const DepthwiseSize& size, const Group& group, float* to) {
  constexpr int kCount = 5;  // the sizes of YOLO's maps are mostly multiples of it
  const int64_t row_step = PaddedWidth(size) * kLanes;
  for (int64_t y = 0; y < size.out_height; ++y) {
    const float* from = group.padded + y * kStride * row_step;
    float* row = to + y * size.out_width * size.channels;
    int64_t x = 0;
    for (; x + kCount <= size.out_width; x += kCount)
      Pixels<kKernel, kStride, kCount>(group, from + x * kStride * kLanes, row_step, row + x * size.channels,
                                       size.channels);
    for (; x < size.out_width; ++x)
      Pixels<kKernel, kStride, 1>(group, from + x * kStride * kLanes, row_step, row + x * size.channels, size.channels);
  }
}

void ConvolveGroup(const DepthwiseSize& size, const Group& group, float* to) {
  if (size.kernel == 3) {
    size.stride == 1 ? Convolve<3, 1>(size, group, to) : Convolve<3, 2>(size, group, to);
  } else {
    size.stride == 1 ? Convolve<5, 1>(size, group, to) : Convolve<5, 2>(size, group, to);
  }
}

#endif

}  // namespace

bool IsForDepthwise(const DepthwiseSize& size) {
#if defined(YORB_DEPTHWISE_AVX512)
  constexpr int64_t kMostNumbers = 1 << 13;  // 32 KiB, the nearest cache
  const bool is_made = (size.kernel == 3 || size.kernel == 5) && (size.stride == 1 || size.stride == 2);
  const bool is_small = PaddedWidth(size) * PaddedHeight(size) * kLanes <= kMostNumbers;
  return is_made && is_small && __builtin_cpu_supports("avx512f");
#else
  (void)size;
  return false;
#endif
}

Depthwise::Depthwise(const DepthwiseSize& size, const std::vector<float>& weights, const std::vector<float>& bias,
                     float least, float most)
    : size_(size), least_(least), most_(most) {
  const int64_t area = size.kernel * size.kernel;
  weights_.resize(static_cast<size_t>(NumGroups(size) * area * kLanes), 0.f);
  bias_.resize(static_cast<size_t>(NumGroups(size) * kLanes), 0.f);
  std::copy(bias.begin(), bias.end(), bias_.begin());
  for (int64_t channel = 0; channel < size.channels; ++channel) {
    for (int64_t i = 0; i < area; ++i) {
      const int64_t at = (channel / kLanes * area + i) * kLanes + channel % kLanes;
      weights_[static_cast<size_t>(at)] = weights[static_cast<size_t>(channel * area + i)];
    }
  }
  padded_.resize(static_cast<size_t>(PaddedHeight(size) * PaddedWidth(size) * kLanes), 0.f);
}

void Depthwise::Run(const float* picture, float* to) {
#if defined(YORB_DEPTHWISE_AVX512)
  for (int64_t i = 0; i < NumGroups(size_); ++i) {
    const int64_t first = i * kLanes, count = std::min(size_.channels - first, kLanes);
    const auto mask = static_cast<__mmask16>((1U << count) - 1);
    Lay(size_, picture + first, mask, padded_.data());
    const float* weights = weights_.data() + first * size_.kernel * size_.kernel;
    ConvolveGroup(size_, {padded_.data(), weights, bias_.data() + first, least_, most_, mask}, to + first);
  }
#else
  (void)picture, (void)to;
#endif
}

}  // namespace yorb
