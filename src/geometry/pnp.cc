// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/pnp.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

namespace yorb {
namespace {

// Notation of the paper. The unknowns are the distances l = (l1, l2, l3) along unit directions y_i. The law of cosines
// gives three quadrics l^T M_ij l = a_ij with a_ij = |x_i - x_j|^2 and M_ij from b_ij = y_i . y_j.
struct Triangle {
  Eigen::Vector3d a;  ///< squared sides 12, 13, 23
  Eigen::Vector3d b;  ///< cosines between directions 12, 13, 23
};

constexpr int kFirst[] = {0, 0, 1}, kSecond[] = {1, 2, 2};  // the ends of sides 12, 13, 23

Eigen::Matrix3d Quadric(const Triangle& triangle, int side) {
  const int i = kFirst[side], j = kSecond[side];
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  m(i, i) = m(j, j) = 1;
  m(i, j) = m(j, i) = -triangle.b[side];
  return m;
}

/// A real root of c3 x^3 + c2 x^2 + c1 x + c0, the one where the slope is steepest: it is the best determined.
double SteepestCubicRoot(double c3, double c2, double c1, double c0) {
  const double p = c2 / c3, q = c1 / c3, r = c0 / c3;
  const double shift = -p / 3.0, a = q - p * p / 3.0, b = (2.0 * p * p / 27.0 - q / 3.0) * p + r;
  const double discriminant = 0.25 * b * b + a * a * a / 27.0;
  double root;  // of t^3 + a t + b, by Cardano or by its trigonometric form
  if (discriminant >= 0) {
    const double u = std::cbrt(-0.5 * b - std::copysign(std::sqrt(discriminant), b));
    root = u == 0 ? 0 : u - a / (3.0 * u);
  } else {
    const double radius = 2.0 * std::sqrt(-a / 3.0);
    const double angle = std::acos(std::min(1.0, std::max(-1.0, 3.0 * b / (a * radius)))) / 3.0;
    // The outer roots have the steeper slopes; the steepest lies farthest from the inflection.
    const double first = radius * std::cos(angle), last = radius * std::cos(angle + 2.0 * M_PI / 3.0);
    root = std::abs(first) > std::abs(last) ? first : last;
  }
  double x = root + shift;
  for (int k = 0; k < 3; ++k) {
    const double slope = (3.0 * x + 2.0 * p) * x + q;
    const double step = (((x + p) * x + q) * x + r) / slope;
    if (!std::isfinite(step)) break;
    x -= step;
  }
  return x;
}

double TraceOfAdjugateTimes(const Eigen::Matrix3d& m, const Eigen::Matrix3d& n) {
  return n.col(0).dot(m.col(1).cross(m.col(2))) + n.col(1).dot(m.col(2).cross(m.col(0))) +
         n.col(2).dot(m.col(0).cross(m.col(1)));
}

/// Directions of l, up to scale, on the plane with the given normal where the quadric is zero: two at most.
void AddOnPlane(const Eigen::Vector3d& normal, const Eigen::Matrix3d& quadric, std::vector<Eigen::Vector3d>& found) {
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.normalized().cross(u);
  const double uu = u.dot(quadric * u), uv = u.dot(quadric * v), vv = v.dot(quadric * v);
  const double scale = uv * uv + std::abs(uu * vv);
  double discriminant = uv * uv - uu * vv;
  if (discriminant < -1e-10 * scale) return;
  discriminant = std::max(0.0, discriminant);
  const double m = -uv - std::copysign(std::sqrt(discriminant), uv);
  found.push_back(m * u + uu * v);
  found.push_back(vv * u + m * v);
}

/// All l up to scale that satisfy both homogeneous quadrics, by way of the degenerate member of their pencil, which is
/// a pair of planes (section 3 of the paper).
std::vector<Eigen::Vector3d> IntersectCones(const Eigen::Matrix3d& d1, const Eigen::Matrix3d& d2) {
  std::vector<Eigen::Vector3d> found;
  // det(base + g other) = 0 is cubic in g. Three members of the pencil at most are degenerate, so of four tries one at
  // least has a determinant that can be divided by (for equal sides and angles d1 and d2 themselves do not).
  const Eigen::Matrix3d tries[][2] = {{d1, d2},
                                      {d2, -d1},
                                      {M_SQRT1_2 * (d1 - d2), M_SQRT1_2 * (d1 + d2)},
                                      {M_SQRT1_2 * (d1 + d2), M_SQRT1_2 * (d2 - d1)}};
  int best = 0;
  for (int k = 1; k < 4; ++k) {
    if (std::abs(tries[k][1].determinant()) > std::abs(tries[best][1].determinant())) best = k;
  }
  const Eigen::Matrix3d &base = tries[best][0], &other = tries[best][1];
  const double g = SteepestCubicRoot(other.determinant(), TraceOfAdjugateTimes(other, base),
                                     TraceOfAdjugateTimes(base, other), base.determinant());
  if (!std::isfinite(g)) return found;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(base + g * other);
  const Eigen::Vector3d values = eigen.eigenvalues();  // rising; the middle one should be zero
  if (!(values[0] < 0 && values[2] > 0)) return found;
  const double s = std::sqrt(-values[0] / values[2]);
  const Eigen::Vector3d e0 = eigen.eigenvectors().col(0), e2 = eigen.eigenvectors().col(2);
  const Eigen::Matrix3d& second = std::abs(g) < 1 ? other : base;
  AddOnPlane(e2 - s * e0, second, found);
  AddOnPlane(e2 + s * e0, second, found);
  return found;
}

/// Scales l to the triangle's size and polishes it by Newton's method; nothing where a distance is not positive.
std::optional<Eigen::Vector3d> Polish(Eigen::Vector3d l, const Triangle& triangle) {
  if (l.sum() < 0) l = -l;
  if (!(l.minCoeff() > 0)) return std::nullopt;
  const auto error_of = [&](int side, const Eigen::Vector3d& x) {
    const double xi = x[kFirst[side]], xj = x[kSecond[side]];
    return xi * xi + xj * xj - 2.0 * triangle.b[side] * xi * xj;
  };
  l *= std::sqrt(triangle.a.sum() / (error_of(0, l) + error_of(1, l) + error_of(2, l)));
  Eigen::Vector3d error;
  for (int iteration = 0; iteration < 6; ++iteration) {
    Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
    for (int side = 0; side < 3; ++side) {
      const int i = kFirst[side], j = kSecond[side];
      error[side] = error_of(side, l) - triangle.a[side];
      jacobian(side, i) = 2.0 * (l[i] - triangle.b[side] * l[j]);
      jacobian(side, j) = 2.0 * (l[j] - triangle.b[side] * l[i]);
    }
    if (error.cwiseAbs().maxCoeff() < 1e-14 * triangle.a.sum()) break;
    l -= jacobian.inverse() * error;
  }
  if (!l.allFinite() || !(l.minCoeff() > 0)) return std::nullopt;
  for (int side = 0; side < 3; ++side) {
    if (!(std::abs(error_of(side, l) - triangle.a[side]) < 1e-8 * triangle.a.sum())) return std::nullopt;
  }
  return l;
}

/// Right-handed axes of three points: along 12, across in their plane, and its normal. Not finite for points on a line.
Eigen::Matrix3d Axes(const std::array<Eigen::Vector3d, 3>& x) {
  const Eigen::Vector3d along = x[1] - x[0], normal = along.cross(x[2] - x[0]);
  Eigen::Matrix3d axes;
  axes.col(0) = along / along.norm();
  axes.col(2) = normal / normal.norm();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

bool IsTriangle(const std::array<Eigen::Vector3d, 3>& x) {
  const Eigen::Vector3d a = x[1] - x[0], b = x[2] - x[0], c = x[2] - x[1];
  const double longest = std::max({a.squaredNorm(), b.squaredNorm(), c.squaredNorm()});
  return std::isfinite(longest) && a.cross(b).norm() > 1e-7 * longest;  // false for coinciding points, too
}

}  // namespace

std::vector<Rigid3> SolveP3p(const std::array<Eigen::Vector3d, 3>& directions_in_cam,
                             const std::array<Eigen::Vector3d, 3>& points_in_world) {
  std::vector<Rigid3> poses;
  const std::array<Eigen::Vector3d, 3>& x = points_in_world;
  const std::array<Eigen::Vector3d, 3> y = {directions_in_cam[0].normalized(), directions_in_cam[1].normalized(),
                                            directions_in_cam[2].normalized()};
  if (!IsTriangle(x) || !(y[0] + y[1] + y[2]).allFinite()) return poses;
  const Triangle triangle{{(x[0] - x[1]).squaredNorm(), (x[0] - x[2]).squaredNorm(), (x[1] - x[2]).squaredNorm()},
                          {y[0].dot(y[1]), y[0].dot(y[2]), y[1].dot(y[2])}};
  const Eigen::Vector3d a = triangle.a / triangle.a.sum();
  const Eigen::Matrix3d m12 = Quadric(triangle, 0), m13 = Quadric(triangle, 1), m23 = Quadric(triangle, 2);

  poses.reserve(4);
  for (const Eigen::Vector3d& direction : IntersectCones(a[2] * m12 - a[0] * m23, a[2] * m13 - a[1] * m23)) {
    const std::optional<Eigen::Vector3d> l = Polish(direction, triangle);
    if (!l) continue;
    const std::array<Eigen::Vector3d, 3> x_in_cam = {(*l)[0] * y[0], (*l)[1] * y[1], (*l)[2] * y[2]};
    const Eigen::Matrix3d rotation = Axes(x_in_cam) * Axes(x).transpose();
    const Rigid3 pose(rotation, x_in_cam[0] - rotation * x[0]);
    if (pose.IsFinite()) poses.push_back(pose);
  }
  return poses;
}

namespace {

/// The squared error in standard deviations; infinite behind the camera.
double SquaredDeviations(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation, const PnpObservation& o) {
  const Eigen::Vector3d x = rotation * o.x_in_world + translation;
  if (!(x.z() > 0)) return std::numeric_limits<double>::infinity();
  return (x.head<2>() / x.z() - o.point_on_plane).squaredNorm() / (o.deviation * o.deviation);
}

}  // namespace

std::optional<PnpResult> PnpRansac(const std::vector<PnpObservation>& observations, const PnpOptions& options,
                                   Random random) {
  const double bound = options.max_deviations * options.max_deviations;
  const auto solve = [&](const std::array<uint32_t, 3>& sample) {
    std::array<Eigen::Vector3d, 3> directions, points;
    for (size_t k = 0; k < 3; ++k) {
      directions[k] = observations[sample[k]].point_on_plane.homogeneous();
      points[k] = observations[sample[k]].x_in_world;
    }
    return SolveP3p(directions, points);
  };
  const auto score = [&](const Rigid3& pose, double cost_to_beat) {
    const Eigen::Matrix3d rotation = pose.rotation.toRotationMatrix();
    RansacScore result{0, 0};
    for (const PnpObservation& o : observations) {
      const double squared = SquaredDeviations(rotation, pose.translation, o);
      const bool is_inlier = squared <= bound;
      result.num_inliers += is_inlier ? 1 : 0;
      result.cost += is_inlier ? squared : bound;
      if (result.cost >= cost_to_beat) break;
    }
    return result;
  };
  const auto best = Ransac<Rigid3, 3>(observations.size(), options.ransac, random, solve, score);
  if (!best || best->score.num_inliers < static_cast<size_t>(options.min_inliers)) return std::nullopt;

  PnpResult result;
  result.cam_from_world = best->model;
  result.num_inliers = best->score.num_inliers;
  result.iterations = best->iterations;
  const Eigen::Matrix3d rotation = best->model.rotation.toRotationMatrix();
  for (const PnpObservation& o : observations) {
    result.is_inlier.push_back(SquaredDeviations(rotation, best->model.translation, o) <= bound);
  }
  return result;
}

}  // namespace yorb
