// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/rpe.h"

#include <algorithm>
#include <cmath>

#include "evaluation/associate.h"

namespace yorb {
namespace {

constexpr double kDegrees = 180.0 / 3.14159265358979323846;

/// The place of the nearest value by TUM's binary search: of equally near ones, the one it comes by first.
size_t FindClosest(const std::vector<double>& rising, double wanted) {
  size_t begin = 0, end = rising.size(), best = 0;
  double difference = std::abs(rising[0] - wanted);
  while (begin < end) {
    const size_t middle = (begin + end) / 2;
    if (std::abs(rising[middle] - wanted) < difference) {
      difference = std::abs(rising[middle] - wanted);
      best = middle;
    }
    if (rising[middle] == wanted) return middle;
    if (rising[middle] > wanted) {
      end = middle;
    } else {
      begin = middle + 1;
    }
  }
  return best;
}

std::vector<double> Seconds(const Trajectory& trajectory) {
  std::vector<double> seconds;
  for (const StampedPose& pose : trajectory) seconds.push_back(TumSeconds(pose.timestamp));
  return seconds;
}

/// Where each pose stands on the axis that `delta` is counted on: its time, the metres travelled so far, or its row.
std::vector<double> Positions(const Trajectory& estimate, const RpeOptions& options) {
  if (options.unit == RpeUnit::kSeconds) return Seconds(estimate);
  std::vector<double> positions = {0};
  for (size_t i = 1; i < estimate.size(); ++i) {
    const Eigen::Vector3d step = estimate[i].world_from_cam.translation - estimate[i - 1].world_from_cam.translation;
    positions.push_back(positions.back() + (options.unit == RpeUnit::kFrames ? 1 : options.scale * step.norm()));
  }
  return positions;
}

/// The true poses that belong to the estimated ones.
class Truth {
 public:
  Truth(const Trajectory& reference, double offset)
      : reference_(reference), stamps_(Seconds(reference)), offset_(offset) {
    std::vector<double> steps;
    for (size_t i = 1; i < stamps_.size(); ++i) steps.push_back(stamps_[i] - stamps_[i - 1]);
    farthest_ = 2 * Quantile(std::move(steps), 0.5);
  }

  /// The nearest true pose; null where it is too far in time.
  const Rigid3* At(Timestamp estimated) const {
    const double wanted = TumSeconds(estimated) + offset_;
    const size_t index = FindClosest(stamps_, wanted);
    return std::abs(stamps_[index] - wanted) > farthest_ ? nullptr : &reference_[index].world_from_cam;
  }

 private:
  const Trajectory& reference_;
  std::vector<double> stamps_;
  double offset_;
  double farthest_ = 0;  ///< seconds
};

}  // namespace

RelativeError ComputeRelativeError(const Trajectory& reference, const Trajectory& estimate, const RpeOptions& options) {
  RelativeError result;
  if (reference.size() < 2 || estimate.size() < 2) return result;
  const Truth truth(reference, options.offset);
  const std::vector<double> positions = Positions(estimate, options);
  for (size_t i = 0; i < estimate.size(); ++i) {
    const size_t j = FindClosest(positions, positions[i] + options.delta);
    if (j + 1 == estimate.size()) continue;
    const Rigid3 *true_first = truth.At(estimate[i].timestamp), *true_second = truth.At(estimate[j].timestamp);
    if (true_first == nullptr || true_second == nullptr) continue;
    Rigid3 second_from_first = estimate[j].world_from_cam.Inverse() * estimate[i].world_from_cam;
    second_from_first.translation *= options.scale;
    const Rigid3 error = second_from_first.Inverse() * (true_second->Inverse() * *true_first);
    result.translation.push_back(error.translation.norm());
    result.rotation_deg.push_back(kDegrees * error.RotationAngle());
    const double distance = positions[j] - positions[i];
    result.num_odd += distance < 0.5 * options.delta || distance > 2 * options.delta;
  }
  result.translation_summary = Summarize(result.translation);
  result.rotation_summary = Summarize(result.rotation_deg);
  return result;
}

}  // namespace yorb
