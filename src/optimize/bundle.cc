// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/bundle.h"

#include <cmath>
#include <utility>

#include "core/check.h"
#include "optimize/bundle_step.h"
#include "optimize/levenberg_marquardt.h"

namespace yorb {
namespace {

void CheckRows(const BundleProblem& problem) {
  YORB_CHECK(problem.is_fixed.size() == problem.poses.size(), "is_fixed needs a row a pose");
  for (const BundleProblem::Seen& seen : problem.seen) {
    YORB_CHECK(seen.pose < problem.poses.size() && seen.point < problem.points.size(), "an observation of no row");
  }
  for (const BundleProblem::Tie& tie : problem.ties) {
    YORB_CHECK(tie.from < problem.poses.size() && tie.to < problem.poses.size(), "a tie of no row");
  }
}

/// Observations that are whole: nothing in them, in their pose or in their point is NaN or infinite.
std::vector<bool> FindUsable(const BundleProblem& problem) {
  std::vector<bool> is_usable(problem.seen.size());
  for (size_t k = 0; k < problem.seen.size(); ++k) {
    const BundleProblem::Seen& seen = problem.seen[k];
    const Observation& o = seen.observation;
    is_usable[k] = std::isfinite(o.x_px) && std::isfinite(o.y_px) && !std::isinf(o.right_px) &&
                   std::isfinite(o.inverse_variance) && o.inverse_variance > 0 && problem.poses[seen.pose].IsFinite() &&
                   problem.points[seen.point].allFinite();
  }
  return is_usable;
}

std::vector<bool> FindInliers(const BundleProblem& problem, const std::vector<bool>& is_usable,
                              const BundleValues& values) {
  std::vector<bool> is_inlier(problem.seen.size());
  for (size_t k = 0; k < problem.seen.size(); ++k) {
    const BundleProblem::Seen& seen = problem.seen[k];
    const Eigen::Vector3d x = values.poses[seen.pose] * values.points[seen.point];
    is_inlier[k] = is_usable[k] && Chi2(x, seen.observation, problem.projection) <= Chi2Bound(seen.observation);
  }
  return is_inlier;
}

}  // namespace

BundleResult AdjustBundle(const BundleProblem& problem, const BundleOptions& options,
                          const std::function<bool()>& should_stop) {
  CheckRows(problem);
  const std::vector<bool> is_usable = FindUsable(problem);
  BundleValues values{problem.poses, problem.points};
  BundleResult result;

  const BundleStructure whole = MakeBundleStructure(problem, is_usable);
  BundleStepper stepper(problem.projection);
  stepper.Begin(whole, true);
  result.initial_cost = stepper.Cost(values);
  Descent round = Descend(stepper, {options.first_iterations, options.relative_tolerance}, should_stop, values);
  result.iterations = round.iterations;
  std::vector<bool> is_inlier = FindInliers(problem, is_usable, values);
  int left = options.second_iterations;
  for (int k = 0; k < options.second_rounds && left > 0 && !round.was_stopped; ++k) {
    const BundleStructure clean = MakeBundleStructure(problem, is_inlier);
    stepper.Begin(clean, false);
    round = Descend(stepper, {left, options.relative_tolerance}, should_stop, values);
    result.iterations += round.iterations;
    left -= round.iterations;
    std::vector<bool> was_inlier = FindInliers(problem, is_usable, values);
    was_inlier.swap(is_inlier);
    if (is_inlier == was_inlier) break;
  }
  result.was_stopped = round.was_stopped;
  stepper.Begin(whole, true);
  result.final_cost = stepper.Cost(values);
  result.is_outlier = std::move(is_inlier);
  result.is_outlier.flip();
  result.poses = std::move(values.poses);
  result.points = std::move(values.points);
  return result;
}

}  // namespace yorb
