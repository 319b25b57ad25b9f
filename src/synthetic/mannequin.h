// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "synthetic/render.h"
#include "synthetic/route.h"
#include "synthetic/scene.h"

namespace yorb {

/// Who walks where.
struct PersonPlan {
  size_t route = 0;      ///< index into Stage::routes
  double start = 0;      ///< metres along the route at time 0
  double speed = 1.0;    ///< metres a second; 0: stands and gestures; negative: the other way round
  double height = 1.75;  ///< metres
};

/// A person's textures in a scene.
struct Clothes {
  int shirt = 0, trousers = 0, skin = 0, head = 0, shoes = 0;
};

/// A jointed figure with clothes, a face and a gait, that looks like a person from a camera's distance.
class Mannequin {
 public:
  /// Number `person` (1, 2, ...) paints its clothes into `scene`.
  Mannequin(const PersonPlan& plan, const Route& route, int person, uint64_t seed, Scene& scene);

  /// Adds its body as it is at a moment.
  void AddTo(MovingThings& moving, const Scene& scene, double seconds) const;

 private:
  PersonPlan plan_;
  Route route_;
  int person_;
  double phase_ = 0;  // of its step, so that two people do not march in step
  Clothes clothes_;
};

}  // namespace yorb
