// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/people_map.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "detection/sigmoid.h"

namespace yorb {
namespace {

/// How one axis of the grid over the picture lies in the network's cells: the place of a cell's middle is scale * index
/// + shift.
struct AxisMap {
  int num_cells = 0;
  double scale = 0, shift = 0;
};

/// `cell_px`: of the network's cells; the scaled picture is `scaled_px` long and begins at `begin_px` of the input.
AxisMap AxisOver(int scaled_px, int begin_px, double cell_px) {
  AxisMap axis;
  axis.num_cells = std::max(1, static_cast<int>(std::lround(scaled_px / cell_px)));
  axis.scale = scaled_px / cell_px / axis.num_cells;
  axis.shift = begin_px / cell_px + 0.5 * axis.scale - 0.5;
  return axis;
}

}  // namespace

bool IsPeopleMap(const TensorView& output) {
  return output.dims.size() == 4 && output.dims[0] == 1 && output.dims[1] == 1 && output.dims[2] > 0 &&
         output.dims[3] > 0;
}

cv::Mat PeopleIn(const TensorView& logits, const Letterbox& fit) {
  const int rows = static_cast<int>(logits.dims[2]), columns = static_cast<int>(logits.dims[3]);
  cv::Mat shares(rows, columns, CV_32FC1);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      shares.at<float>(row, column) = logits.data[row * logits.strides[2] + column * logits.strides[3]];
    }
  }
  Sigmoids(shares.ptr<float>(), shares.ptr<float>(), shares.total());
  cv::patchNaNs(shares, 0);
  const AxisMap x = AxisOver(fit.scaled.width, fit.left, static_cast<double>(fit.input.width) / columns);
  const AxisMap y = AxisOver(fit.scaled.height, fit.top, static_cast<double>(fit.input.height) / rows);
  const cv::Matx23d network_from_picture(x.scale, 0, x.shift, 0, y.scale, y.shift);
  cv::Mat over_picture, people;
  cv::warpAffine(shares, over_picture, network_from_picture, cv::Size(x.num_cells, y.num_cells),
                 cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_REPLICATE);
  over_picture.convertTo(people, CV_8UC1, 255);
  return people;
}

}  // namespace yorb
