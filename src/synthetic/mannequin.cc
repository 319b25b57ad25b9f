// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic/mannequin.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.h"
#include "synthetic/light.h"
#include "synthetic/paint.h"
#include "synthetic/solids.h"

namespace yorb {
namespace {

using Place = Eigen::Isometry3f;

// Lengths of a person of 1.75 m; the others are scaled.
constexpr float kModelHeight = 1.75f;
constexpr float kHipWidth = 0.19f, kThigh = 0.43f, kShin = 0.42f, kAnkle = 0.08f;
constexpr float kShoulderHeight = 0.5f, kShoulderWidth = 0.4f, kUpperArm = 0.29f, kForearm = 0.25f;  // above the hips
constexpr double kStride = 1.45;  // metres for two steps

Place Moved(float x, float y, float z) { return Place(Eigen::Translation3f(x, y, z)); }

// Swings what hangs down forwards (towards -y).
Place Forwards(float radians) { return Place(Eigen::AngleAxisf(-radians, Eigen::Vector3f::UnitX())); }
Place Turned(float radians) { return Place(Eigen::AngleAxisf(radians, Eigen::Vector3f::UnitZ())); }
Place Sideways(float radians) { return Place(Eigen::AngleAxisf(radians, Eigen::Vector3f::UnitY())); }

struct Pose {
  float hip[2], knee[2], arm[2], elbow[2], spread[2];  // left, right; radians
  float hips_height = 0, turn = 0;
};

// How far the foot's sole is below the hip.
float Reach(float hip, float knee) { return kThigh * std::cos(hip) + kShin * std::cos(hip - knee) + kAnkle; }

Pose WalkingPose(double phase) {
  Pose pose;
  for (int side = 0; side < 2; ++side) {
    const auto p = static_cast<float>(phase + 3.14159265 * side);
    const float swing = std::max(0.f, std::cos(p));  // the leg that moves forwards is bent
    pose.hip[side] = 0.06f + 0.4f * std::sin(p);
    pose.knee[side] = 0.1f + 0.85f * swing * swing;
    pose.arm[side] = -0.38f * std::sin(p);
    pose.elbow[side] = 0.35f - 0.15f * std::sin(p);
    pose.spread[side] = 0.1f;
  }
  pose.turn = 0.08f * static_cast<float>(std::sin(phase));
  pose.hips_height = std::max(Reach(pose.hip[0], pose.knee[0]), Reach(pose.hip[1], pose.knee[1]));
  return pose;
}

Pose StandingPose(double seconds, double phase) {
  Pose pose;
  for (int side = 0; side < 2; ++side) {
    const auto t = static_cast<float>(seconds * (1.7 + 0.4 * side) + phase * (1 + side));
    pose.hip[side] = pose.knee[side] = 0.03f;
    pose.arm[side] = 0.35f + 0.3f * std::sin(t);
    pose.elbow[side] = 1.2f + 0.5f * std::sin(1.3f * t + 1);
    pose.spread[side] = 0.2f + 0.12f * std::sin(0.7f * t);
  }
  pose.turn = 0.25f * static_cast<float>(std::sin(0.6 * seconds + phase));
  pose.hips_height = Reach(pose.hip[0], pose.knee[0]);
  return pose;
}

// Puts the parts of one body together, at the model's height; `scale` is the person's.
class Body {
 public:
  Body(const Scene& scene, const Clothes& clothes, int person, float scale)
      : scene_(scene), clothes_(clothes), person_(person), scale_(scale) {}

  void AddTrunk(const Place& hips, const Place& chest, float head_turn) {
    Add(hips, {{-0.13f, 0.02f, 0.02f}, {-0.1f, 0.14f, 0.1f}, {0, 0.17f, 0.12f}, {0.1f, 0.158f, 0.11f}},
        {clothes_.trousers, 3, 1, person_, 14});
    Add(chest,
        {{0.04f, 0.172f, 0.122f},
         {0.15f, 0.155f, 0.112f},
         {0.28f, 0.165f, 0.12f},
         {0.4f, 0.185f, 0.12f},
         {0.5f, 0.19f, 0.1f},
         {0.55f, 0.14f, 0.08f},
         {0.585f, 0.05f, 0.05f}},
        {clothes_.shirt, 2, 1, person_, 16});
    Add(chest * Moved(0, -0.01f, 0.54f), {{0, 0.055f, 0.06f}, {0.12f, 0.05f, 0.055f}},
        {clothes_.skin, 1, 1, person_, 10});
    Add(chest * Moved(0, -0.03f, 0.6f) * Turned(head_turn), EllipsoidSlices(0.25f, 0.078f, 0.1f, 9),
        {clothes_.head, 1, 1, person_, 14});
  }

  void AddLeg(const Place& hip, float knee_bend) {
    const Place knee = hip * Moved(0, 0, -kThigh) * Forwards(-knee_bend);
    AddLimb(hip, kThigh, 0.085f, 0.06f, clothes_.trousers);
    AddLimb(knee, kShin, 0.06f, 0.045f, clothes_.trousers);
    Add(knee * Moved(0, -0.055f, -kShin - kAnkle), EllipsoidSlices(0.11f, 0.048f, 0.135f, 6),
        {clothes_.shoes, 1, 1, person_, 10});
  }

