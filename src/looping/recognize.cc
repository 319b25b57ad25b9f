// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "looping/recognize.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "localize/evidence.h"
#include "localize/local_map.h"
#include "localize/relocalizer.h"

namespace yorb {
namespace {

constexpr float kWide = 5, kNarrow = 2;  // of the usual search around a landmark, first and once a pose is known

/// A keyframe and what is around it.
std::vector<KeyframeId> PlaceOf(const Keyframe& keyframe) {
  constexpr size_t kNeighbours = 10;
  constexpr int kMinShared = 15;
  return keyframe.WithStrongest(kNeighbours, kMinShared);
}

/// The pose of a frame that should be near `guess`, on the landmarks of a place alone.
Fix FixAtPlace(const Frame& frame, const Map& map, const Rigid3& guess, const std::vector<KeyframeId>& place,
               float widening) {
  Fix fix;
  fix.cam_from_world = guess;
  fix.matches.resize(frame.size());
  LocalMap local;
  local.keyframes = place;
  const auto expected = ExpectLocalLandmarks(map, local, frame, guess, fix.matches, widening);
  return FixWithExpected(frame, map, fix, expected);
}

/// The part of what the options ask for that is enough. Where people hide the view, few landmarks can be seen at all:
/// fewer do where a larger share of them is. Nothing is let off between sub-maps, where no drift is too much.
double PartNeeded(const Keyframe& newer, const Keyframe& older, const Evidence& evidence,
                  const LoopingOptions& options) {
  constexpr double kMostEase = 1.5;
  if (newer.root != older.root) return 1;
  return 1 / std::clamp(evidence.Share() / std::max(options.min_share, 1e-6), 1.0, kMostEase);
}

/// Whether a fix shows as much as the options ask for, or a part of it.
bool Holds(const Fix& fix, const Evidence& evidence, const LoopingOptions& options, double part) {
  return static_cast<double>(fix.num_inliers) >= part * options.min_inliers &&
         evidence.Share() >= part * options.min_share && evidence.spread >= part * options.min_spread;
}

/// Whether a pose was found about where it was expected.
bool IsNear(const Rigid3& found, const Rigid3& expected) {
  constexpr double kMaxShiftM = 0.1, kMaxTurnRad = 0.07;
  const Rigid3 off = found * expected.Inverse();
  return off.translation.norm() < kMaxShiftM && off.RotationAngle() < kMaxTurnRad;
}

/// How far the camera went from one keyframe to another, by the keyframes between.
double PathBetween(const Map& map, KeyframeId from, KeyframeId to) {
  double path_m = 0;
  std::optional<Eigen::Vector3d> last;
  const KeyframeId root = map.Find(to)->root;
  map.VisitKeyframes([&](const Keyframe& keyframe) {
    if (keyframe.root != root || keyframe.id < from || to < keyframe.id) return;
    const Eigen::Vector3d centre = keyframe.cam_from_world.OriginInSource();
    if (last) path_m += (centre - *last).norm();
    last = centre;
  });
  return path_m;
}

}  // namespace

bool AreNear(const Map& map, KeyframeId a, KeyframeId b) {
  if (a == b || map.Find(a)->NumShared(b) > 0) return true;
  if (map.Find(a)->parent == b || map.Find(b)->parent == a) return true;
  const auto& one = map.Find(a)->neighbours;
  const auto& other = map.Find(b)->neighbours;
  auto at = other.begin();  // both are sorted by id
  for (const Neighbour& neighbour : one) {
    while (at != other.end() && at->id < neighbour.id) ++at;
    if (at != other.end() && at->id == neighbour.id) return true;
  }
  return false;
}

std::optional<Recognition> Recognize(const Map& map, const Keyframe& newer, const Keyframe& older,
                                     const LoopingOptions& options, Random random) {
  constexpr size_t kWorthALook = 15;
  constexpr double kRadiusPx = 20;
  const auto coarse = RelocalizeAgainst(*newer.frame, map, older, {kWorthALook, kRadiusPx}, random);
  if (!coarse) return std::nullopt;
  const std::vector<KeyframeId> place = PlaceOf(older);
  Fix fix = FixAtPlace(*newer.frame, map, coarse->cam_from_world, place, kWide);
  fix = FixAtPlace(*newer.frame, map, fix.cam_from_world, place, kNarrow);
  const Evidence evidence = Weigh(*newer.frame, map, fix, place);
  if (!Holds(fix, evidence, options, PartNeeded(newer, older, evidence, options))) return std::nullopt;
  return Recognition{newer.id, older.id, fix.cam_from_world, fix.num_inliers, evidence.Share()};
}

bool IsConfirmed(const Map& map, const Recognition& recognition, const LoopingOptions& options) {
  constexpr size_t kAsked = 5;
  constexpr int kMinShared = 30;
  constexpr double kPart = 0.7;  // of what is asked for, where the pose is known beforehand
  if (recognition.num_inliers >= static_cast<size_t>(options.certain_inliers) &&
      recognition.share >= options.certain_share) {
    return true;
  }
  const Keyframe& newer = *map.Find(recognition.newer);
  const Keyframe& older = *map.Find(recognition.older);
  const std::vector<KeyframeId> place = PlaceOf(older);
  for (const KeyframeId id : newer.Strongest(kAsked, kMinShared)) {
    const Keyframe& beside = *map.Find(id);
    const Rigid3 guess = beside.cam_from_world * newer.cam_from_world.Inverse() * recognition.cam_from_world;
    const Fix fix = FixAtPlace(*beside.frame, map, guess, place, kWide);
    const Evidence evidence = Weigh(*beside.frame, map, fix, place);
    const double part = kPart * PartNeeded(newer, older, evidence, options);
    if (IsNear(fix.cam_from_world, guess) && Holds(fix, evidence, options, part)) return true;
  }
  return false;
}

bool Agrees(const Map& map, const Recognition& recognition, const Glimpse& earlier) {
  const Keyframe& newer = *map.Find(recognition.newer);
  const Keyframe* before = map.Find(earlier.newer);
  const Keyframe* place = map.Find(earlier.older);
  if (!before || !place || before->id == newer.id) return false;
  const bool is_within = before->root == newer.root && place->root == newer.root;
  if (!is_within || map.Find(recognition.older)->root != newer.root) return false;
  const Rigid3 newer_from_before = newer.cam_from_world * before->cam_from_world.Inverse();
  const Rigid3 guess = newer_from_before * earlier.newer_from_older * place->cam_from_world;
  return IsNear(recognition.cam_from_world, guess);
}

bool IsPlausible(const Map& map, const Recognition& recognition, const LoopingOptions& options) {
  constexpr double kAlwaysM = 0.1;
  const Keyframe& newer = *map.Find(recognition.newer);
  if (newer.root != map.Find(recognition.older)->root) return true;
  const Rigid3 drift = recognition.cam_from_world * newer.cam_from_world.Inverse();
  const double shift_m = (recognition.cam_from_world.OriginInSource() - newer.cam_from_world.OriginInSource()).norm();
  const double path_m = PathBetween(map, recognition.older, recognition.newer);
  return shift_m <= kAlwaysM + options.drift_per_metre * path_m &&
         drift.RotationAngle() * 180 / std::numbers::pi <= options.max_drift_turn_deg;
}

}  // namespace yorb
