// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/random.h"
#include "synthetic/paint.h"
#include "synthetic/solids.h"

namespace yorb {

/// Where a thing stands: its own axes are x to the right, y to the back, z up, as seen by somebody in front of it; the
/// origin is the middle of its foot.
using Place = Eigen::Isometry3f;

/// A place in the world, or on another thing when multiplied to that thing's place. `turn` is in radians about z.
Place At(float x, float y, float z, float turn = 0);

/// Gathers a scene piece by piece. Textures are named, painted once, and used by many.
class RoomBuilder {
 public:
  RoomBuilder(int texture_size, uint64_t seed) : random(seed), texture_size_(texture_size) {}

  /// The texture of that name, painted by `paint(size, random)` when it is new; `share` of the full texture size.
  template <typename Painter>
  int TextureOf(const std::string& name, cv::Size2f share, Painter&& paint) {
    const auto known = textures_.find(name);
    if (known != textures_.end()) return known->second;
    const cv::Size size(static_cast<int>(share.width * static_cast<float>(texture_size_)),
                        static_cast<int>(share.height * static_cast<float>(texture_size_)));
    scene.textures.emplace_back(paint(size, random));
    return textures_[name] = static_cast<int>(scene.textures.size()) - 1;
  }

  /// Wood of a kind ("oak", "walnut", "white", "beech") at its own scale; the grain runs along x, or upwards.
  Look Wood(const std::string& kind, bool is_upright = false);
  Look Plain(const std::string& name, const Paint& colour);  ///< metal, plastic
  Look Fitted(int texture, bool is_glowing = false);         ///< the whole texture on one face

  /// A box all of one look, with some faces of their own. Faces that nobody can see are left out by `hidden`.
  struct FaceLook {
    Face face;
    Look look;
  };
  void AddBox(const Place& place, const Eigen::Vector3f& size, const Look& look,
              const std::vector<FaceLook>& special = {});

  /// A turned thing (cup, pot, ball) lit as if in the open, a little darker for what stands around.
  void AddTurned(const Place& place, const std::vector<Slice>& slices, int texture, int num_sectors = 16);

  float Between(float low, float high) { return static_cast<float>(random.Uniform(low, high)); }

  Scene scene;
  Random random;

 private:
  int texture_size_;
  std::map<std::string, int> textures_;
};

}  // namespace yorb
