// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/cell_plane.h"

#include <Eigen/Cholesky>

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

CellPlane CellPlaneFit::Solve(float stiffness) const {
  Eigen::Matrix3f stiff = squares_;
  stiff.diagonal().tail<2>().array() += stiffness * weight() + 1e-6f;
  const Eigen::Vector3f plane = stiff.ldlt().solve(products_);
  return {{plane[0] - plane[1] * middle_.x() / half_.x() - plane[2] * middle_.y() / half_.y(), plane[1] / half_.x(),
           plane[2] / half_.y()}};
}

}  // namespace yorb
