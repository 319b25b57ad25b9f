// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/pose_graph.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "optimize/levenberg_marquardt.h"
#include "optimize/relative_pose.h"

namespace yorb {
namespace {

constexpr uint32_t kNone = 0xffffffffu;

/// Half of Huber's loss of a chi-square, and its derivative by half the chi-square.
struct Pull {
  double cost = 0, weight = 0;
};

Pull PullOf(const PoseGraph::Edge& edge, double chi2, double huber_sigmas) {
  const double bound = huber_sigmas * huber_sigmas;
  if (!edge.is_robust || chi2 <= bound) return {0.5 * edge.weight * chi2, edge.weight};
  const double root = std::sqrt(bound * chi2);
  return {edge.weight * (root - 0.5 * bound), edge.weight * bound / root};
}

bool IsUsable(const PoseGraph& graph, const PoseGraph::Edge& edge) {
  return edge.from != edge.to && std::isfinite(edge.weight) && edge.weight > 0 && edge.to_from_from.IsFinite() &&
         graph.poses[edge.from].IsFinite() && graph.poses[edge.to].IsFinite();
}

/// The steps of Levenberg-Marquardt for a pose graph; see `Descend`.
class PoseGraphStepper {
 public:
  PoseGraphStepper(const PoseGraph& graph, const PoseGraphOptions& options);

  double Cost(const std::vector<Rigid3>& poses) const;
  double Linearize(const std::vector<Rigid3>& poses);
  bool Solve(double damping);
  double PredictedDecrease() const { return predicted_decrease_; }
  void Apply(const std::vector<Rigid3>& from, std::vector<Rigid3>& to) const;

 private:
  /// An edge that counts, with its places in the system; none where a pose is fixed.
  struct Tie {
    const PoseGraph::Edge* edge = nullptr;
    uint32_t from = kNone, to = kNone, pair = kNone;
  };

  void NumberFreePoses(const PoseGraph& graph);
  void MakePattern();
  void Add(const Tie& tie, const RelativePoseJacobians& j, double pull);

