// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace yorb {

/// What Marquardt's damping adds to a diagonal, for a damping of one: the diagonal, with a floor for directions that
/// nothing pulls at (a point without depth along its ray, a pose with too few points).
template <typename Matrix>
auto DampingScale(const Matrix& hessian) {
  using Vector = Eigen::Matrix<double, Matrix::RowsAtCompileTime, 1>;
  const Vector diagonal = hessian.diagonal();
  return Vector(diagonal.cwiseMax(1e-6 * diagonal.maxCoeff() + 1e-9));
}

struct DescentOptions {
  int max_iterations = 10;
  double relative_tolerance = 1e-6;  ///< it ends when a step lowers the cost by less than this fraction
  double first_damping = 1e-5;       ///< in units of DampingScale
  double least_damping = 1e-9;
};

/// How a descent ended.
struct Descent {
  int iterations = 0;
  bool was_stopped = false;
};

/// Levenberg-Marquardt with Nielsen's rule for the damping. A `Stepper` has `Linearize(values)` and `Cost(values)`,
/// which give the cost, `Solve(damping)`, `PredictedDecrease()` and `Apply(from, to)`. `values` are the best so far at
/// any time; `should_stop` may be empty.
template <typename Stepper, typename Values>
Descent Descend(Stepper& stepper, const DescentOptions& options, const std::function<bool()>& should_stop,
                Values& values) {
  constexpr double kMostDamping = 1e12;
  Descent descent;
  Values trial = values;
  double cost = stepper.Linearize(values);
  double damping = options.first_damping, growth = 2;
  for (; descent.iterations < options.max_iterations && damping < kMostDamping; ++descent.iterations) {
    descent.was_stopped = should_stop && should_stop();
    if (descent.was_stopped) break;
    double decrease = -1;
    if (stepper.Solve(damping)) {
      if (stepper.PredictedDecrease() <= 1e-3 * options.relative_tolerance * cost) break;
      stepper.Apply(values, trial);
      decrease = cost - stepper.Cost(trial);
    }
    if (!(decrease > 0)) {
      damping *= growth;
      growth *= 2;
      continue;
    }
    std::swap(values, trial);
    const bool is_done = decrease <= options.relative_tolerance * cost;
    const double gain = decrease / stepper.PredictedDecrease();
    damping = std::max(options.least_damping, damping * std::max(1.0 / 3.0, 1.0 - std::pow(2.0 * gain - 1.0, 3)));
    growth = 2;
    if (is_done) {
      ++descent.iterations;
      break;
    }
    cost = stepper.Linearize(values);
  }
  return descent;
}

}  // namespace yorb
