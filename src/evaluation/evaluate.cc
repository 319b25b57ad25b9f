// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/evaluate.h"

#include <algorithm>
#include <cmath>

#include "core/stats.h"
#include "core/text.h"
#include "evaluation/associate.h"

namespace yorb {
namespace {

constexpr double kLongestOffset = 4e9;  // seconds; sums with any stamp stay whole
constexpr double kManyOdd = 0.05;       // share of odd RPE pairs worth a word
constexpr double kLongStep = 10;        // seconds between frames: rather counts or another unit
constexpr double kPictureNear = 0.02;   // seconds from a picture to the pose that covers it

int64_t Nanoseconds(double seconds) { return std::llround(1e9 * seconds); }

std::string RangeText(const std::string& path, const Trajectory& poses, int64_t offset_ns) {
  return path + " from " + ToString(Timestamp{poses.front().timestamp.ns + offset_ns}) + " to " +
         ToString(Timestamp{poses.back().timestamp.ns + offset_ns});
}

Error NothingInCommon(const ReadTrajectory& reference, const ReadTrajectory& estimate, const EvalOptions& options) {
  std::string text = "no time stamps in common within " + FormatShortest(options.max_difference) +
                     " s: " + RangeText(estimate.path, estimate.poses, Nanoseconds(options.time_offset)) + ", " +
                     RangeText(reference.path, reference.poses, 0);
  const bool is_apart =
      estimate.poses.back().timestamp.ns + Nanoseconds(options.time_offset) < reference.poses.front().timestamp.ns ||
      reference.poses.back().timestamp.ns < estimate.poses.front().timestamp.ns + Nanoseconds(options.time_offset);
  if (MedianStep(StampsOf(estimate.poses)) > kLongStep || MedianStep(StampsOf(reference.poses)) > kLongStep) {
    text += "; are these seconds?";
  } else {
    text += is_apart ? "; another clock? --time-offset S is added to the estimate" : "; see --max-difference";
  }
  return BadInput(text);
}

/// Whether the poses can be paired: all have stamps, or none has and nothing shifts them.
Status CheckStamps(const ReadTrajectory& reference, const ReadTrajectory& estimate, const EvalOptions& options) {
  if (reference.has_stamps != estimate.has_stamps) {
    return BadInput((reference.has_stamps ? estimate : reference).path +
                    " has rows without time stamps, which cannot be paired with stamped poses");
  }
  if (!estimate.has_stamps && options.time_offset != 0) {
    return BadInput("--time-offset " + FormatShortest(options.time_offset) + ": the rows of " + estimate.path +
                    " have no time stamps that it could move; leave it out");
  }
  return Status::Ok();
}

/// Without stamps nothing but the number of rows can tell that some are missing.
void WarnOfUnlikeRows(const ReadTrajectory& reference, Evaluation& evaluation) {
  const size_t num_true = reference.poses.size(), num_found = evaluation.estimate.size();
  if (reference.has_stamps || num_true == num_found) return;
  evaluation.warnings.push_back(evaluation.estimate_path + " has " + std::to_string(num_found) + " rows, " +
                                reference.path + " " + std::to_string(num_true) +
                                ": without time stamps they are paired by their numbers, from the first on");
}

void WarnOfDegeneracy(Evaluation& evaluation) {
  const std::string start = evaluation.estimate_path + ": ";
  switch (evaluation.ate.reference_from_estimate.degeneracy) {
    case AlignDegeneracy::kOnePlace:
      evaluation.warnings.push_back(start +
                                    "estimate or reference stays in one place: the rotation between them (and a scale) "
                                    "is any, the error is what remains");
      break;
    case AlignDegeneracy::kLine:
      evaluation.warnings.push_back(
          start + "estimate or reference lies on a line: the rotation about it is any, the error is what remains");
      break;
    case AlignDegeneracy::kNone:
    case AlignDegeneracy::kTooFew:
      break;
  }
}

/// How far the poses of some pairs lie from their middle: rmse, metres.
double ExtentOf(const Trajectory& poses, const std::vector<StampPair>& pairs, size_t StampPair::*which) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const StampPair& pair : pairs) middle += poses[pair.*which].world_from_cam.translation;
  middle /= static_cast<double>(pairs.size());
  double sum = 0;
  for (const StampPair& pair : pairs) sum += (poses[pair.*which].world_from_cam.translation - middle).squaredNorm();
  return std::sqrt(sum / static_cast<double>(pairs.size()));
}

