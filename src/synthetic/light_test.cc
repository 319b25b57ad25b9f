// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic/light.h"

#include <gtest/gtest.h>

#include "synthetic/solids.h"

namespace yorb {
namespace {

// A lamp 2 m above a floor of 4 x 4 m, and a box of a metre in between.
Scene LampAndFloor(bool has_box) {
  Scene scene;
  Look look;
  scene.textures.emplace_back(cv::Mat(1, 1, CV_8UC3, cv::Scalar::all(100)));
  scene.patches.push_back(BoxFace(Eigen::Isometry3f::Identity(), {4, 4, 0}, Face::kTop, look));
  scene.lamps.push_back({{0, 0, 2}, {0, 0.1f, 0}, {0.1f, 0, 0}, 2});
  if (has_box) scene.occluders.emplace_back(Eigen::Vector3f(-0.3f, -0.3f, 1), Eigen::Vector3f(0.3f, 0.3f, 1.2f));
  return scene;
}

float FloorLight(Scene scene, float s, float t, int num_threads = 1) {
  LightOptions options;
  options.num_threads = num_threads;
  BakeLight(options, scene);
  return scene.light_maps.at(static_cast<size_t>(scene.patches[0].light_map)).At(s, t);
}

TEST(BakeLight, IsBrightUnderTheLampAndDarkInAShadow) {
  const float open = FloorLight(LampAndFloor(false), 0.5f, 0.5f), shadow = FloorLight(LampAndFloor(true), 0.5f, 0.5f);
  EXPECT_NEAR(open, OpenLight(LampAndFloor(false), {0, 0, 0}, Eigen::Vector3f::UnitZ()), 0.02);
  EXPECT_GT(open, FloorLight(LampAndFloor(false), 0, 0) + 0.2f);
  EXPECT_LT(shadow, LampAndFloor(true).ambient + 0.01f);
  EXPECT_NEAR(FloorLight(LampAndFloor(true), 0, 0), FloorLight(LampAndFloor(false), 0, 0), 0.05);
}

TEST(BakeLight, DoesNotDependOnTheThreads) {
  Scene one = LampAndFloor(true), three = LampAndFloor(true);
  one.patches.resize(5, one.patches[0]);
  three.patches.resize(5, three.patches[0]);
  LightOptions options;
  BakeLight(options, one);
  options.num_threads = 3;
  BakeLight(options, three);
  ASSERT_EQ(one.light_maps.size(), 5u);
  for (size_t i = 0; i < 5; ++i) EXPECT_EQ(one.light_maps[i].nodes, three.light_maps[i].nodes);
}

TEST(LightMap, IsLinearBetweenItsNodes) {
  LightMap map{3, 2, {0, 1, 2, 10, 11, 12}};
  EXPECT_FLOAT_EQ(map.At(0, 0), 0);
  EXPECT_FLOAT_EQ(map.At(0.25f, 0.5f), 5.5f);
  EXPECT_FLOAT_EQ(map.At(1, 1), 12);
  EXPECT_FLOAT_EQ(map.At(2, -1), 2) << "held at the borders";
}

}  // namespace
}  // namespace yorb
