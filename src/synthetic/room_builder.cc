// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic/room_builder.h"

#include <algorithm>

#include "synthetic/light.h"

namespace yorb {
namespace {

constexpr float kCastsShadow = 0.25f;  // metres: a box with its second longest side above this keeps light away

}  // namespace

Place At(float x, float y, float z, float turn) {
  return Eigen::Translation3f(x, y, z) * Eigen::Isometry3f(Eigen::AngleAxisf(turn, Eigen::Vector3f::UnitZ()));
}

Look RoomBuilder::Wood(const std::string& kind, bool is_upright) {
  const std::map<std::string, Paint> colours{
      {"oak", {96, 150, 196}}, {"walnut", {52, 78, 116}}, {"white", {214, 222, 226}}, {"beech", {132, 180, 214}}};
  const Paint colour = colours.at(kind);
  Look look;
  look.texture =
      TextureOf("wood " + kind, {1, 1}, [&](cv::Size size, Random& r) { return PaintWood(size, colour, r); });
  look.tile = 1.1f;
  look.is_turned = is_upright;
  return look;
}

Look RoomBuilder::Plain(const std::string& name, const Paint& colour) {
  Look look;
  look.texture =
      TextureOf("plain " + name, {0.25f, 0.25f}, [&](cv::Size size, Random& r) { return PaintMetal(size, colour, r); });
  look.tile = 0.4f;
  return look;
}

Look RoomBuilder::Fitted(int texture, bool is_glowing) {
  Look look;
  look.texture = texture;
  look.is_glowing = is_glowing;
  return look;
}

void RoomBuilder::AddBox(const Place& place, const Eigen::Vector3f& size, const Look& look,
                         const std::vector<FaceLook>& special) {
  for (const Face face : {Face::kFront, Face::kBack, Face::kLeft, Face::kRight, Face::kTop, Face::kBottom}) {
    const auto own = std::find_if(special.begin(), special.end(), [&](const FaceLook& s) { return s.face == face; });
    Look here = own != special.end() ? own->look : look;
    if (here.tile > 0) here.offset = {static_cast<float>(random.Uniform()), static_cast<float>(random.Uniform())};
    scene.patches.push_back(BoxFace(place, size, face, here));
  }
  Eigen::Array3f sides = size.array();
  std::sort(sides.begin(), sides.end());
  if (sides[1] < kCastsShadow) return;
  Eigen::AlignedBox3f box;
  for (const float x : {-0.5f, 0.5f}) {
    for (const float y : {-0.5f, 0.5f}) {
      box.extend(place * Eigen::Vector3f(x * size.x(), y * size.y(), 0));
      box.extend(place * Eigen::Vector3f(x * size.x(), y * size.y(), size.z()));
    }
  }
  scene.occluders.push_back(box);
}

void RoomBuilder::AddTurned(const Place& place, const std::vector<Slice>& slices, int texture, int num_sectors) {
  TurnedLook look;
  look.texture = texture;
  look.num_sectors = num_sectors;
  const auto light = [&](const Eigen::Vector3f& x, const Eigen::Vector3f& normal) {
    return 0.85f * OpenLight(scene, x, normal);
  };
  AppendTurned(place, slices, look, light, scene.patches);
}

}  // namespace yorb
