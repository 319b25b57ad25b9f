// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/lying_cells.h"

#include <opencv2/imgproc.hpp>

namespace yorb {
namespace {

constexpr float kLeastTangent = 0.6f;  // of the angle to a plane that faces the camera
constexpr float kMostTangent = 12;     // what is steeper is an edge
constexpr float kFocalOfWidth = 0.9f;  // pictures are about 60 degrees wide
constexpr int kReach = 2;              // cells up and down, over which the slope is measured
constexpr int kThin = 5;               // cells; thinner things are not marked
constexpr double kSmallM2 = 0.08;      // as seen from the front; a belly or a lap is no desk

/// Tangent of the slope between two cells of a column, one above the other.
float Tangent(float upper_m, float lower_m, float focal_cells) {
  return 2 * (upper_m - lower_m) / (upper_m + lower_m) * focal_cells / kReach;
}

bool IsLying(const DepthCells& depth, int column, int row, float focal_cells) {
  const float upper = depth.At(column, row - kReach), middle = depth.At(column, row),
              lower = depth.At(column, row + kReach);
  if (upper <= 0 || middle <= 0 || lower <= 0) return false;
  const float above = Tangent(upper, middle, focal_cells), below = Tangent(middle, lower, focal_cells);
  const float half = kLeastTangent / 2;
  return above > half && below > half && above + below > 2 * kLeastTangent && above + below < 2 * kMostTangent;
}

/// Takes out patches that are too small for a desk.
void ClearSmall(cv::Mat& mask, const DepthCells& depth, double focal_cells) {
  cv::Mat labels;
  const int num_labels = cv::connectedComponents(mask, labels, 4, CV_32S);
  std::vector<double> area_m2(static_cast<size_t>(num_labels), 0);
  const auto label_at = [&](int row, int column) { return static_cast<size_t>(labels.at<int>(row, column)); };
  for (int row = 0; row < mask.rows; ++row) {
    for (int column = 0; column < mask.cols; ++column) {
      const double side_m = static_cast<double>(depth.At(column, row)) / focal_cells;
      area_m2[label_at(row, column)] += side_m * side_m;
    }
  }
  for (int row = 0; row < mask.rows; ++row) {
    for (int column = 0; column < mask.cols; ++column) {
      if (area_m2[label_at(row, column)] < kSmallM2) mask.at<uint8_t>(row, column) = 0;
    }
  }
}

}  // namespace

CellMask MarkLying(const DepthCells& depth) {
  CellMask mask(depth.IndexOf(0, depth.rows()), 0);
  if (depth.empty()) return mask;
  const float focal_cells = kFocalOfWidth * static_cast<float>(depth.columns());
  for (int row = kReach; row + kReach < depth.rows(); ++row) {
    for (int column = 0; column < depth.columns(); ++column) {
      if (IsLying(depth, column, row, focal_cells)) mask[depth.IndexOf(column, row)] = kLying;
    }
  }
  cv::Mat cells(depth.rows(), depth.columns(), CV_8UC1, mask.data());
  const cv::Mat square = cv::getStructuringElement(cv::MORPH_RECT, {kThin, kThin});
  cv::morphologyEx(cells, cells, cv::MORPH_CLOSE, cv::getStructuringElement(cv::MORPH_RECT, {3, 3}));  // holes
  cv::morphologyEx(cells, cells, cv::MORPH_OPEN, square);
  ClearSmall(cells, depth, static_cast<double>(focal_cells));
  return mask;
}

}  // namespace yorb
