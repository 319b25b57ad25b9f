// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/depth_watch.h"

#include <algorithm>
#include <cmath>

#include "core/log.h"
#include "core/stats.h"
#include "core/text.h"

namespace yorb {
namespace {

constexpr double kNearest = 0.1, kFarthest = 30;  // metres between which a typical depth lies
constexpr double kUsableShare = 0.01;             // of the pixels, below which a depth picture counts as empty
constexpr size_t kJudgedAfter = 5;                // frames with depth
constexpr int kSamplesAcross = 40;

bool IsPlausible(double median_m) { return median_m >= kNearest && median_m <= kFarthest; }

/// For those who gave the metres of a unit, as RealSense's depth scale is, in place of the units of a metre.
std::string InverseOf(double depth_factor) {
  const double inverse = 1 / depth_factor, whole = std::round(inverse);
  return FormatShortest(std::abs(inverse - whole) < 1e-6 * inverse ? whole : inverse);
}

}  // namespace

DepthGlance GlanceAt(const DepthImage& depth) {
  DepthGlance glance;
  if (depth.empty()) return glance;
  glance.has_picture = true;
  glance.is_float = depth.pixels.type() == CV_32FC1;
  // Units count as measured whatever the factor makes of them: where it is wrong, that is what must be told.
  const auto metres_at = [&](int x, int y) { return glance.is_float ? depth.At(x, y) : depth.StoredMetres(x, y); };
  std::vector<double> measured;
  const int step = std::max(1, depth.pixels.cols / kSamplesAcross);
  size_t num_looked_at = 0;
  for (int y = step / 2; y < depth.pixels.rows; y += step) {
    for (int x = step / 2; x < depth.pixels.cols; x += step, ++num_looked_at) {
      if (const double metres = metres_at(x, y); metres > 0) measured.push_back(metres);
    }
  }
  if (measured.empty()) return glance;
  glance.measured_share = static_cast<double>(measured.size()) / static_cast<double>(num_looked_at);
  std::nth_element(measured.begin(), measured.begin() + measured.size() / 2, measured.end());
  glance.median_m = measured[measured.size() / 2];
  return glance;
}

std::string DepthWatch::FactorComplaint(double median_m, bool is_float, double depth_factor,
                                        const std::string& camera) {
  if (IsPlausible(median_m)) return "";
  const std::string start = "median depth is " + FormatFixed(median_m, median_m < 1 ? 5 : 1) + " m";
  if (is_float) return start + ": float depth pictures must hold metres";
  const bool is_inverse = depth_factor < 1 && IsPlausible(median_m * depth_factor * depth_factor);
  return start + " with the depth factor " + FormatShortest(depth_factor) + " of camera " + camera +
         (is_inverse ? ": depth_factor is units per metre: " + InverseOf(depth_factor) + ", not metres per unit"
                     : ": check it (1000 where the pictures hold millimetres, 5000 for TUM's)");
}

void DepthWatch::Add(const LoadedFrame& frame) {
  ++num_frames_;
  if (!frame.depth.has_picture || frame.depth.measured_share < kUsableShare || is_judged_) return;
  medians_m_.push_back(frame.depth.median_m);
  has_seen_any_ |= frame.depth.median_m < DepthImage::kBeyondAnyCamera;
  is_float_ = frame.depth.is_float;
  if (medians_m_.size() >= kJudgedAfter) JudgeFactor();
}

void DepthWatch::Conclude(bool needs_depth) {
  if (medians_m_.empty() && num_frames_ > 0 && needs_depth) {
    LogWarning("no-depth", "no usable depth in any of the " + std::to_string(num_frames_) +
                               " frames read: without depth no map begins or grows; check the depth pictures");
  } else if (!is_judged_ && !medians_m_.empty()) {
    JudgeFactor();
  }
}

void DepthWatch::JudgeFactor() {
  is_judged_ = true;
  const std::string complaint = FactorComplaint(Quantile(medians_m_, 0.5), is_float_, depth_factor_, camera_);
  if (!complaint.empty()) LogWarning("depth-factor", complaint);
}

}  // namespace yorb
