// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic/furniture.h"

#include <cmath>

namespace yorb {
namespace {

constexpr float kBoard = 0.022f;  // metres: what furniture is made of

Look Cloth(RoomBuilder& room, const std::string& name) {
  Look look;
  const Paint colour =
      Hsv(room.random.Uniform(0, 360), room.random.Uniform(0.25, 0.55), room.random.Uniform(0.45, 0.75));
  look.texture = room.TextureOf("cloth " + name, {0.5f, 0.5f},
                                [&](cv::Size size, Random& r) { return PaintCloth(size, colour, r); });
  look.tile = 0.7f;
  return look;
}

// Something small to stand in a shelf.
void AddOrnament(RoomBuilder& room, const Place& place, float max_height) {
  switch (room.random.Below(4)) {
    case 0:
      AddMug(room, place);
      break;
    case 1:
      AddPackage(room, place, {room.Between(0.12f, 0.2f), 0.14f, room.Between(0.1f, 0.9f) * max_height});
      break;
    case 2:
      AddBookPile(room, place, 2 + static_cast<int>(room.random.Below(4)));
      break;
    default:
      AddPicture(room, place * At(0, 0.02f, 0), 0.13f, std::min(0.18f, max_height),
                 PictureTexture(room, static_cast<int>(room.random.Below(8))));
  }
}

}  // namespace

void AddTable(RoomBuilder& room, const Place& place, const Eigen::Vector3f& size, const std::string& wood) {
  constexpr float kTop = 0.032f, kLeg = 0.055f;
  room.AddBox(place * At(0, 0, size.z() - kTop), {size.x(), size.y(), kTop}, room.Wood(wood));
  for (const float x : {-0.5f, 0.5f}) {
    for (const float y : {-0.5f, 0.5f}) {
      room.AddBox(place * At(x * (size.x() - 2 * kLeg), y * (size.y() - 2 * kLeg), 0), {kLeg, kLeg, size.z() - kTop},
                  room.Wood(wood, true));
    }
  }
  room.AddBox(place * At(0, size.y() / 2 - kLeg, size.z() - 0.4f), {size.x() - 3 * kLeg, kBoard, 0.36f},
              room.Wood(wood));
}

void AddBookcase(RoomBuilder& room, const Place& place, const Eigen::Vector3f& size, int num_shelves) {
  const Look board = room.Wood("beech"), side = room.Wood("beech", true);
  for (const float x : {-0.5f, 0.5f})
    room.AddBox(place * At(x * (size.x() - kBoard), 0, 0), {kBoard, size.y(), size.z()}, side);
  room.AddBox(place * At(0, size.y() / 2 - 0.005f, 0), {size.x(), 0.01f, size.z()}, side);
  const float step = (size.z() - kBoard - 0.06f) / static_cast<float>(num_shelves), inner = size.x() - 2 * kBoard;
  for (int i = 0; i <= num_shelves; ++i) {
    const float height = 0.06f + step * static_cast<float>(i);
    room.AddBox(place * At(0, 0, height), {inner, size.y() - 0.02f, kBoard}, board);
    if (i == num_shelves) break;
    const float free = step - kBoard - 0.03f, books = inner * room.Between(0.35f, 0.95f);
    const float start = room.random.Below(2) == 0 ? -inner / 2 : inner / 2 - books;
    AddBooks(room, place * At(start, -size.y() * 0.12f, height + kBoard), books, free);
    for (float rest = inner - books, at = 0; rest - at > 0.24f; at += 0.26f) {
      const float x = (start > -inner / 2 ? -inner / 2 + at : start + books + at) + 0.13f;
      AddOrnament(room, place * At(x, 0, height + kBoard), free);
    }
  }
}

void AddCabinet(RoomBuilder& room, const Place& place, const Eigen::Vector3f& size, int columns, int rows) {
  const std::string name = "drawers " + std::to_string(columns) + "x" + std::to_string(rows);
  const int front = room.TextureOf(
      name, {1, 0.5f}, [&](cv::Size s, Random& r) { return PaintDrawers(s, Paint(104, 152, 190), columns, rows, r); });
  room.AddBox(place * At(0, 0.02f, 0), {size.x() - 0.06f, size.y() - 0.06f, 0.08f},
              room.Plain("black", Paint(40, 38, 38)));
  room.AddBox(place * At(0, 0, 0.08f), {size.x(), size.y(), size.z() - 0.08f}, room.Wood("oak"),
              {{Face::kFront, room.Fitted(front)}});
}

void AddSofa(RoomBuilder& room, const Place& place, float width) {
  const Look cover = Cloth(room, "sofa");
  room.AddBox(place * At(0, 0, 0.06f), {width, 0.82f, 0.3f}, cover);
  room.AddBox(place * At(0, 0.31f, 0.36f), {width, 0.2f, 0.42f}, cover);
  for (const float x : {-0.5f, 0.5f})
    room.AddBox(place * At(x * (width - 0.18f), 0, 0.36f), {0.18f, 0.82f, 0.22f}, cover);
  for (int i = 0; i < 3; ++i) {
    const float x = (static_cast<float>(i) - 1) * (width - 0.4f) / 3;
    room.AddBox(place * At(x, -0.08f, 0.36f), {(width - 0.42f) / 3, 0.6f, 0.12f}, cover);
    const Look cushion = room.Fitted(Cloth(room, "cushion " + std::to_string(i)).texture);
    room.AddBox(place * At(x + room.Between(-0.05f, 0.05f), 0.12f, 0.48f, room.Between(-0.2f, 0.2f)),
                {0.38f, 0.13f, 0.34f}, cushion);
  }
}

void AddChair(RoomBuilder& room, const Place& place) {
  const Look metal = room.Plain("steel", Paint(150, 150, 148)), seat = Cloth(room, "chair");
  room.AddBox(place * At(0, 0, 0.44f), {0.44f, 0.42f, 0.05f}, seat);
  room.AddBox(place * At(0, 0.2f, 0.55f), {0.42f, 0.035f, 0.38f}, seat);
  for (const float x : {-0.19f, 0.19f}) {
    room.AddBox(place * At(x, -0.18f, 0), {0.03f, 0.03f, 0.44f}, metal);
    room.AddBox(place * At(x, 0.19f, 0), {0.03f, 0.03f, 0.6f}, metal);
  }
}

void AddFloorLamp(RoomBuilder& room, const Place& place) {
  const int steel = room.Plain("steel", Paint(150, 150, 148)).texture;
  const int shade = room.TextureOf("shade", {0.5f, 0.25f},
                                   [](cv::Size size, Random& r) { return PaintCloth(size, Paint(190, 222, 240), r); });
  room.AddTurned(place, {{0, 0.14f, 0.14f}, {0.03f, 0.14f, 0.14f}, {0.035f, 0, 0}}, steel);
  room.AddTurned(place, {{0.03f, 0.014f, 0.014f}, {1.4f, 0.014f, 0.014f}}, steel, 8);
  room.AddTurned(place * At(0, 0, 1.35f), {{0, 0.21f, 0.21f}, {0.3f, 0.13f, 0.13f}, {0.301f, 0, 0}}, shade, 20);
}

void AddPlant(RoomBuilder& room, const Place& place, float height) {
  const int clay = room.TextureOf("clay", {0.25f, 0.25f},
                                  [](cv::Size size, Random& r) { return PaintPlaster(size, Paint(70, 104, 176), r); });
  const int leaf = room.TextureOf("leaf", {0.25f, 0.25f}, [](cv::Size size, Random& r) { return PaintLeaf(size, r); });
  const float pot = height * 0.22f;
  room.AddTurned(place, {{0, pot * 0.45f, pot * 0.45f}, {pot, pot * 0.62f, pot * 0.62f}, {pot * 1.02f, 0, 0}}, clay);
  for (int i = 0; i < 26; ++i) {
    const float turn = static_cast<float>(i) * 2.4f + room.Between(-0.3f, 0.3f), tilt = room.Between(0.1f, 1.0f),
                length = height * room.Between(0.35f, 0.7f);
    const Place stem =
        place * At(0, 0, pot) *
        Place(Eigen::AngleAxisf(turn, Eigen::Vector3f::UnitZ()) * Eigen::AngleAxisf(tilt, Eigen::Vector3f::UnitX()));
    Patch patch = BoxFace(stem, {length * 0.24f, 0, length}, Face::kFront, room.Fitted(leaf));
    patch.is_triangle = patch.is_two_sided = true;
    patch.corner = stem * Eigen::Vector3f(-length * 0.12f, 0, length * 0.45f);  // a long triangle, tip upwards
    patch.edge_t = stem.linear() * Eigen::Vector3f(length * 0.12f, 0, length * 0.55f);
    patch.light = 0.75f * room.Between(0.7f, 1.1f);
    room.scene.patches.push_back(patch);
    patch.edge_t = stem.linear() * Eigen::Vector3f(length * 0.12f, 0, -length * 0.45f);
    room.scene.patches.push_back(patch);
  }
}

void AddDoor(RoomBuilder& room, const Place& place) {
  const int door = room.TextureOf("door", {0.5f, 1},
                                  [](cv::Size size, Random& r) { return PaintDoor(size, Paint(196, 212, 222), r); });
  room.AddBox(place * At(0, -0.02f, 0), {0.98f, 0.04f, 2.06f}, room.Wood("white", true));
  room.AddBox(place * At(0, -0.035f, 0), {0.84f, 0.05f, 1.98f}, room.Wood("white", true),
              {{Face::kFront, room.Fitted(door)}});
  room.AddBox(place * At(0.33f, -0.09f, 1.02f), {0.13f, 0.03f, 0.025f}, room.Plain("steel", Paint(150, 150, 148)));
}

void AddPicture(RoomBuilder& room, const Place& place, float width, float height, int texture, bool is_glowing) {
  constexpr float kDepth = 0.025f;
  const float border = std::min(0.03f, width / 12);
  const Look frame = room.random.Below(2) == 0 ? room.Wood("walnut") : room.Plain("black", Paint(40, 38, 38));
  room.AddBox(place * At(0, -kDepth / 2, 0), {width, kDepth, height}, frame);
  Patch picture =
      BoxFace(place * At(0, -kDepth / 2, border), {width - 2 * border, kDepth + 0.002f, height - 2 * border},
              Face::kFront, room.Fitted(texture, is_glowing));
  room.scene.patches.push_back(picture);
}

}  // namespace yorb
