// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/depth_grid.h"

#include <algorithm>
#include <cmath>

#include "camera/mask.h"

namespace yorb {
namespace {

constexpr float kNothing = 1e6f;     // metres: beyond any camera
constexpr float kFarthest = 6;       // metres: beyond, depth sensors guess
constexpr int kLeastNeighbours = 6;  // of nine cells, to know that a place is free
constexpr int kLeastSamples = 3;     // of a cell

/// Whether what was measured in a cell belongs to one surface.
bool IsOneSurface(float nearest, float farthest) {
  constexpr float kBase = 0.03f, kSlope = 0.04f;
  return farthest < kFarthest && farthest - nearest < kBase + kSlope * farthest;
}

/// Up to where a cell and all about it are free: the least of nine.
std::vector<float> FreeOf(const std::vector<float>& nearest, int columns, int rows) {
  std::vector<float> free(nearest.size(), 0.f);
  for (int row = 1; row + 1 < rows; ++row) {
    for (int column = 1; column + 1 < columns; ++column) {
      const int at = row * columns + column;
      if (nearest[static_cast<size_t>(at)] <= 0) continue;
      float least = kNothing;
      int num_known = 0;
      for (const int above : {at - columns, at, at + columns}) {
        for (int i = above - 1; i <= above + 1; ++i) {
          const float metres = nearest[static_cast<size_t>(i)];
          num_known += metres > 0;
          if (metres > 0) least = std::min(least, metres);
        }
      }
      if (num_known >= kLeastNeighbours) free[static_cast<size_t>(at)] = least;
    }
  }
  return free;
}

}  // namespace

DepthGridMaker::DepthGridMaker(const Rig& rig)
    : width_(rig.camera.width),
      height_(rig.camera.height),
      columns_(rig.camera.width / kGridCellPx),
      rows_(rig.camera.height / kGridCellPx) {
  constexpr double kOffsets[kSamples][2] = {{-2, -2}, {2, -2}, {-2, 2}, {2, 2}};
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      for (const auto& offset : kOffsets) {
        const double half = 0.5 * (kGridCellPx - 1);
        const Eigen::Vector2d px =
            rig.camera.Distort({column * kGridCellPx + half + offset[0], row * kGridCellPx + half + offset[1]});
        pixels_.emplace_back(static_cast<int>(std::clamp(px.x() + 0.5, 0.0, width_ - 1.0)),
                             static_cast<int>(std::clamp(px.y() + 0.5, 0.0, height_ - 1.0)));
      }
    }
  }
}

DepthGrid DepthGridMaker::Make(const DepthImage& depth, const cv::Mat& moving) const {
  DepthGrid grid;
  if (depth.empty() || depth.pixels.cols != width_ || depth.pixels.rows != height_) return grid;
  grid.columns = columns_;
  grid.rows = rows_;
  grid.surface.resize(static_cast<size_t>(grid.size()), 0.f);
  std::vector<float> nearest(grid.surface.size(), 0.f);
  for (size_t cell = 0; cell < nearest.size(); ++cell) {
    float least = kNothing, most = 0;
    int num_measured = 0;
    for (size_t i = kSamples * cell; i < kSamples * (cell + 1); ++i) {
      const float metres = depth.At(pixels_[i].x, pixels_[i].y);
      if (metres <= 0 || IsMarked(moving, pixels_[i], depth.pixels.size())) continue;
      ++num_measured;
      least = std::min(least, metres);
      most = std::max(most, metres);
    }
    if (num_measured < kLeastSamples) continue;
    nearest[cell] = least;
    if (IsOneSurface(least, most)) grid.surface[cell] = 0.5f * (least + most);
  }
  grid.free = FreeOf(nearest, columns_, rows_);
  return grid;
}

}  // namespace yorb