/// Millimetres beside metres, which no alignment but a similarity makes good.
void WarnOfMillimetres(const ReadTrajectory& reference, const EvalOptions& options, Evaluation& evaluation) {
  constexpr double kTimes = 1000, kSlack = 1.5, kStuckM = 0.02;  // a tracker that stands still has no unit
  const double truth = ExtentOf(reference.poses, evaluation.pairs, &StampPair::first);
  const double found = ExtentOf(evaluation.estimate, evaluation.pairs, &StampPair::second);
  if (options.align == EvalAlign::kSim3 || truth < kStuckM || found < kStuckM) return;
  const auto is_near = [&](double ratio) { return ratio > kTimes / kSlack && ratio < kTimes * kSlack; };
  if (!is_near(found / truth) && !is_near(truth / found)) return;
  const bool is_found = found > truth;
  evaluation.warnings.push_back(
      (is_found ? evaluation.estimate_path : reference.path) + " extends about 1000 times as far as " +
      (is_found ? reference.path : evaluation.estimate_path) +
      ": is it in millimetres? Positions are metres, and nothing is scaled but by --align sim3");
}

/// The share of the pictures that have a pose near in time, each pose counted once. `offset` seconds are added to the
/// poses' stamps.
double CoverageOf(const std::vector<Timestamp>& pictures, const Trajectory& estimate, double offset) {
  if (pictures.empty()) return 0;
  const size_t covered = AssociateStamps(pictures, StampsOf(estimate), kPictureNear, offset).size();
  return static_cast<double>(covered) / static_cast<double>(pictures.size());
}

/// Fills in the coverage, where the sequence is known.
std::optional<double> Coverage(const ReadTrajectory& estimate, const EvalOptions& options,
                               std::vector<std::string>& warnings) {
  if (options.pictures) {
    // The pictures' clock is mostly the estimate's own; where it is the reference's, the offset leads to it.
    return std::max(CoverageOf(*options.pictures, estimate.poses, 0),
                    CoverageOf(*options.pictures, estimate.poses, options.time_offset));
  }
  if (!options.num_frames) return std::nullopt;
  const size_t num_poses = estimate.poses.size();
  if (num_poses > *options.num_frames) {
    warnings.push_back(estimate.path + ": " + std::to_string(num_poses) + " poses are more than --frames " +
                       std::to_string(*options.num_frames) + "; coverage counts as 1");
  }
  return std::min(1.0, static_cast<double>(num_poses) / static_cast<double>(*options.num_frames));
}

}  // namespace

Status Validate(const EvalOptions& options) {
  const auto is_positive = [](double value) { return std::isfinite(value) && value > 0; };
  if (!is_positive(options.rpe_delta)) return BadInput("--rpe-delta must be a finite number above 0");
  if (!is_positive(options.max_difference))
    return BadInput("--max-difference must be a finite number of seconds above 0");
  if (!(std::abs(options.time_offset) <= kLongestOffset))
    return BadInput("--time-offset must be a finite number of seconds, at most 4e9");
  if (options.num_frames && *options.num_frames == 0) return BadInput("--frames must be 1 or more");
  return Status::Ok();
}

Result<Evaluation> Evaluate(const ReadTrajectory& reference, const ReadTrajectory& estimate,
                            const EvalOptions& options) {
  if (const Status fine = CheckStamps(reference, estimate, options); !fine) return fine.error();
  const int64_t offset_ns = Nanoseconds(options.time_offset);
  Evaluation result;
  result.estimate_path = estimate.path;
  result.estimate = estimate.poses;
  result.warnings = estimate.warnings;
  WarnOfUnlikeRows(reference, result);
  result.pairs =
      AssociateStamps(StampsOf(reference.poses), StampsOf(estimate.poses), options.max_difference, options.time_offset);
  if (result.pairs.empty()) return NothingInCommon(reference, estimate, options);
  if (result.pairs.size() < kLeastPairsToAlign) {
    return BadInput(estimate.path + ": only " + std::to_string(result.pairs.size()) + " of " +
                    std::to_string(estimate.poses.size()) + " poses could be paired with " + reference.path +
                    "; an alignment needs 3 or more");
  }
  result.ate = ComputeAbsoluteError(reference.poses, estimate.poses, result.pairs, options.align);
  WarnOfDegeneracy(result);
  WarnOfMillimetres(reference, options, result);
  const RpeOptions rpe{options.rpe_delta, options.rpe_unit, result.ate.reference_from_estimate.scale,
                       options.time_offset};
  result.rpe = ComputeRelativeError(reference.poses, estimate.poses, rpe);
  if (static_cast<double>(result.rpe.num_odd) > kManyOdd * static_cast<double>(result.rpe.translation.size())) {
    result.warnings.push_back(estimate.path + ": " + std::to_string(result.rpe.num_odd) + " of " +
                              std::to_string(result.rpe.translation.size()) +
                              " RPE pairs are far from the wanted delta apart, at gaps between the poses");
  }
  result.coverage = Coverage(estimate, options, result.warnings);
  for (const StampedPose& pose : estimate.poses) {
    result.aligned.push_back(
        {Timestamp{pose.timestamp.ns + offset_ns}, result.ate.reference_from_estimate * pose.world_from_cam});
  }
  return result;
}

}  // namespace yorb
