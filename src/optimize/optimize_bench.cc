// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Our optimisers beside Ceres on the same problems, one thread.
#include <benchmark/benchmark.h>

#include "geometry/common_directions.h"
#include "optimize/ceres_oracle.h"
#include "optimize/pose_graph_oracle.h"
#include "optimize/test_lines.h"
#include "optimize/test_pose_graphs.h"
#include "optimize/test_tours.h"

namespace yorb {
namespace {

void Pose(benchmark::State& state) {
  const PoseProblem problem = MakePoseProblem({});
  for (auto _ : state) benchmark::DoNotOptimize(OptimizePose(problem.guess, problem.observations, problem.projection));
}
BENCHMARK(Pose)->Unit(benchmark::kMicrosecond);

void PoseCeres(benchmark::State& state) {
  const PoseProblem problem = MakePoseProblem({});
  const std::vector<bool> all(problem.observations.size(), true);
  for (auto _ : state) {
    benchmark::DoNotOptimize(CeresOptimizePose(problem.guess, problem.observations, all, problem.projection, 1e-6));
  }
}
BENCHMARK(PoseCeres)->Unit(benchmark::kMicrosecond);

/// What the lines of 100 keyframes have in common.
void Directions(benchmark::State& state) {
  Random random(1);
  std::vector<LinePlane> planes;
  for (int k = 0; k < 100; ++k) {
    for (const LineSight& line : *LinesOfARoom(Eigen::Quaterniond::Identity(), 15, random))
      planes.push_back({line.normal, 1});
  }
  for (auto _ : state) benchmark::DoNotOptimize(CommonDirections(planes));
}
BENCHMARK(Directions)->Unit(benchmark::kMillisecond);

/// A neighbourhood: 20 keyframes, 2000 points, 12000 observations.
WorldProblem LocalWorld() {
  WorldOptions options;
  options.range = 5.2;
  return MakeWorld(options);
}

/// A whole map: 500 keyframes, 50000 points, 300000 observations.
WorldProblem GlobalWorld() { return MakeTour({}); }

/// The same in a smaller place, where each keyframe shares points with a fifth of all others.
WorldProblem TightWorld() {
  TourOptions options;
  options.spacing = 0.1;
  options.share_seen = 0.16;
  return MakeTour(options);
}

/// Both optimisers of a bundle do the same first round, with Huber's loss.
BundleOptions OneRound() {
  BundleOptions options;
  options.first_iterations = 50, options.second_iterations = 0;
  return options;
}

void Report(const WorldProblem& world, int iterations, double cost, benchmark::State& state) {
  state.counters["observations"] = static_cast<double>(world.problem.seen.size());
  state.counters["iterations"] = iterations;
  state.counters["final_cost"] = cost;
}

void Bundle(benchmark::State& state, const WorldProblem& world, const BundleOptions& options) {
  BundleResult result;
  for (auto _ : state) result = AdjustBundle(world.problem, options);
  Report(world, result.iterations, result.final_cost, state);
}
BENCHMARK_CAPTURE(Bundle, Local, LocalWorld(), BundleOptions())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Bundle, LocalOneRound, LocalWorld(), OneRound())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Bundle, Global, GlobalWorld(), BundleOptions())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Bundle, Tight, TightWorld(), BundleOptions())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Bundle, GlobalOneRound, GlobalWorld(), OneRound())->Unit(benchmark::kMillisecond);

void BundleCeres(benchmark::State& state, const WorldProblem& world) {
  const std::vector<bool> all(world.problem.seen.size(), true);
  CeresBundleResult result;
  for (auto _ : state) result = CeresAdjustBundle(world.problem, all, true, 1e-6);
  Report(world, result.iterations, result.cost, state);
}
BENCHMARK_CAPTURE(BundleCeres, Local, LocalWorld())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BundleCeres, Global, GlobalWorld())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BundleCeres, Tight, TightWorld())->Unit(benchmark::kMillisecond);

/// 2000 keyframes with five ties each, and a loop.
PoseGraph LargeGraph() {
  CircleOptions options;
  options.poses = 2000, options.neighbours = 5;
  options.radius = 50;
  options.drift = 1e-4, options.noise = 1e-3;
  return MakeCircle(options).graph;
}

void Graph(benchmark::State& state) {
  const PoseGraph graph = LargeGraph();
  PoseGraphResult result;
  for (auto _ : state) result = AdjustPoseGraph(graph);
  state.counters["iterations"] = result.iterations;
  state.counters["final_cost"] = result.final_cost;
}
BENCHMARK(Graph)->Unit(benchmark::kMillisecond);

void GraphCeres(benchmark::State& state) {
  const PoseGraph graph = LargeGraph();
  CeresPoseGraphResult result;
  for (auto _ : state) result = CeresAdjustPoseGraph(graph, {}, 1e-6);
  state.counters["iterations"] = result.iterations;
  state.counters["final_cost"] = result.cost;
}
BENCHMARK(GraphCeres)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace yorb
