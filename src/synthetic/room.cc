// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic/room.h"

#include <cmath>
#include <numbers>

#include "synthetic/furniture.h"
#include "synthetic/light.h"

namespace yorb {
namespace {

constexpr float kHalfX = 4.f, kHalfY = 3.f, kHeight = 2.7f;

// Places on the walls, `along` metres to the right of the wall's middle as seen from inside, `off` from the wall.
Place OnEastWall(float along, float off, float z = 0) {
  return At(kHalfX - off, -along, z, -std::numbers::pi_v<float> / 2);
}
Place OnWestWall(float along, float off, float z = 0) {
  return At(-kHalfX + off, along, z, std::numbers::pi_v<float> / 2);
}
Place OnNorthWall(float along, float off, float z = 0) { return At(along, kHalfY - off, z, 0); }
Place OnSouthWall(float along, float off, float z = 0) {
  return At(-along, -kHalfY + off, z, std::numbers::pi_v<float>);
}

// A wall, floor or ceiling: the face of the room's own box, seen from inside, with the texture at its own scale.
void AddShell(RoomBuilder& room, const Place& middle_of_foot, float width, float height, int texture, float tile) {
  Look look;
  look.texture = texture;
  look.tile = tile;
  room.scene.patches.push_back(BoxFace(middle_of_foot, {width, 0, height}, Face::kFront, look));
}

void AddWalls(RoomBuilder& room) {
  const Paint warm = Hsv(room.random.Uniform(25, 60), 0.1, 0.92), cool = Hsv(room.random.Uniform(90, 220), 0.1, 0.9);
  const int plaster =
      room.TextureOf("plaster", {2, 2}, [&](cv::Size size, Random& r) { return PaintPlaster(size, warm, r); });
  const int paper =
      room.TextureOf("wallpaper", {2, 2}, [&](cv::Size size, Random& r) { return PaintWallpaper(size, cool, r); });
  const int bricks = room.TextureOf("bricks", {2, 2}, [](cv::Size size, Random& r) { return PaintBricks(size, r); });
  AddShell(room, OnEastWall(0, 0), 2 * kHalfY, kHeight, plaster, 2.6f);
  AddShell(room, OnWestWall(0, 0), 2 * kHalfY, kHeight, bricks, 1.9f);
  AddShell(room, OnNorthWall(0, 0), 2 * kHalfX, kHeight, plaster, 2.6f);
  AddShell(room, OnSouthWall(0, 0), 2 * kHalfX, kHeight, paper, 1.7f);
  const Look skirting = room.Wood("white");
  room.AddBox(OnEastWall(0, 0.008f), {2 * kHalfY, 0.016f, 0.09f}, skirting);
  room.AddBox(OnWestWall(0, 0.008f), {2 * kHalfY, 0.016f, 0.09f}, skirting);
  room.AddBox(OnNorthWall(0, 0.008f), {2 * kHalfX, 0.016f, 0.09f}, skirting);
  room.AddBox(OnSouthWall(0, 0.008f), {2 * kHalfX, 0.016f, 0.09f}, skirting);
}

void AddFloorAndCeiling(RoomBuilder& room) {
  const int boards =
      room.TextureOf("floorboards", {2, 2}, [](cv::Size size, Random& r) { return PaintFloorboards(size, r); });
  const int tiles =
      room.TextureOf("ceiling", {1, 1}, [](cv::Size size, Random& r) { return PaintCeilingTiles(size, r); });
  const int rug = room.TextureOf("rug", {2, 1}, [](cv::Size size, Random& r) { return PaintRug(size, r); });
  Look floor, ceiling;
  floor.texture = boards;
  floor.tile = 2.2f;
  ceiling.texture = tiles;
  ceiling.tile = 1.2f;
  Patch patch = BoxFace(At(0, 0, 0), {2 * kHalfX, 2 * kHalfY, 0}, Face::kTop, floor);
  patch.is_floor = true;
  room.scene.patches.push_back(patch);
  room.scene.patches.push_back(BoxFace(At(0, 0, kHeight), {2 * kHalfX, 2 * kHalfY, 0}, Face::kBottom, ceiling));
  patch = BoxFace(At(-1, 0, 0), {2.9f, 1.9f, 0.009f}, Face::kTop, room.Fitted(rug));
  patch.is_floor = true;
  room.scene.patches.push_back(patch);
}

void AddLamps(RoomBuilder& room) {
  const int light = room.TextureOf("glow", {0.25f, 0.25f},
                                   [](cv::Size size, Random& r) { return PaintMetal(size, Paint(246, 252, 255), r); });
  for (const float x : {-2.1f, 2.1f}) {
    for (const float y : {-1.4f, 1.4f}) {
      room.scene.patches.push_back(
          BoxFace(At(x, y, kHeight - 0.03f), {0.9f, 0.4f, 0.02f}, Face::kBottom, room.Fitted(light, true)));
      room.scene.lamps.push_back({{x, y, kHeight - 0.04f}, {0, 0.2f, 0}, {0.45f, 0, 0}, 1.6f});  // u x v points down
    }
  }
  room.scene.lamps.push_back(
      {{1.2f, kHalfY - 0.05f, 1.6f}, {0.7f, 0, 0}, {0, 0, 0.6f}, 1.3f});  // the window: u x v points south
}

// The desk that the camera looks at: its front looks west, seen from inside the room.
void AddDesk(RoomBuilder& room) {
  const Eigen::Vector3f size(1.9f, 0.85f, 0.74f);
  const Place desk = At(2.25f, 0, 0, -std::numbers::pi_v<float> / 2);
  AddTable(room, desk, size, "oak");
  const Place top = desk * At(0, 0, size.z());
  AddMonitor(room, top * At(-0.33f, 0.2f, 0, 0.12f), 0);
  AddMonitor(room, top * At(0.3f, 0.2f, 0, -0.15f), 1);
  AddKeyboard(room, top * At(-0.25f, -0.17f, 0, room.Between(-0.1f, 0.1f)));
  room.AddBox(top * At(0.08f, -0.17f, 0, 0.2f), {0.06f, 0.1f, 0.03f}, room.Plain("steel", Paint(150, 150, 148)));
  AddPaper(room, top * At(0.28f, -0.22f, 0, room.Between(-0.5f, 0.5f)));
  AddPaper(room, top * At(0.46f, -0.18f, 0.004f, room.Between(-0.5f, 0.5f)));
  AddMug(room, top * At(room.Between(0.55f, 0.65f), -0.05f, 0, room.Between(-2, 2)));
  AddBookPile(room, top * At(0.78f, -0.1f, 0), 5);
  AddGlobe(room, top * At(0.76f, 0.22f, 0));
  AddDeskLamp(room, top * At(-0.8f, 0.1f, 0, -0.5f));
  AddBookPile(room, top * At(-0.76f, -0.2f, 0), 3);
  AddMug(room, top * At(-0.58f, 0.02f, 0, room.Between(-2, 2)));
  AddPackage(room, top * At(-0.02f, 0.3f, 0), {0.09f, 0.07f, 0.21f});
  AddChair(room, desk * At(-1.35f, -0.1f, 0, 1.9f));
}

void AddEastSide(RoomBuilder& room) {
  AddBookcase(room, OnEastWall(-1.5f, 0.16f), {1.2f, 0.3f, 2.0f}, 6);
  AddCabinet(room, OnEastWall(0.05f, 0.2f), {1.3f, 0.38f, 0.8f}, 3, 3);
  AddBooks(room, OnEastWall(-0.5f, 0.2f, 0.8f), 0.5f, 0.28f);
  AddPlant(room, OnEastWall(0.5f, 0.2f, 0.8f), 0.42f);
  AddPicture(room, OnEastWall(-0.35f, 0, 1.28f), 0.6f, 0.8f, PictureTexture(room, 0));
  AddPicture(room, OnEastWall(0.45f, 0, 1.38f), 0.7f, 0.55f, PictureTexture(room, 1));
  AddPicture(room, OnEastWall(1.2f, 0, 1.2f), 0.55f, 0.75f, PictureTexture(room, 2));
  AddPlant(room, OnEastWall(1.5f, 0.4f), 1.2f);
  AddPicture(room, OnEastWall(2.2f, 0, 1.15f), 0.9f, 0.7f, PictureTexture(room, 3));
  AddPackage(room, OnEastWall(2.3f, 0.3f), {0.5f, 0.4f, 0.35f});
  AddPackage(room, OnEastWall(2.35f, 0.3f, 0.35f), {0.36f, 0.3f, 0.25f});
}

void AddWestSide(RoomBuilder& room) {
  AddCabinet(room, OnWestWall(0, 0.23f), {2.2f, 0.42f, 0.72f}, 4, 2);
  AddBooks(room, OnWestWall(-0.95f, 0.23f, 0.72f), 0.6f, 0.26f);
  AddGlobe(room, OnWestWall(0.05f, 0.2f, 0.72f));
  AddPackage(room, OnWestWall(0.42f, 0.22f, 0.72f), {0.2f, 0.15f, 0.26f});
  AddBookPile(room, OnWestWall(0.8f, 0.23f, 0.72f), 6);
  AddPicture(room, OnWestWall(-0.7f, 0, 1.35f), 0.8f, 0.6f, PictureTexture(room, 5));
  AddPicture(room, OnWestWall(0.25f, 0, 1.25f), 0.6f, 0.8f, PictureTexture(room, 4));
  AddPicture(room, OnWestWall(1.05f, 0, 1.4f), 0.5f, 0.5f, PictureTexture(room, 6));
  AddPlant(room, OnWestWall(-1.65f, 0.4f), 1.35f);
  AddBookcase(room, OnWestWall(2.1f, 0.16f), {1.1f, 0.3f, 1.9f}, 5);
  AddFloorLamp(room, OnWestWall(-2.4f, 0.4f));
}

void AddNorthSide(RoomBuilder& room) {
  const int view = room.TextureOf("window", {1, 1}, [](cv::Size size, Random& r) { return PaintWindow(size, r); });
  AddPicture(room, OnNorthWall(1.2f, 0, 1.0f), 1.5f, 1.3f, view, true);
  room.AddBox(OnNorthWall(1.2f, 0.09f, 0.96f), {1.7f, 0.18f, 0.03f}, room.Wood("white"));
  AddPlant(room, OnNorthWall(0.7f, 0.1f, 0.99f), 0.35f);
  AddBookPile(room, OnNorthWall(1.6f, 0.1f, 0.99f), 3);
  AddSofa(room, OnNorthWall(-1.4f, 0.43f), 1.9f);
  AddPicture(room, OnNorthWall(-1.9f, 0, 1.2f), 0.7f, 0.9f, PictureTexture(room, 7));
  AddPicture(room, OnNorthWall(-1.0f, 0, 1.25f), 0.9f, 0.7f, PictureTexture(room, 8));
  AddCabinet(room, OnNorthWall(1.2f, 0.2f), {1.4f, 0.36f, 0.7f}, 2, 2);
  AddBookcase(room, OnNorthWall(-3.2f, 0.16f), {0.9f, 0.3f, 1.7f}, 4);
  AddPicture(room, OnNorthWall(3.1f, 0, 1.2f), 0.7f, 0.9f, PictureTexture(room, 10));
}

void AddSouthSide(RoomBuilder& room) {
  AddDoor(room, OnSouthWall(-0.3f, 0));
  AddPicture(room, OnSouthWall(0.75f, 0, 1.1f), 0.7f, 1.0f, PictureTexture(room, 11));
  AddBookcase(room, OnSouthWall(1.9f, 0.16f), {1.3f, 0.3f, 2.0f}, 6);
  AddPicture(room, OnSouthWall(3.1f, 0, 1.2f), 0.8f, 0.6f, PictureTexture(room, 9));
  AddChair(room, OnSouthWall(0.8f, 0.35f));
  AddCabinet(room, OnSouthWall(-1.75f, 0.23f), {1.5f, 0.42f, 0.9f}, 3, 3);
  AddMonitor(room, OnSouthWall(-1.5f, 0.23f, 0.9f), 2);
  AddBooks(room, OnSouthWall(-2.4f, 0.23f, 0.9f), 0.45f, 0.27f);
  AddMug(room, OnSouthWall(-1.1f, 0.3f, 0.9f));
  AddPicture(room, OnSouthWall(-2.3f, 0, 1.45f), 0.6f, 0.75f, PictureTexture(room, 12));
  AddPicture(room, OnSouthWall(-3.2f, 0, 1.1f), 0.6f, 0.8f, PictureTexture(room, 13));
}

Stage MakeStage() {
  Stage stage;
  stage.focus = {2.35, 0, 0.95};
  stage.stand = {0.35, 0, 1.35};
  stage.loop_centre = {-1, 0, 1.4};
  stage.loop_radii = {1.15, 1.0};
  stage.routes.emplace_back(
      std::vector<Eigen::Vector2d>{{1.42, -0.9}, {1.42, 0.9}, {2.3, 1.55}, {3.15, 0.9}, {3.15, -0.9}, {2.3, -1.7}});
  std::vector<Eigen::Vector2d> ring;
  for (int i = 0; i < 8; ++i)
    ring.emplace_back(-1 + 2.0 * std::cos(i * std::numbers::pi_v<float> / 4),
                      1.85 * std::sin(i * std::numbers::pi_v<float> / 4));
  stage.routes.emplace_back(ring);
  return stage;
}

}  // namespace

Room MakeRoom(const RoomOptions& options) {
  RoomBuilder room(options.texture_size, options.seed);
  AddLamps(room);  // first: turned things are lit as they are added
  AddWalls(room);
  AddFloorAndCeiling(room);
  AddDesk(room);
  AddEastSide(room);
  AddWestSide(room);
  AddNorthSide(room);
  AddSouthSide(room);
  LightOptions light;
  light.num_threads = options.num_threads;
  if (!options.has_shadows) light.lamp_rays = light.corner_rays = 0;
  BakeLight(light, room.scene);
  return {std::move(room.scene), MakeStage()};
}

}  // namespace yorb
