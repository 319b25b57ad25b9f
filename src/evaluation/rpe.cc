// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/rpe.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "evaluation/ate.h"

namespace yorb {
namespace {

constexpr double kDegrees = 180.0 / 3.14159265358979323846;
constexpr double kLongestDelta = 1e9;  // seconds: beyond any recording, and safe to add in nanoseconds

template <typename T>
T Distance(T a, T b) {
  return a < b ? b - a : a - b;
}

/// The place of the nearest value by TUM's binary search: of equally near ones, the one it comes by first.
template <typename T>
size_t FindClosest(const std::vector<T>& rising, T wanted) {
  size_t begin = 0, end = rising.size(), best = 0;
  T difference = Distance(rising[0], wanted);
  while (begin < end) {
    const size_t middle = (begin + end) / 2;
    if (Distance(rising[middle], wanted) < difference) {
      difference = Distance(rising[middle], wanted);
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

std::vector<int64_t> Nanoseconds(const Trajectory& trajectory, int64_t offset_ns) {
  std::vector<int64_t> stamps;
  for (const Timestamp stamp : StampsOf(trajectory, offset_ns)) stamps.push_back(stamp.ns);
  return stamps;
}

/// Metres travelled, or rows, up to each pose.
std::vector<double> Positions(const Trajectory& estimate, const RpeOptions& options) {
  std::vector<double> positions;
  for (size_t i = 0; i < estimate.size(); ++i) {
    if (options.unit == RpeUnit::kFrames) {
      positions.push_back(static_cast<double>(i));
    } else if (i == 0) {
      positions.push_back(0);
    } else {
      const Eigen::Vector3d step = estimate[i].world_from_cam.translation - estimate[i - 1].world_from_cam.translation;
      positions.push_back(positions.back() + options.scale * step.norm());
    }
  }
  return positions;
}

/// The partner of every pose of the estimate.
struct Partners {
  std::vector<size_t> index;
  std::vector<double> distance;  ///< in the unit of `delta`
};

Partners FindPartners(const Trajectory& estimate, const RpeOptions& options) {
  Partners partners;
  if (options.unit == RpeUnit::kSeconds) {
    const std::vector<int64_t> stamps = Nanoseconds(estimate, 0);
    const auto delta_ns = static_cast<int64_t>(std::llround(1e9 * std::min(options.delta, kLongestDelta)));
    for (const int64_t stamp : stamps) {
      partners.index.push_back(FindClosest(stamps, stamp + delta_ns));
      partners.distance.push_back(1e-9 * static_cast<double>(stamps[partners.index.back()] - stamp));
    }
    return partners;
  }
  const std::vector<double> positions = Positions(estimate, options);
  for (const double position : positions) {
    partners.index.push_back(FindClosest(positions, position + options.delta));
    partners.distance.push_back(positions[partners.index.back()] - position);
  }
  return partners;
}

/// The true poses that belong to the estimated ones.
class Truth {
 public:
  Truth(const Trajectory& reference, int64_t offset_ns)
      : reference_(reference), stamps_(Nanoseconds(reference, 0)), offset_ns_(offset_ns) {
    std::vector<int64_t> steps;
    for (size_t i = 1; i < stamps_.size(); ++i) steps.push_back(stamps_[i] - stamps_[i - 1]);
    std::sort(steps.begin(), steps.end());
    if (!steps.empty()) twice_median_ns_ = steps[(steps.size() - 1) / 2] + steps[steps.size() / 2];
  }

  /// The nearest true pose; null where it is too far in time.
  const Rigid3* At(Timestamp estimated) const {
    const int64_t wanted = estimated.ns + offset_ns_;
    const size_t index = FindClosest(stamps_, wanted);
    if (Distance(stamps_[index], wanted) > twice_median_ns_) return nullptr;
    return &reference_[index].world_from_cam;
  }

 private:
  const Trajectory& reference_;
  std::vector<int64_t> stamps_;
  int64_t offset_ns_;
  int64_t twice_median_ns_ = 0;
};

}  // namespace

RelativeError ComputeRelativeError(const Trajectory& reference, const Trajectory& estimate, const RpeOptions& options) {
  RelativeError result;
  if (reference.size() < 2 || estimate.size() < 2) return result;
  const Truth truth(reference, options.offset_ns);
  const Partners partners = FindPartners(estimate, options);
  for (size_t i = 0; i < estimate.size(); ++i) {
    const size_t j = partners.index[i];
    if (j + 1 == estimate.size()) continue;
    const Rigid3 *true_first = truth.At(estimate[i].timestamp), *true_second = truth.At(estimate[j].timestamp);
    if (true_first == nullptr || true_second == nullptr) continue;
    Rigid3 second_from_first = estimate[j].world_from_cam.Inverse() * estimate[i].world_from_cam;
    second_from_first.translation *= options.scale;
    const Rigid3 error = second_from_first.Inverse() * (true_second->Inverse() * *true_first);
    result.translation.push_back(error.translation.norm());
    result.rotation_deg.push_back(kDegrees * error.RotationAngle());
    result.num_odd += partners.distance[i] < 0.5 * options.delta || partners.distance[i] > 2 * options.delta;
  }
  result.translation_summary = Summarize(result.translation);
  result.rotation_summary = Summarize(result.rotation_deg);
  return result;
}

}  // namespace yorb
