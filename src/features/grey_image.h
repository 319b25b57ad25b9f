// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace yorb {

/// Grey pixels that somebody else owns. Wide instructions may read up to GreyImage::kPad bytes beyond either end of a
/// row where the pixels belong to a GreyImage.
struct GreyView {
  const uint8_t* pixels = nullptr;  ///< of the upper left corner
  int width = 0, height = 0;
  ptrdiff_t stride = 0;  ///< bytes from row to row

  const uint8_t* Row(int y) const { return pixels + y * stride; }
  bool empty() const { return width <= 0 || height <= 0; }
};

/// Grey pixels with readable bytes around every row. Keeps its memory when the size changes, so that a frame costs no
/// allocation.
class GreyImage {
 public:
  static constexpr int kPad = 64;

  void Resize(int width, int height) {
    width_ = width, height_ = height;
    stride_ = (width + 2 * kPad + 63) / 64 * 64;
    const size_t bytes = static_cast<size_t>(stride_) * static_cast<size_t>(height) + 2 * kPad;
    if (bytes > buffer_.size()) buffer_.resize(bytes);
  }
  uint8_t* Row(int y) { return buffer_.data() + kPad + y * stride_; }
  GreyView View() const { return {buffer_.data() + kPad, width_, height_, stride_}; }

 private:
  std::vector<uint8_t> buffer_;
  int width_ = 0, height_ = 0;
  ptrdiff_t stride_ = 0;
};

}  // namespace yorb
