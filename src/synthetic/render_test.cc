// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic/render.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <optional>

#include "synthetic/camera_path.h"
#include "synthetic/mannequin.h"
#include "synthetic/room.h"
#include "synthetic/seen_patch.h"
#include "synthetic/sequence.h"
#include "synthetic/solids.h"

namespace yorb {
namespace {

struct Hit {
  double depth = 0;
  int person = 0;
};

// The slow twin: one ray against every patch, in the world, in double precision. `grow` widens the patches.
Hit CastRay(const Scene& scene, const MovingThings& moving, const Rigid3& world_from_cam,
            const Eigen::Vector3d& ray_in_cam, double grow) {
  const Eigen::Vector3d from = world_from_cam.translation, ray = world_from_cam.rotation * ray_in_cam;
  Hit nearest{1e9, 0};
  for (const auto* patches : {&scene.patches, &moving.patches}) {
    for (const Patch& patch : *patches) {
      Eigen::Matrix3d columns;
      columns << patch.edge_s.cast<double>(), patch.edge_t.cast<double>(), -ray;
      if (std::abs(columns.determinant()) < 1e-14) continue;
      const Eigen::Vector3d solved = columns.inverse() * (from - patch.corner.cast<double>());
      const double s = solved[0], t = solved[1], z = solved[2];
      if (z < kNearDepth || z >= nearest.depth || s < -grow || t < -grow) continue;
      if (patch.is_triangle ? s + t > 1 + grow : s > 1 + grow || t > 1 + grow) continue;
      if (!patch.is_two_sided && patch.edge_s.cross(patch.edge_t).cast<double>().dot(ray) > 0) continue;
      nearest = {z, patch.person};
    }
  }
  return nearest.depth < 1e9 ? nearest : Hit{};
}

Rig SmallRig(bool has_distortion) {
  Rig rig = SyntheticRig(93, 70);  // no multiples of a tile's side
  if (has_distortion) rig.camera.distortion = {0.15, -0.3, 0.002, -0.001, 0.05, 0, 0, 0};
  return rig;
}

// A room with two people in it, as seen by small cameras.
class RendererInRoom : public testing::TestWithParam<bool> {
 protected:
  static Room MakeSmallRoom() {
    RoomOptions options;
    options.texture_size = 64;
    options.has_shadows = false;
    return MakeRoom(options);
  }
};

TEST_P(RendererInRoom, AgreesWithRaysCastOneByOne) {
  Room room = MakeSmallRoom();
  MovingThings moving;
  for (int person : {1, 2}) {
    Mannequin({0, person * 3.2, 1, 1.75}, room.stage.routes[0], person, 5, room.scene).AddTo(moving, room.scene, 0.3);
  }
  const Pinhole camera = SmallRig(GetParam()).camera;
  const Renderer renderer(camera);
  for (const PathKind kind : {PathKind::kHalfsphere, PathKind::kLoop}) {
    const Rigid3 world_from_cam = CameraPath(kind, room.stage, 10, 1).WorldFromCamera(2.3);
    const RenderedView view = renderer.Render(room.scene, moving, world_from_cam);
    int num_compared = 0;
    for (int y = 0; y < camera.height; y += 3) {
      for (int x = 0; x < camera.width; x += 2) {
        const Eigen::Vector2f ideal =
            camera.Undistort({Eigen::Vector2f(static_cast<float>(x), static_cast<float>(y))}).front();
        const Eigen::Vector3d ray = camera.Unproject(ideal.x(), ideal.y(), 1);
        const Hit narrow = CastRay(room.scene, moving, world_from_cam, ray, -2e-4),
                  wide = CastRay(room.scene, moving, world_from_cam, ray, 4e-4);
        if (std::abs(narrow.depth - wide.depth) > 1e-6) continue;  // on an edge to within rounding
        ++num_compared;
        ASSERT_NEAR(view.depth.at<float>(y, x), wide.depth, 2e-5 * wide.depth) << x << " " << y;
        ASSERT_EQ(view.mask.at<uchar>(y, x), wide.person) << x << " " << y;
      }
    }
    EXPECT_GT(num_compared, 1000);
  }
}

INSTANTIATE_TEST_SUITE_P(Lenses, RendererInRoom, testing::Values(false, true));

// A board at z = `depth` that looks at the camera, in the camera's frame; the world is the camera's frame.
Patch Board(float depth, float left, float right, int texture) {
  Patch board;
  board.corner = {left, 0.5f, depth};
  board.edge_s = {right - left, 0, 0};
  board.edge_t = {0, -1, 0};
  board.uv = {0, 1};
  board.uv_s = {1, 0};
  board.uv_t = {0, -1};
  board.texture = texture;
  return board;
}

Scene PaintedBoards() {
  Scene scene;
  scene.textures.emplace_back(cv::Mat(4, 4, CV_8UC3, cv::Scalar(200, 100, 50)));
  scene.textures.emplace_back(cv::Mat(4, 4, CV_8UC3, cv::Scalar(0, 0, 0)));
  return scene;
}

TEST(Renderer, NearerThingsHideFartherOnesWhateverTheOrder) {
  Scene scene = PaintedBoards();
  const Pinhole camera = SmallRig(false).camera;
  scene.patches = {Board(2, -1, 1, 0), Board(1, -1, 0, 1)};
  const RenderedView view = Renderer(camera).Render(scene, {}, {});
  std::swap(scene.patches[0], scene.patches[1]);
  const RenderedView swapped = Renderer(camera).Render(scene, {}, {});
  EXPECT_EQ(cv::norm(view.colour, swapped.colour), 0);
  EXPECT_NEAR(view.depth.at<float>(36, 30), 1, 1e-5);
  EXPECT_NEAR(view.depth.at<float>(36, 60), 2, 1e-5);
  EXPECT_EQ(view.colour.at<cv::Vec3b>(36, 60), cv::Vec3b(200, 100, 50));
}

TEST(Renderer, EdgesAreMixedByWhatCoversThePixel) {
  Scene scene = PaintedBoards();
  Pinhole camera = SmallRig(false).camera;
  camera.cx = 40;  // the black board's right edge, x = 0, runs through the middle of column 40
  scene.patches = {Board(2, -1, 1, 0), Board(1, -1, 0, 1)};
  const RenderedView view = Renderer(camera).Render(scene, {}, {});
  EXPECT_EQ(view.colour.at<cv::Vec3b>(36, 39)[0], 0);
  EXPECT_NEAR(view.colour.at<cv::Vec3b>(36, 40)[0], 100, 1);
  EXPECT_EQ(view.colour.at<cv::Vec3b>(36, 41)[0], 200);
}

TEST(Renderer, BacksAreNotSeenUnlessAPatchHasTwoSides) {
  Scene scene = PaintedBoards();
  Patch board = Board(1, -1, 1, 0);
  board.corner += board.edge_s;
  board.edge_s = -board.edge_s;  // now it looks away
  scene.patches = {board};
  const Renderer renderer(SmallRig(false).camera);
  EXPECT_EQ(renderer.Render(scene, {}, {}).depth.at<float>(36, 48), 0);
  scene.patches[0].is_two_sided = true;
  EXPECT_NEAR(renderer.Render(scene, {}, {}).depth.at<float>(36, 48), 1, 1e-5);
}

TEST(Renderer, AFloorThatRunsUnderTheCameraNeedsNoClipping) {
  Scene scene = PaintedBoards();
  Patch floor;
  floor.corner = {-20, 1.2f, 20};  // y is down: 1.2 m below, from 20 m before to 20 m behind the camera
  floor.edge_s = {0, 0, -40};
  floor.edge_t = {40, 0, 0};
  floor.is_two_sided = true;
  scene.patches = {floor};
  const Pinhole camera = SmallRig(false).camera;
  const RenderedView view = Renderer(camera).Render(scene, {}, {});
  for (int y = 42; y < camera.height; y += 5) {
    EXPECT_NEAR(view.depth.at<float>(y, 20), 1.2 * camera.fy / (y - camera.cy), 1e-4 * view.depth.at<float>(y, 20))
        << y;
  }
  EXPECT_EQ(view.depth.at<float>(20, 20), 0);
}

}  // namespace
}  // namespace yorb
