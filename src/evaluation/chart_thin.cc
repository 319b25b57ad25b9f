// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/chart_thin.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_set>

namespace yorb {
namespace {

constexpr size_t kFewPoints = 600;    // drawn as they are
constexpr size_t kManyPoints = 6000;  // a path of more points is thinned further
constexpr double kColumn_px = 0.5;
constexpr double kClose_px = 0.25;

bool NeverFalls(const std::vector<SvgPoint>& points) {
  return std::is_sorted(points.begin(), points.end(), [](const SvgPoint& a, const SvgPoint& b) { return a.x < b.x; });
}

std::vector<SvgPoint> ThinCurve(const std::vector<SvgPoint>& points) {
  std::vector<SvgPoint> kept;
  for (size_t begin = 0; begin < points.size();) {
    const double column = std::floor(points[begin].x / kColumn_px);
    size_t end = begin, low = begin, high = begin;
    for (; end < points.size() && std::floor(points[end].x / kColumn_px) == column; ++end) {
      if (points[end].y < points[low].y) low = end;
      if (points[end].y > points[high].y) high = end;
    }
    size_t chosen[] = {begin, low, high, end - 1};
    std::sort(std::begin(chosen), std::end(chosen));
    const auto* const last = std::unique(std::begin(chosen), std::end(chosen));
    for (const size_t* index = chosen; index != last; ++index) kept.push_back(points[*index]);
    begin = end;
  }
  return kept;
}

std::vector<SvgPoint> ThinPath(const std::vector<SvgPoint>& points, double close_px) {
  std::vector<SvgPoint> kept = {points.front()};
  for (const SvgPoint& point : points) {
    if (std::hypot(point.x - kept.back().x, point.y - kept.back().y) >= close_px) kept.push_back(point);
  }
  kept.push_back(points.back());
  return kept;
}

}  // namespace

std::vector<SvgPoint> ThinLine(const std::vector<SvgPoint>& points) {
  if (points.size() <= kFewPoints) return points;
  if (NeverFalls(points)) return ThinCurve(points);
  double close_px = kClose_px;
  std::vector<SvgPoint> kept = ThinPath(points, close_px);
  while (kept.size() > kManyPoints) kept = ThinPath(points, close_px *= 1.5);
  return kept;
}

std::vector<SvgPoint> ThinDots(const std::vector<SvgPoint>& points) {
  std::unordered_set<int64_t> taken;
  std::vector<SvgPoint> kept;
  for (const SvgPoint& point : points) {
    const auto column = static_cast<int64_t>(std::lround(2 * point.x)),
               row = static_cast<int64_t>(std::lround(2 * point.y));
    if (taken.insert(column * 1000003 + row).second) kept.push_back(point);
  }
  return kept;
}

}  // namespace yorb