  void AddArm(const Place& shoulder, float elbow_bend) {
    const Place elbow = shoulder * Moved(0, 0, -kUpperArm) * Forwards(elbow_bend);
    AddLimb(shoulder, kUpperArm, 0.055f, 0.042f, clothes_.shirt);
    AddLimb(elbow, kForearm, 0.042f, 0.03f, clothes_.skin);
    Add(elbow * Moved(0, 0, -kForearm - 0.15f), EllipsoidSlices(0.17f, 0.025f, 0.042f, 6),
        {clothes_.skin, 1, 1, person_, 8});
  }

  /// The finished body, at the person's own height.
  std::vector<Patch> Take() && {
    for (Patch& patch : patches_) {
      patch.corner *= scale_;
      patch.edge_s *= scale_;
      patch.edge_t *= scale_;
    }
    return std::move(patches_);
  }

 private:
  void Add(const Place& place, const std::vector<Slice>& slices, const TurnedLook& look) {
    const auto light = [this](const Eigen::Vector3f& x, const Eigen::Vector3f& normal) {
      return 0.92f * OpenLight(scene_, scale_ * x, normal);
    };
    AppendTurned(place, slices, look, light, patches_);
  }

  // A part that hangs down from `joint`; thickness at the joint and at the end.
  void AddLimb(const Place& joint, float length, float thick, float thin, int texture) {
    const float round = 0.4f;  // of the thickness: the ends are rounded
    Add(joint * Moved(0, 0, -length),
        {{-thin * round, 0, 0},
         {-thin * 0.1f, thin * 0.8f, thin * 0.8f},
         {length * 0.15f, thin, thin},
         {length * 0.65f, (thin + 2 * thick) / 3, (thin + 2 * thick) / 3},
         {length * 0.95f, thick, thick},
         {length + thick * round, 0, 0}},
        {texture, 1, 1, person_, 10});
  }

  const Scene& scene_;
  const Clothes clothes_;
  const int person_;
  const float scale_;
  std::vector<Patch> patches_;
};

int PaintInto(Scene& scene, const cv::Mat& picture) {
  scene.textures.emplace_back(picture);
  return static_cast<int>(scene.textures.size()) - 1;
}

}  // namespace

Mannequin::Mannequin(const PersonPlan& plan, const Route& route, int person, uint64_t seed, Scene& scene)
    : plan_(plan), route_(route), person_(person) {
  Random random(seed, 0x9e0 + static_cast<uint64_t>(person));
  phase_ = random.Uniform(0, 6.28);
  const Paint skin = Hsv(random.Uniform(14, 28), random.Uniform(0.3, 0.6), random.Uniform(0.45, 0.92));
  const Paint hair = Hsv(random.Uniform(15, 45), random.Uniform(0.2, 0.6), random.Uniform(0.1, 0.5));
  const Paint shirt = Hsv(random.Uniform(0, 360), random.Uniform(0.3, 0.75), random.Uniform(0.45, 0.9));
  const Paint trousers = Hsv(random.Uniform(190, 260), random.Uniform(0.15, 0.5), random.Uniform(0.2, 0.5));
  clothes_.shirt = PaintInto(scene, PaintCloth({256, 256}, shirt, random));
  clothes_.trousers = PaintInto(scene, PaintPlaster({128, 128}, trousers, random));
  clothes_.skin = PaintInto(scene, PaintPlaster({64, 64}, skin, random));
  clothes_.head = PaintInto(scene, PaintHead({256, 128}, skin, hair, random));
  clothes_.shoes = PaintInto(scene, PaintMetal({32, 32}, Paint(36, 34, 40), random));
}

void Mannequin::AddTo(MovingThings& moving, const Scene& scene, double seconds) const {
  const double way = plan_.start + plan_.speed * seconds;
  const Route::Point at = route_.At(way);
  const auto scale = static_cast<float>(plan_.height / kModelHeight);
  const double phase = phase_ + 2 * std::numbers::pi * std::abs(way) / (kStride * scale);
  const Pose pose = plan_.speed != 0 ? WalkingPose(phase) : StandingPose(seconds, phase_);
  const double ahead = at.heading + (plan_.speed < 0 ? std::numbers::pi : 0);

  const auto x = static_cast<float>(at.position.x()), y = static_cast<float>(at.position.y());
  const Place foot =
      Moved(x / scale, y / scale, 0) * Turned(static_cast<float>(ahead + std::numbers::pi / 2));  // -y looks ahead
  const Place hips = foot * Moved(0, 0, pose.hips_height);
  const Place chest = hips * Turned(pose.turn) * Forwards(-0.04f);
  Body body(scene, clothes_, person_, scale);
  body.AddTrunk(hips, chest, -1.5f * pose.turn);
  for (int side = 0; side < 2; ++side) {
    const float sign = side == 0 ? -1.f : 1.f;
    body.AddLeg(hips * Moved(sign * kHipWidth / 2, 0, 0) * Forwards(pose.hip[side]), pose.knee[side]);
    body.AddArm(chest * Moved(sign * kShoulderWidth / 2, 0, kShoulderHeight) * Sideways(-sign * pose.spread[side]) *
                    Forwards(pose.arm[side]),
                pose.elbow[side]);
  }
  const std::vector<Patch> patches = std::move(body).Take();
  moving.patches.insert(moving.patches.end(), patches.begin(), patches.end());
  moving.shadows.push_back({{x, y}, 0.33f, 0.45f});
}

}  // namespace yorb
