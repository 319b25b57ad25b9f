// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/seen_people.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace yorb {
namespace {

constexpr int kLikely = 128;         // of 255, in the map
constexpr size_t kLeastCells = 12;   // of a surface
constexpr float kStepM = 0.02f;      // from cell to cell of one surface,
constexpr float kStepShare = 0.02f;  // and of the depth

bool IsOneSurface(float metres, float beside_m) {
  return beside_m > 0 && std::abs(metres - beside_m) <= kStepM + kStepShare * metres;
}

/// Finds the surfaces of a depth picture one after the other; each cell belongs to one at most.
class SurfaceFinder {
 public:
  /// `known`: cells that are not 0 belong to none.
  SurfaceFinder(const DepthCells& depth, const CellMask& known) : depth_(depth), is_taken_(known) {}

  /// All that hangs together with a cell; nothing where it is taken, or not measured. Valid until the next call.
  const std::vector<size_t>& TakeFrom(int column, int row) {
    surface_.clear();
    if (depth_.At(column, row) > 0) Take(column, row);
    for (size_t next = 0; next < surface_.size(); ++next) {
      const int x = static_cast<int>(surface_[next]) % depth_.columns();
      const int y = static_cast<int>(surface_[next]) / depth_.columns();
      const float metres = depth_.At(x, y);
      if (x > 0 && IsOneSurface(metres, depth_.At(x - 1, y))) Take(x - 1, y);
      if (x + 1 < depth_.columns() && IsOneSurface(metres, depth_.At(x + 1, y))) Take(x + 1, y);
      if (y > 0 && IsOneSurface(metres, depth_.At(x, y - 1))) Take(x, y - 1);
      if (y + 1 < depth_.rows() && IsOneSurface(metres, depth_.At(x, y + 1))) Take(x, y + 1);
    }
    return surface_;
  }

 private:
  void Take(int column, int row) {
    const size_t cell = depth_.IndexOf(column, row);
    if (is_taken_[cell] != 0) return;
    is_taken_[cell] = 1;
    surface_.push_back(cell);
  }

  const DepthCells& depth_;
  CellMask is_taken_;
  std::vector<size_t> surface_;
};

}  // namespace

bool ShowsSomebody(const cv::Mat& people) {
  double most = 0;
  if (!people.empty()) cv::minMaxLoc(people, nullptr, &most);
  return most >= kLikely;
}

CellMask WithSeenPeople(CellMask mask, const DepthCells& depth, const cv::Mat& people) {
  if (depth.empty() || !ShowsSomebody(people)) return mask;
  cv::Mat fine;
  cv::resize(people, fine, cv::Size(depth.columns(), depth.rows()), 0, 0, cv::INTER_LINEAR);
  SurfaceFinder surfaces(depth, mask);
  for (int row = 0; row < depth.rows(); ++row) {
    for (int column = 0; column < depth.columns(); ++column) {
      const std::vector<size_t>& surface = surfaces.TakeFrom(column, row);
      if (surface.size() < kLeastCells) continue;
      size_t sum = 0;
      for (const size_t cell : surface) sum += fine.data[cell];
      if (sum < kLikely * surface.size()) continue;
      for (const size_t cell : surface) mask[cell] = kBody;
    }
  }
  return mask;
}

}  // namespace yorb
