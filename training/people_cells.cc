// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/people_cells.h"

#include "core/check.h"
#include "training/scene.h"

namespace yorb {
namespace {

constexpr int kMostUnknown = kPeopleCellPx * kPeopleCellPx / 4;

float LabelCell(const cv::Mat& cell) {
  int num_person = 0, num_unknown = 0;
  for (int y = 0; y < cell.rows; ++y) {
    const auto* row = cell.ptr<uint8_t>(y);
    for (int x = 0; x < cell.cols; ++x) {
      num_person += row[x] == kMaskPerson ? 1 : 0;
      num_unknown += row[x] == kMaskUnknown ? 1 : 0;
    }
  }
  if (num_unknown > kMostUnknown) return kUnlabelledCell;
  return static_cast<float>(num_person) / static_cast<float>(cell.rows * cell.cols - num_unknown);
}

}  // namespace

cv::Mat LabelCells(const cv::Mat& people_mask) {
  YORB_CHECK(people_mask.rows % kPeopleCellPx == 0 && people_mask.cols % kPeopleCellPx == 0,
             "a network's input is cut into whole cells");
  cv::Mat labels(people_mask.rows / kPeopleCellPx, people_mask.cols / kPeopleCellPx, CV_32F);
  for (int y = 0; y < labels.rows; ++y) {
    for (int x = 0; x < labels.cols; ++x) {
      const cv::Rect cell(x * kPeopleCellPx, y * kPeopleCellPx, kPeopleCellPx, kPeopleCellPx);
      labels.at<float>(y, x) = LabelCell(people_mask(cell));
    }
  }
  return labels;
}

}  // namespace yorb
