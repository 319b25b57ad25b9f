// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic/light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.h"
#include "core/random.h"

namespace yorb {
namespace {

constexpr float kLargeSide = 0.2f;    // metres: a patch with both sides longer gets a map
constexpr float kSkin = 0.012f;       // rays start this far off the surface
constexpr float kCornerReach = 0.9f;  // metres: farther things do not darken

bool Hits(const Eigen::AlignedBox3f& box, const Eigen::Array3f& from, const Eigen::Array3f& one_over_step,
          float reach) {
  const Eigen::Array3f a = (box.min().array() - from) * one_over_step, b = (box.max().array() - from) * one_over_step;
  const float enter = a.min(b).maxCoeff(), leave = a.max(b).minCoeff();
  return enter < leave && leave > 0 && enter < reach;
}

// Whether something stands between `from` and `from + reach * step`.
bool IsBlocked(const Scene& scene, const Eigen::Vector3f& from, const Eigen::Vector3f& step, float reach) {
  Eigen::Array3f one_over_step;
  for (int i = 0; i < 3; ++i) one_over_step[i] = 1 / (std::abs(step[i]) < 1e-6f ? 1e-6f : step[i]);
  return std::any_of(scene.occluders.begin(), scene.occluders.end(),
                     [&](const Eigen::AlignedBox3f& box) { return Hits(box, from, one_over_step, reach); });
}

float FromLampPoint(const Lamp& lamp, const Eigen::Vector3f& on_lamp, const Eigen::Vector3f& x,
                    const Eigen::Vector3f& normal) {
  const Eigen::Vector3f towards = on_lamp - x;
  const float distance2 = std::max(towards.squaredNorm(), 0.04f), distance = std::sqrt(distance2);
  const float received = normal.dot(towards) / distance;
  const float sent = -lamp.half_u.cross(lamp.half_v).normalized().dot(towards) / distance;
  return received > 0 && sent > 0 ? lamp.power * received * sent / distance2 : 0;
}

// Light from below is what the floor throws back.
float Ambient(const Scene& scene, const Eigen::Vector3f& normal) {
  return scene.ambient * (0.85f + 0.15f * normal.z());
}

float CornerOpenness(const Scene& scene, const Eigen::Vector3f& x, const Eigen::Vector3f& normal, int num_rays,
                     Random& random) {
  if (num_rays == 0) return 1;
  const Eigen::Vector3f side = normal.unitOrthogonal(), other = normal.cross(side);
  const auto turn = static_cast<float>(random.Uniform());
  int num_free = 0;
  for (int i = 0; i < num_rays; ++i) {
    // Evenly over the half sphere by cosine: a sunflower.
    const float radius = std::sqrt((static_cast<float>(i) + 0.5f) / static_cast<float>(num_rays));
    const float angle = 2 * std::numbers::pi_v<float> * (static_cast<float>(i) * 0.618034f + turn);
    const Eigen::Vector3f step =
        radius * std::cos(angle) * side + radius * std::sin(angle) * other + std::sqrt(1 - radius * radius) * normal;
    num_free += IsBlocked(scene, x, step, kCornerReach) ? 0 : 1;
  }
  return 0.35f + 0.65f * static_cast<float>(num_free) / static_cast<float>(num_rays);
}

float ShadowedLight(const Scene& scene, const LightOptions& options, const Eigen::Vector3f& x,
                    const Eigen::Vector3f& normal, Random& random) {
  float light = Ambient(scene, normal) * CornerOpenness(scene, x, normal, options.corner_rays, random);
  const int num_rays = std::max(1, options.lamp_rays);
  for (const Lamp& lamp : scene.lamps) {
    for (int i = 0; i < num_rays; ++i) {
      const auto u = static_cast<float>((i + random.Uniform()) / num_rays * 2 - 1),
                 v = static_cast<float>(random.Uniform(-1, 1));
      const Eigen::Vector3f on_lamp = lamp.centre + u * lamp.half_u + v * lamp.half_v;
      const float received = FromLampPoint(lamp, on_lamp, x, normal);
      if (received > 0 && (options.lamp_rays == 0 || !IsBlocked(scene, x, on_lamp - x, 0.98f)))
        light += received / static_cast<float>(num_rays);
    }
  }
  return light;
}

LightMap MakeMap(const Scene& scene, const LightOptions& options, const Patch& patch, Random& random) {
  const float length_s = patch.edge_s.norm(), length_t = patch.edge_t.norm();
  LightMap map;
  map.columns = std::max(2, 1 + static_cast<int>(length_s / options.cell + 0.5f));
  map.rows = std::max(2, 1 + static_cast<int>(length_t / options.cell + 0.5f));
  const Eigen::Vector3f normal = patch.Normal();
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      // The outermost nodes are worked out a little inside, where the neighbouring wall does not hide everything.
      const float inset_s = 2 * kSkin / length_s, inset_t = 2 * kSkin / length_t;
      const float s =
          std::clamp(static_cast<float>(column) / static_cast<float>(map.columns - 1), inset_s, 1 - inset_s);
      const float t = std::clamp(static_cast<float>(row) / static_cast<float>(map.rows - 1), inset_t, 1 - inset_t);
      map.nodes.push_back(ShadowedLight(scene, options, patch.At(s, t) + kSkin * normal, normal, random));
    }
  }
  return map;
}

}  // namespace

float LightMap::At(float s, float t) const {
  const float x = std::clamp(s, 0.f, 1.f) * static_cast<float>(columns - 1),
              y = std::clamp(t, 0.f, 1.f) * static_cast<float>(rows - 1);
  const int left = std::min(static_cast<int>(x), columns - 2), top = std::min(static_cast<int>(y), rows - 2);
  const float right_weight = x - static_cast<float>(left), bottom_weight = y - static_cast<float>(top);
  const float* node = nodes.data() + static_cast<size_t>(top) * columns + left;
  const float upper = node[0] + right_weight * (node[1] - node[0]);
  const float lower = node[columns] + right_weight * (node[columns + 1] - node[columns]);
  return upper + bottom_weight * (lower - upper);
}

float OpenLight(const Scene& scene, const Eigen::Vector3f& x_in_world, const Eigen::Vector3f& normal) {
  float light = Ambient(scene, normal);
  for (const Lamp& lamp : scene.lamps) light += FromLampPoint(lamp, lamp.centre, x_in_world, normal);
  return light;
}

void BakeLight(const LightOptions& options, Scene& scene) {
  std::vector<size_t> lit;
  for (size_t i = 0; i < scene.patches.size(); ++i) {
    if (!scene.patches[i].is_triangle && !scene.patches[i].is_glowing) lit.push_back(i);
  }
  std::vector<LightMap> maps(lit.size());
  ParallelFor(lit.size(), options.num_threads, [&](size_t i) {
    Patch& patch = scene.patches[lit[i]];
    Random random(lit[i]);
    if (std::min(patch.edge_s.norm(), patch.edge_t.norm()) > kLargeSide) {
      maps[i] = MakeMap(scene, options, patch, random);
    } else {
      patch.light =
          ShadowedLight(scene, options, patch.At(0.5f, 0.5f) + kSkin * patch.Normal(), patch.Normal(), random);
    }
  });
  for (size_t i = 0; i < lit.size(); ++i) {
    if (maps[i].nodes.empty()) continue;
    scene.patches[lit[i]].light_map = static_cast<int>(scene.light_maps.size());
    scene.light_maps.push_back(std::move(maps[i]));
  }
}

}  // namespace yorb
