// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/features_matching.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "experiments/features_light.h"
#include "features/hamming.h"

namespace yorb {
namespace {

using Matches = std::vector<std::pair<size_t, size_t>>;

constexpr float kNotKnown = std::numeric_limits<float>::quiet_NaN();
constexpr float kFarOff = std::numeric_limits<float>::infinity();
constexpr float kScaleFactor = 1.2f;

void Count(const std::vector<int>& verdicts, MatchCount& count) {
  ++count.pairs;
  for (const int verdict : verdicts) {
    count.matches += verdict >= 0;
    count.correct += verdict == 1;
  }
}

MatchingRow EmptyRow(const std::string& set, const std::vector<FrontEnd>& front_ends) {
  MatchingRow row;
  row.set = set;
  for (const FrontEnd& front_end : front_ends) row.counts.emplace_back(front_end.name, MatchCount());
  return row;
}

std::vector<Eigen::Vector2f> Ideal(const Rig& rig, const Features& features) {
  std::vector<Eigen::Vector2f> points;
  for (const Keypoint& k : features.keypoints) points.emplace_back(k.x, k.y);
  return rig.camera.Undistort(points);
}

float DepthAt(const DepthImage& depth, const Keypoint& point) {
  const int x = static_cast<int>(std::lround(point.x)), y = static_cast<int>(std::lround(point.y));
  const bool is_inside = x >= 0 && y >= 0 && x < depth.pixels.cols && y < depth.pixels.rows;
  return is_inside ? depth.At(x, y) : 0.f;
}

/// The two pictures of a pair and the motion between them, if all is known.
struct Moved {
  ImageSet a, b;
  Rigid3 b_from_a;
};
Result<std::optional<Moved>> LoadMoved(const PictureSet& set, size_t i, size_t j) {
  const auto pose_a = TruePose(set.truth, set.dataset->TimeOf(i)), pose_b = TruePose(set.truth, set.dataset->TimeOf(j));
  if (!pose_a || !pose_b) return std::optional<Moved>();
  auto a = LoadPicture(set, i), b = LoadPicture(set, j);
  if (!a) return a.error();
  if (!b) return b.error();
  if (a->grey.empty() || b->grey.empty() || a->depth.empty()) return std::optional<Moved>();
  return std::optional<Moved>(Moved{*std::move(a), *std::move(b), pose_b->Inverse() * *pose_a});
}

}  // namespace

double MatchCount::Precision() const {
  return matches == 0 ? std::numeric_limits<double>::quiet_NaN()
                      : static_cast<double>(correct) / static_cast<double>(matches);
}

double MatchCount::MatchesPerPair() const {
  return pairs == 0 ? 0 : static_cast<double>(matches) / static_cast<double>(pairs);
}

Matches MutualNearest(const std::vector<Descriptor>& a, const std::vector<Descriptor>& b) {
  constexpr uint16_t kNone = 257;
  std::vector<uint16_t> distances(b.size()), best_of_b(b.size(), kNone);
  std::vector<size_t> nearest_to_a(a.size(), b.size()), nearest_to_b(b.size(), a.size());
  for (size_t i = 0; i < a.size(); ++i) {
    HammingDistances(a[i], b.data(), b.size(), distances.data());
    uint16_t best = kNone;
    for (size_t j = 0; j < b.size(); ++j) {
      if (distances[j] < best) best = distances[j], nearest_to_a[i] = j;
      if (distances[j] < best_of_b[j]) best_of_b[j] = distances[j], nearest_to_b[j] = i;
    }
  }
  Matches matches;
  for (size_t i = 0; i < a.size(); ++i) {
    const size_t j = nearest_to_a[i];
    if (j < b.size() && nearest_to_b[j] == i) matches.emplace_back(i, j);
  }
  return matches;
}

MatchErrors ErrorsInPlace(const Features& a, const Features& b, const Matches& matches) {
  MatchErrors errors;
  for (const auto& [i, j] : matches) {
    const Keypoint &p = a.keypoints[i], &q = b.keypoints[j];
    errors.push_back(std::hypot(p.x - q.x, p.y - q.y));
  }
  return errors;
}

MatchErrors ErrorsByMotion(const Features& a, const Features& b, const Matches& matches, const Rig& rig,
                           const DepthImage& depth_of_a, const Rigid3& b_from_a) {
  const std::vector<Eigen::Vector2f> from = Ideal(rig, a), to = Ideal(rig, b);
  MatchErrors errors;
  for (const auto& [i, j] : matches) {
    const float depth = DepthAt(depth_of_a, a.keypoints[i]);
    if (!(depth > 0)) {
      errors.push_back(kNotKnown);
      continue;
    }
    const Eigen::Vector3d x_in_b = b_from_a * rig.camera.Unproject(from[i].x(), from[i].y(), depth);
    errors.push_back(x_in_b.z() > 0 ? (rig.camera.Project(x_in_b).cast<float>() - to[j]).norm() : kFarOff);
  }
  return errors;
}

std::vector<int> Verdicts(const Features& a, const Matches& matches, const MatchErrors& errors) {
  std::vector<int> verdicts;
  for (size_t k = 0; k < matches.size(); ++k) {
    const float scale = std::pow(kScaleFactor, static_cast<float>(a.keypoints[matches[k].first].octave));
    verdicts.push_back(std::isnan(errors[k]) ? -1 : errors[k] <= kRightWithin_px * scale ? 1 : 0);
  }
  return verdicts;
}

Result<MatchingRow> MatchUnderLight(const PictureSet& set, const std::vector<size_t>& indices,
                                    const std::vector<FrontEnd>& front_ends, const std::function<bool()>& should_stop) {
  MatchingRow row = EmptyRow(set.name + ", changed light", front_ends);
  const std::vector<LightChange> lights = LightChanges();
  for (const LightChange& light : lights) {
    row.by_light.emplace_back(light.name, std::vector<MatchCount>(front_ends.size()));
  }
  for (const size_t index : indices) {
    if (should_stop && should_stop()) break;
    const auto images = LoadPicture(set, index);
    if (!images) return images.error();
    if (images->grey.empty()) continue;
    for (size_t f = 0; f < front_ends.size(); ++f) {
      const Features plain = front_ends[f].extract(images->grey);
      for (size_t l = 0; l < lights.size(); ++l) {
        const Features relit = front_ends[f].extract(Relit(images->grey, lights[l]));
        const Matches matches = MutualNearest(plain.descriptors, relit.descriptors);
        const std::vector<int> verdicts = Verdicts(plain, matches, ErrorsInPlace(plain, relit, matches));
        Count(verdicts, row.counts[f].second);
        Count(verdicts, row.by_light[l].second[f]);
      }
    }
  }
  return row;
}

Result<MatchingRow> MatchAlongMotion(const PictureSet& set, const std::vector<size_t>& indices, size_t gap,
                                     const std::vector<FrontEnd>& front_ends,
                                     const std::function<bool()>& should_stop) {
  const std::string name = set.name + (gap == 1 ? ", next frame" : ", " + std::to_string(gap) + " frames on");
  MatchingRow row = EmptyRow(name, front_ends);
  for (const size_t index : indices) {
    if (index + gap >= set.size()) continue;
    if (should_stop && should_stop()) break;
    const auto moved = LoadMoved(set, index, index + gap);
    if (!moved) return moved.error();
    if (!*moved) continue;
    const Moved& pair = **moved;
    for (size_t f = 0; f < front_ends.size(); ++f) {
      const Features a = front_ends[f].extract(pair.a.grey), b = front_ends[f].extract(pair.b.grey);
      const Matches matches = MutualNearest(a.descriptors, b.descriptors);
      Count(Verdicts(a, matches, ErrorsByMotion(a, b, matches, set.dataset->rig(), pair.a.depth, pair.b_from_a)),
            row.counts[f].second);
    }
  }
  return row;
}

}  // namespace yorb
