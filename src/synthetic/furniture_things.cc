// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "synthetic/furniture.h"

namespace yorb {
namespace {

constexpr int kSpineColumns = 16, kSpineRows = 2;  // of the atlas of book spines

// A book's spine, and its cover in a colour taken from the spine's edge.
std::pair<Look, Look> BookLooks(RoomBuilder& room) {
  const std::string atlas = "spines " + std::to_string(room.random.Below(2));
  Look spine = room.Fitted(room.TextureOf(
      atlas, {1, 1}, [](cv::Size size, Random& r) { return PaintBookSpines(size, kSpineColumns, kSpineRows, r); }));
  const auto column = static_cast<float>(room.random.Below(kSpineColumns)),
             row = static_cast<float>(room.random.Below(kSpineRows));
  const float width = 1.f / kSpineColumns, height = 1.f / kSpineRows;
  spine.part = {column * width, row * height, width, height};
  Look cover = spine;
  cover.part = {(column + 0.1f) * width, (row + 0.75f) * height, 0.1f * width, 0.1f * height};
  return {spine, cover};
}

}  // namespace

void AddBooks(RoomBuilder& room, const Place& place, float width, float max_height) {
  const Look pages = room.Plain("pages", Paint(205, 222, 230));
  for (float x = 0; x < width - 0.05f;) {
    const float thickness = room.Between(0.016f, 0.048f), depth = room.Between(0.13f, 0.2f);
    const float height = std::min(max_height, room.Between(0.17f, 0.29f));
    const auto [spine, cover] = BookLooks(room);
    room.AddBox(place * At(x + thickness / 2, depth / 2 - 0.09f + room.Between(-0.012f, 0.012f), 0),
                {thickness, depth, height}, cover, {{Face::kFront, spine}, {Face::kTop, pages}});
    x += thickness + (room.random.Below(12) == 0 ? 0.04f : 0.0015f);
  }
}

void AddBookPile(RoomBuilder& room, const Place& place, int num_books) {
  const Look pages = room.Plain("pages", Paint(205, 222, 230));
  float z = 0;
  for (int i = 0; i < num_books; ++i) {
    const float thickness = room.Between(0.015f, 0.045f);
    const auto [spine, cover] = BookLooks(room);
    Look lying = spine;
    lying.is_turned = true;
    const int picture = PictureTexture(room, static_cast<int>(room.random.Below(8)));
    room.AddBox(
        place * At(room.Between(-0.01f, 0.01f), room.Between(-0.01f, 0.01f), z, room.Between(-0.25f, 0.25f)),
        {room.Between(0.15f, 0.2f), room.Between(0.19f, 0.24f), thickness}, pages,
        {{Face::kTop, room.Fitted(picture)}, {Face::kFront, cover}, {Face::kLeft, cover}, {Face::kRight, lying}});
    z += thickness;
  }
}

void AddMonitor(RoomBuilder& room, const Place& place, int number) {
  const Look black = room.Plain("black", Paint(40, 38, 38));
  const int screen = room.TextureOf("screen " + std::to_string(number), {1, 0.5f},
                                    [](cv::Size size, Random& r) { return PaintScreen(size, r); });
  room.AddBox(place, {0.24f, 0.18f, 0.015f}, black);
  room.AddBox(place * At(0, 0.03f, 0.015f), {0.06f, 0.03f, 0.2f}, black);
  room.AddBox(place * At(0, 0, 0.13f), {0.54f, 0.035f, 0.33f}, black, {{Face::kFront, room.Fitted(screen, true)}});
}

void AddKeyboard(RoomBuilder& room, const Place& place) {
  const int keys =
      room.TextureOf("keys", {0.5f, 0.25f}, [](cv::Size size, Random& r) { return PaintKeyboard(size, r); });
  room.AddBox(place, {0.44f, 0.14f, 0.018f}, room.Plain("black", Paint(40, 38, 38)), {{Face::kTop, room.Fitted(keys)}});
}

void AddPaper(RoomBuilder& room, const Place& place) {
  const std::string name = "page " + std::to_string(room.random.Below(4));
  const int page = room.TextureOf(name, {0.5f, 0.5f}, [](cv::Size size, Random& r) { return PaintPage(size, r); });
  room.AddBox(place, {0.21f, 0.297f, 0.003f}, room.Plain("pages", Paint(205, 222, 230)),
              {{Face::kTop, room.Fitted(page)}});
}

void AddMug(RoomBuilder& room, const Place& place) {
  const std::string name = "mug " + std::to_string(room.random.Below(4));
  const int glaze =
      room.TextureOf(name, {0.25f, 0.25f}, [](cv::Size size, Random& r) { return PaintPackage(size, r); });
  const int coffee = room.Plain("coffee", Paint(20, 34, 56)).texture;
  room.AddTurned(place, {{0, 0.036f, 0.036f}, {0.095f, 0.042f, 0.042f}, {0.0951f, 0.036f, 0.036f}}, glaze);
  room.AddTurned(place, {{0.092f, 0.038f, 0.038f}, {0.0952f, 0, 0}}, coffee);
  room.AddBox(place * At(0.055f, 0, 0.02f), {0.035f, 0.012f, 0.055f}, room.Fitted(glaze));
}

void AddGlobe(RoomBuilder& room, const Place& place) {
  const int map = room.TextureOf("globe", {1, 0.5f}, [](cv::Size size, Random& r) { return PaintMap(size, r); });
  const int wood = room.Wood("walnut").texture;
  room.AddTurned(place, {{0, 0.09f, 0.09f}, {0.025f, 0.08f, 0.08f}, {0.03f, 0.015f, 0.015f}, {0.07f, 0.012f, 0.012f}},
                 wood);
  room.AddTurned(place * At(0, 0, 0.06f, 1), EllipsoidSlices(0.28f, 0.14f, 0.14f, 13), map, 24);
}

void AddPackage(RoomBuilder& room, const Place& place, const Eigen::Vector3f& size) {
  const std::string name = "package " + std::to_string(room.random.Below(5));
  const int print = room.TextureOf(name, {0.5f, 0.5f}, [](cv::Size s, Random& r) { return PaintPackage(s, r); });
  room.AddBox(place * At(0, 0, 0, room.Between(-0.2f, 0.2f)), size, room.Fitted(print));
}

void AddDeskLamp(RoomBuilder& room, const Place& place) {
  const int red = room.Plain("red", Paint(50, 50, 190)).texture;
  room.AddTurned(place, {{0, 0.085f, 0.085f}, {0.02f, 0.08f, 0.08f}, {0.022f, 0, 0}}, red);
  room.AddTurned(place, {{0.02f, 0.01f, 0.01f}, {0.36f, 0.01f, 0.01f}}, red, 8);
  const Place head = place * At(0, -0.08f, 0.33f) * Place(Eigen::AngleAxisf(0.7f, Eigen::Vector3f::UnitX()));
  room.AddTurned(head, {{0, 0.09f, 0.09f}, {0.1f, 0.04f, 0.04f}, {0.12f, 0, 0}}, red);
}

int PictureTexture(RoomBuilder& room, int number) {
  return room.TextureOf("picture " + std::to_string(number), {1, 1}, [&](cv::Size size, Random& r) {
    switch (number % 4) {
      case 0:
        return PaintPoster(size, r);
      case 1:
        return PaintLandscape(size, r);
      case 2:
        return PaintAbstract(size, r);
      default:
        return PaintMap(size, r);
    }
  });
}

}  // namespace yorb
