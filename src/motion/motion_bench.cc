// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include "map/synthetic_world.h"
#include "motion/mover_finder.h"
#include "motion/test_scene.h"

namespace yorb {
namespace {

/// A sensor of 640 x 480 before a wall with a box.
Rig WideRig() {
  Rig rig = DepthTestRig();
  rig.camera.width = 640;
  rig.camera.height = 480;
  rig.camera.fx = rig.camera.fy = 520;
  rig.camera.cx = 319.5;
  rig.camera.cy = 239.5;
  return rig;
}

TestView Look(const Rig& rig, double box_x) {
  Random random(1);
  return LookAtBoxes(rig, Rigid3::Identity(), {{{-9, -9, 3}, {9, 9, 3.1}}, {{box_x, -0.5, 2}, {box_x + 0.5, 0.5, 2.2}}},
                     random);
}

void BM_MakeDepthGrid(benchmark::State& state) {
  const Rig rig = WideRig();
  const DepthGridMaker grids(rig);
  DepthImage depth{cv::Mat(), 0.001};
  Look(rig, 0).depth.pixels.convertTo(depth.pixels, CV_16UC1, 1000);
  for (auto _ : state) benchmark::DoNotOptimize(grids.Make(depth));
}
BENCHMARK(BM_MakeDepthGrid)->Unit(benchmark::kMicrosecond);

/// Thirty pictures a second of a box that slides, with 1000 points of which the map knows half.
void BM_FindMovers(benchmark::State& state) {
  const SyntheticWorld world(1);
  const Map map = MapWithOneKeyframe();
  const Rig rig = WideRig();
  const DepthGridMaker grids(rig);
  std::vector<DepthGrid> views;
  for (int k = 0; k < 90; ++k) views.push_back(grids.Make(Look(rig, -1 + k / 60.0).depth));
  const auto frame_at = [&](size_t k) {
    auto frame =
        std::make_shared<Frame>(*world.Look(Rigid3::Identity(), FrameId(static_cast<uint32_t>(k)), Timestamp{0}).frame);
    frame->rig = std::make_shared<const Rig>(rig);
    frame->timestamp = Timestamp{static_cast<int64_t>(k) * 33333333};
    std::vector<bool> is_known(frame->size());
    for (size_t i = 0; i < is_known.size(); i += 2) is_known[i] = true;
    return PosedFrame{frame, std::move(is_known), {KeyframeId(0), Rigid3::Identity()}};
  };
  MoverFinder finder;
  size_t k = 0;
  for (auto _ : state) {
    state.PauseTiming();
    PosedFrame now = frame_at(k);
    if (k % views.size() == 0) finder.Forget();
    state.ResumeTiming();
    benchmark::DoNotOptimize(finder.Find(std::move(now), views[k % views.size()], map));
    ++k;
  }
}
BENCHMARK(BM_FindMovers)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace yorb
