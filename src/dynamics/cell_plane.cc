// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/cell_plane.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace yorb {

CellPlaneFit::CellPlaneFit(const CellRange& range)
    : middle_(0.5f * static_cast<float>(range.left + range.right - 1),
              0.5f * static_cast<float>(range.top + range.bottom - 1)),
      half_(0.5f * static_cast<float>(range.right - range.left), 0.5f * static_cast<float>(range.bottom - range.top)) {}

void CellPlaneFit::Add(int column, int row, float metres, float weight) {
  const Eigen::Vector3f place(1, Across(column), (static_cast<float>(row) - middle_.y()) / half_.y());
  squares_ += weight * place * place.transpose();
  products_ += weight / metres * place;
}

CellPlane CellPlaneFit::Solve(float stiffness, float most_turned) const {
  Eigen::Matrix3f stiff = squares_;
  stiff.diagonal().tail<2>().array() += stiffness * weight() + 1e-6f;
  Eigen::Vector3f plane = stiff.ldlt().solve(products_);
  const float most = most_turned * half_.x() * std::abs(plane[0]);
  if (std::abs(plane[1]) > most) {
    plane[1] = std::copysign(most, plane[1]);
    const Eigen::Matrix2f rest{{stiff(0, 0), stiff(0, 2)}, {stiff(2, 0), stiff(2, 2)}};
    const Eigen::Vector2f what_is_left{products_[0] - stiff(0, 1) * plane[1], products_[2] - stiff(2, 1) * plane[1]};
    const Eigen::Vector2f solved = rest.ldlt().solve(what_is_left);
    plane[0] = solved[0], plane[2] = solved[1];
  }
  return {{plane[0] - plane[1] * middle_.x() / half_.x() - plane[2] * middle_.y() / half_.y(), plane[1] / half_.x(),
           plane[2] / half_.y()}};
}

}  // namespace yorb
