// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/triangulate.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace yorb {
namespace {

using Iterator = const View*;

double WidestParallaxCosine(Iterator begin, Iterator end) {
  double cosine = 1;
  for (Iterator a = begin; a != end; ++a) {
    for (Iterator b = a + 1; b != end; ++b) cosine = std::min(cosine, ParallaxCosine(*a, *b));
  }
  return cosine;
}

double DepthIn(const View& view, const Eigen::Vector3d& x_in_world) { return (view.cam_from_world * x_in_world).z(); }

/// Solves (r1 - u r3) x = u t3 - t1 and the same for v, a pair of rows a view divided by the depth at `previous`.
Eigen::Vector3d Solve(Iterator begin, Iterator end, const Eigen::Vector3d* previous) {
  const Eigen::Vector3d origin = begin->cam_from_world.OriginInSource();  // near the cameras numbers stay small
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (Iterator view = begin; view != end; ++view) {
    const Eigen::Matrix3d r = view->cam_from_world.rotation.toRotationMatrix();
    const Eigen::Vector3d t = view->cam_from_world * origin;
    const double weight = previous ? 1.0 / DepthIn(*view, *previous) : 1.0;
    for (int axis = 0; axis < 2; ++axis) {
      const double u = view->point_on_plane[axis];
      const Eigen::Vector3d row = weight * (r.row(axis) - u * r.row(2)).transpose();
      normal += row * row.transpose();
      right += row * (weight * (u * t.z() - t[axis]));
    }
  }
  return origin + normal.ldlt().solve(right);
}

std::optional<Eigen::Vector3d> TriangulateRange(Iterator begin, Iterator end, double max_parallax_cosine) {
  // Written so that NaN fails too.
  if (end - begin < 2 || !(WidestParallaxCosine(begin, end) < max_parallax_cosine)) return std::nullopt;
  const auto is_in_front = [&](const Eigen::Vector3d& x) {
    return x.allFinite() && std::all_of(begin, end, [&](const View& view) { return DepthIn(view, x) > 0; });
  };
  const Eigen::Vector3d first = Solve(begin, end, nullptr);
  if (!is_in_front(first)) return std::nullopt;
  const Eigen::Vector3d x = Solve(begin, end, &first);
  if (!is_in_front(x)) return std::nullopt;
  return x;
}

}  // namespace

double ParallaxCosine(const View& a, const View& b) { return a.DirectionInWorld().dot(b.DirectionInWorld()); }

double ParallaxCosine(const Eigen::Vector3d& x_in_world, const Eigen::Vector3d& centre_a,
                      const Eigen::Vector3d& centre_b) {
  const Eigen::Vector3d a = x_in_world - centre_a, b = x_in_world - centre_b;
  const double lengths = a.norm() * b.norm();
  return lengths > 0 ? a.dot(b) / lengths : 1.0;
}

std::optional<Eigen::Vector3d> Triangulate(const View& a, const View& b, double max_parallax_cosine) {
  const View views[] = {a, b};
  return TriangulateRange(views, views + 2, max_parallax_cosine);
}

std::optional<Eigen::Vector3d> Triangulate(const std::vector<View>& views, double max_parallax_cosine) {
  return TriangulateRange(views.data(), views.data() + views.size(), max_parallax_cosine);
}

}  // namespace yorb
