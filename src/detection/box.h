// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace yorb {

/// One thing in a picture, in pixels of the picture and within it; right and bottom are the first column and row behind
/// it.
struct Box {
  std::string name;  ///< of the class, as the detector's own list has it
  double confidence = 1;
  double left = 0, top = 0, right = 0, bottom = 0;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

/// The part of a box within a picture of this size; empty (no width or no height) where there is none.
inline Box Cut(Box box, int width, int height) {
  const auto within = [](double value, double most) { return value < 0 ? 0 : value > most ? most : value; };
  box.left = within(box.left, width), box.right = within(box.right, width);
  box.top = within(box.top, height), box.bottom = within(box.bottom, height);
  return box;
}

/// Whether a box covers anything; not so where a corner is no number.
inline bool HasArea(const Box& box) { return box.right > box.left && box.bottom > box.top; }

/// Whether a place in pixels, not their numbers, lies in a box.
inline bool Holds(const Box& box, double x, double y) {
  return x >= box.left && x < box.right && y >= box.top && y < box.bottom;
}

}  // namespace yorb