  const PoseGraphOptions options_;
  Vector6d information_;  // of an edge of weight 1
  std::vector<Tie> ties_;
  std::vector<uint32_t> free_poses_;  // rows of the graph's poses
  std::vector<Matrix6d> hessians_;    // a row a block of the pattern
  std::vector<Vector6d> gradients_;   // a row a free pose
  ReducedSystem system_;
  ReducedSolver solver_;
  double predicted_decrease_ = 0;
};

PoseGraphStepper::PoseGraphStepper(const PoseGraph& graph, const PoseGraphOptions& options) : options_(options) {
  information_.head<3>().setConstant(1.0 / (options.rotation_sigma_rad * options.rotation_sigma_rad));
  information_.tail<3>().setConstant(1.0 / (options.translation_sigma * options.translation_sigma));
  for (const PoseGraph::Edge& edge : graph.edges) {
    if (IsUsable(graph, edge)) ties_.push_back({&edge});
  }
  NumberFreePoses(graph);
  MakePattern();
  hessians_.resize(system_.pattern.blocks.size());
  gradients_.resize(free_poses_.size());
  system_.right.resize(free_poses_.size());
  solver_ = ReducedSolver(system_.pattern);
}

void PoseGraphStepper::NumberFreePoses(const PoseGraph& graph) {
  std::vector<bool> is_free(graph.poses.size(), false);
  for (const Tie& tie : ties_) {
    for (const uint32_t pose : {tie.edge->from, tie.edge->to}) is_free[pose] = !graph.is_fixed[pose];
  }
  std::vector<uint32_t> free_of_pose(graph.poses.size(), kNone);
  for (uint32_t pose = 0; pose < graph.poses.size(); ++pose) {
    if (!is_free[pose]) continue;
    free_of_pose[pose] = static_cast<uint32_t>(free_poses_.size());
    free_poses_.push_back(pose);
  }
  for (Tie& tie : ties_) {
    tie.from = free_of_pose[tie.edge->from];
    tie.to = free_of_pose[tie.edge->to];
  }
}

void PoseGraphStepper::MakePattern() {
  BlockPattern& pattern = system_.pattern;
  pattern.size = static_cast<uint32_t>(free_poses_.size());
  for (uint32_t k = 0; k < pattern.size; ++k) pattern.blocks.emplace_back(k, k);
  const auto pair_of = [](const Tie& tie) { return std::minmax(tie.from, tie.to); };
  std::vector<std::pair<uint32_t, uint32_t>> pairs;
  for (const Tie& tie : ties_) {
    if (tie.from != kNone && tie.to != kNone) pairs.push_back(pair_of(tie));
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  for (Tie& tie : ties_) {
    if (tie.from == kNone || tie.to == kNone) continue;
    const auto place = std::lower_bound(pairs.begin(), pairs.end(), std::pair<uint32_t, uint32_t>(pair_of(tie)));
    tie.pair = pattern.size + static_cast<uint32_t>(place - pairs.begin());
  }
  pattern.blocks.insert(pattern.blocks.end(), pairs.begin(), pairs.end());
}

double PoseGraphStepper::Cost(const std::vector<Rigid3>& poses) const {
  double cost = 0;
  for (const Tie& tie : ties_) {
    const PoseGraph::Edge& edge = *tie.edge;
    const Vector6d error = RelativePoseError(poses[edge.from], poses[edge.to], edge.to_from_from);
    cost += PullOf(edge, error.dot(information_.cwiseProduct(error)), options_.huber_sigmas).cost;
  }
  return cost;
}

double PoseGraphStepper::Linearize(const std::vector<Rigid3>& poses) {
  std::fill(hessians_.begin(), hessians_.end(), Matrix6d::Zero());
  std::fill(gradients_.begin(), gradients_.end(), Vector6d::Zero());
  double cost = 0;
  for (const Tie& tie : ties_) {
    const PoseGraph::Edge& edge = *tie.edge;
    const RelativePoseJacobians j = LinearizeRelativePose(poses[edge.from], poses[edge.to], edge.to_from_from);
    const Pull pull = PullOf(edge, j.error.dot(information_.cwiseProduct(j.error)), options_.huber_sigmas);
    cost += pull.cost;
    Add(tie, j, pull.weight);
  }
  return cost;
}

void PoseGraphStepper::Add(const Tie& tie, const RelativePoseJacobians& j, double pull) {
  const Vector6d weights = pull * information_;
  const Matrix6d weighted_from = weights.asDiagonal() * j.by_from, weighted_to = weights.asDiagonal() * j.by_to;
  if (tie.from != kNone) {
    hessians_[tie.from].noalias() += j.by_from.transpose() * weighted_from;
    gradients_[tie.from].noalias() += weighted_from.transpose() * j.error;
  }
  if (tie.to != kNone) {
    hessians_[tie.to].noalias() += j.by_to.transpose() * weighted_to;
    gradients_[tie.to].noalias() += weighted_to.transpose() * j.error;
  }
  if (tie.pair == kNone) return;
  if (tie.from < tie.to) {
    hessians_[tie.pair].noalias() += j.by_from.transpose() * weighted_to;
  } else {
    hessians_[tie.pair].noalias() += j.by_to.transpose() * weighted_from;
  }
}

bool PoseGraphStepper::Solve(double damping) {
  system_.blocks = hessians_;
  for (size_t k = 0; k < gradients_.size(); ++k) {
    system_.blocks[k].diagonal() += damping * DampingScale(hessians_[k]);
    system_.right[k] = -gradients_[k];
  }
  if (!solver_.Solve(system_)) return false;
  // The step solves (H + damping * D) * step = -gradient, so the quadratic falls by the following.
  predicted_decrease_ = 0;
  for (uint32_t k = 0; k < gradients_.size(); ++k) {
    const Vector6d step = solver_.Solution(k);
    const Vector6d scaled = DampingScale(hessians_[k]).cwiseProduct(step);
    predicted_decrease_ += 0.5 * step.dot(damping * scaled - gradients_[k]);
  }
  return std::isfinite(predicted_decrease_);
}

void PoseGraphStepper::Apply(const std::vector<Rigid3>& from, std::vector<Rigid3>& to) const {
  for (uint32_t k = 0; k < free_poses_.size(); ++k) {
    to[free_poses_[k]] = Rigid3::FromStep(solver_.Solution(k)) * from[free_poses_[k]];
  }
}

}  // namespace

PoseGraphResult AdjustPoseGraph(const PoseGraph& graph, const PoseGraphOptions& options,
                                const std::function<bool()>& should_stop) {
  YORB_CHECK(graph.is_fixed.size() == graph.poses.size(), "is_fixed needs a row a pose");
  for (const PoseGraph::Edge& edge : graph.edges) {
    YORB_CHECK(edge.from < graph.poses.size() && edge.to < graph.poses.size(), "an edge of no row");
  }
  PoseGraphStepper stepper(graph, options);
  PoseGraphResult result;
  result.poses = graph.poses;
  result.initial_cost = stepper.Cost(result.poses);
  // The longer a chain of poses, the weaker what bends it as a whole: damping must begin far below that.
  const DescentOptions descent{options.max_iterations, options.relative_tolerance, 1e-10, 1e-12};
  const Descent end = Descend(stepper, descent, should_stop, result.poses);
  result.iterations = end.iterations;
  result.was_stopped = end.was_stopped;
  result.final_cost = stepper.Cost(result.poses);
  return result;
}

}  // namespace yorb
