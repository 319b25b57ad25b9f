// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/pose.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>

#include "optimize/relative_pose.h"
#include "optimize/residuals.h"

namespace yorb {
namespace {

constexpr int kRounds = 4;
constexpr int kMaxIterations = 10;  // a round
constexpr size_t kMinObservations = 3;

/// The observations that take part in one round.
struct Round {
  std::vector<const PoseObservation*> observations;
  const std::vector<PlaneObservation>* planes = nullptr;  // none
  const ExpectedPose* expected = nullptr;                 // nothing
  bool use_huber = true;
};

/// The cost near a pose, as a quadratic of the step.
struct Normal {
  double cost = 0;
  Matrix6d hessian = Matrix6d::Zero();
  Vector6d gradient = Vector6d::Zero();
};

bool IsUsable(const PoseObservation& o) {
  return o.x_in_world.allFinite() && std::isfinite(o.seen.x_px) && std::isfinite(o.seen.y_px) &&
         !std::isinf(o.seen.right_px) && std::isfinite(o.seen.inverse_variance) && o.seen.inverse_variance > 0 &&
         std::isfinite(o.weight) && o.weight >= 0;
}

/// Adds what planes say. The distance of a measured x from its plane is n . (T^-1 x) - d; steps multiply T from the
/// left.
void AddPlanes(const Rigid3& cam_from_world, const std::vector<PlaneObservation>& planes, Normal& normal) {
  constexpr double kHuberSigmas = 1.5;
  const Rigid3 world_from_cam = cam_from_world.Inverse();
  for (const PlaneObservation& plane : planes) {
    const double distance = plane.normal_in_world.dot(world_from_cam * plane.x_in_cam) - plane.offset;
    const double sigmas = distance / plane.sigma_m;
    const Loss loss = RobustLoss(sigmas * sigmas, kHuberSigmas * kHuberSigmas, true);
    const Eigen::Vector3d normal_in_cam = cam_from_world.rotation * plane.normal_in_world;
    Vector6d jacobian;
    jacobian << -plane.x_in_cam.cross(normal_in_cam), -normal_in_cam;
    jacobian /= plane.sigma_m;
    const double weight = plane.weight * loss.weight;
    normal.cost += plane.weight * loss.cost;
    normal.hessian.noalias() += weight * jacobian * jacobian.transpose();
    normal.gradient.noalias() += weight * sigmas * jacobian;
  }
}

/// Adds what was known before.
void AddExpected(const Rigid3& cam_from_world, const ExpectedPose& expected, Normal& normal) {
  const RelativePoseJacobians j = LinearizeRelativePose(expected.cam_from_world, cam_from_world, Rigid3::Identity());
  const Vector6d pull = expected.information * j.error;
  normal.cost += 0.5 * j.error.dot(pull);
  normal.hessian.noalias() += j.by_to.transpose() * expected.information * j.by_to;
  normal.gradient.noalias() += j.by_to.transpose() * pull;
}

Normal LinearizeAt(const Rigid3& cam_from_world, const Round& round, const Projection& projection) {
  const Eigen::Matrix3d rotation = cam_from_world.rotation.toRotationMatrix();
  // Blocks of the Hessian for (rotation, translation), summed apart: plain 3x3 sums stay in registers.
  Eigen::Matrix3d rr = Eigen::Matrix3d::Zero(), rt = rr, tt = rr;
  Eigen::Vector3d r = Eigen::Vector3d::Zero(), t = r;
  Normal normal;
  for (const PoseObservation* o : round.observations) {
    const Eigen::Vector3d x = rotation * o->x_in_world + cam_from_world.translation;
    const Quadratic q = Linearize(x, o->seen, o->weight, round.use_huber, projection);
    normal.cost += q.cost;
    if (!q.has_pull) continue;
    const Eigen::Matrix3d cross = CrossColumns(x, q.hessian);
    tt += q.hessian;
    rt += cross;
    rr += CrossColumns(x, cross.transpose());
    t += q.gradient;
    r += x.cross(q.gradient);
  }
  normal.hessian << rr, rt, rt.transpose(), tt;
  normal.gradient << r, t;
  if (round.planes) AddPlanes(cam_from_world, *round.planes, normal);
  if (round.expected) AddExpected(cam_from_world, *round.expected, normal);
  return normal;
}

/// The damped step: Marquardt's scaling, with a floor for directions that nothing pulls at.
Vector6d Step(const Normal& normal, double damping) {
  Matrix6d damped = normal.hessian;
  const double floor = 1e-9 * normal.hessian.diagonal().maxCoeff() + 1e-12;
  damped.diagonal() += damping * normal.hessian.diagonal().cwiseMax(floor);
  return damped.ldlt().solve(-normal.gradient);
}

/// Levenberg-Marquardt with Nielsen's rule for the damping.
Rigid3 Minimize(Rigid3 pose, const Round& round, const Projection& projection) {
  Normal normal = LinearizeAt(pose, round, projection);
  double damping = 1e-5, growth = 2;
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    const Vector6d step = Step(normal, damping);
    const double predicted = -step.dot(normal.gradient + 0.5 * (normal.hessian * step));
    if (!step.allFinite() || predicted <= 1e-9 * normal.cost + 1e-15) break;
    const Rigid3 trial = Rigid3::FromStep(step) * pose;
    const Normal trial_normal = LinearizeAt(trial, round, projection);
    if (trial_normal.cost < normal.cost) {
      const double gain = (normal.cost - trial_normal.cost) / predicted;
      damping *= std::max(1.0 / 3.0, 1.0 - std::pow(2.0 * gain - 1.0, 3));
      growth = 2;
      pose = trial;
      normal = trial_normal;
    } else {
      damping *= growth;
      growth *= 2;
    }
  }
  return pose;
}

/// Judges every observation by its chi-square.
std::vector<bool> Judge(const Rigid3& pose, const std::vector<PoseObservation>& observations,
                        const std::vector<bool>& is_usable, const Projection& projection) {
  std::vector<bool> is_inlier(observations.size());
  for (size_t k = 0; k < observations.size(); ++k) {
    const PoseObservation& o = observations[k];
    is_inlier[k] = is_usable[k] && Chi2(pose * o.x_in_world, o.seen, projection) <= Chi2Bound(o.seen);
  }
  return is_inlier;
}

Round Select(const std::vector<PoseObservation>& observations, const std::vector<bool>& is_chosen, bool use_huber,
             const std::vector<PlaneObservation>* planes, const ExpectedPose* expected) {
  Round round;
  round.planes = planes;
  round.expected = expected;
  round.use_huber = use_huber;
  round.observations.reserve(observations.size());
  for (size_t k = 0; k < observations.size(); ++k) {
    if (is_chosen[k]) round.observations.push_back(&observations[k]);
  }
  return round;
}

}  // namespace

double PoseEstimate::SigmaOfPlace() const {
  const auto factors = information.ldlt();
  if (factors.info() != Eigen::Success || !(factors.vectorD().minCoeff() > 0))
    return std::numeric_limits<double>::infinity();
  const Matrix6d covariance = factors.solve(Matrix6d::Identity());
  return std::sqrt(covariance.bottomRightCorner<3, 3>().trace());
}

PoseEstimate OptimizePose(const Rigid3& cam_from_world, const std::vector<PoseObservation>& observations,
                          const Projection& projection, const std::vector<PlaneObservation>& planes,
                          const std::optional<ExpectedPose>& expected) {
  PoseEstimate estimate;
  estimate.cam_from_world = cam_from_world;
  estimate.is_inlier.assign(observations.size(), false);
  if (!cam_from_world.IsFinite()) return estimate;

  std::vector<bool> is_usable(observations.size());
  for (size_t k = 0; k < observations.size(); ++k) is_usable[k] = IsUsable(observations[k]);
  std::vector<bool> is_inlier = is_usable;
  Rigid3 pose = cam_from_world;
  for (int k = 0; k < kRounds; ++k) {
    const Round round = Select(observations, is_inlier, k + 1 < kRounds, &planes, expected ? &*expected : nullptr);
    if (round.observations.size() < kMinObservations) return estimate;
    pose = Minimize(pose, round, projection);
    is_inlier = Judge(pose, observations, is_usable, projection);
  }
  const Round inliers = Select(observations, is_inlier, false, nullptr, nullptr);
  if (inliers.observations.size() < kMinObservations) return estimate;

  const Normal normal = LinearizeAt(pose, inliers, projection);
  estimate.cam_from_world = pose;
  estimate.is_inlier = is_inlier;
  estimate.num_inliers = inliers.observations.size();
  estimate.cost = normal.cost;
  estimate.information = normal.hessian;
  Normal held;
  AddPlanes(pose, planes, held);
  if (expected) AddExpected(pose, *expected, held);
  estimate.held_by = held.hessian;
  return estimate;
}

Rigid3 AlignToPlanes(const Rigid3& cam_from_world, const std::vector<PlaneObservation>& planes,
                     const ExpectedPose& expected) {
  Round round;
  round.planes = &planes;
  round.expected = &expected;
  return Minimize(cam_from_world, round, Projection());
}

Matrix6d InformationAt(const Rigid3& cam_from_world, const std::vector<PoseObservation>& observations,
                       const Projection& projection) {
  Round round;
  round.use_huber = false;
  for (const PoseObservation& o : observations) round.observations.push_back(&o);
  return LinearizeAt(cam_from_world, round, projection).hessian;
}

}  // namespace yorb
