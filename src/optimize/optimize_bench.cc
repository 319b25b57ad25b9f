// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Our optimisers beside Ceres on the same problems, one thread.
#include <benchmark/benchmark.h>

#include "optimize/ceres_oracle.h"
#include "optimize/test_problems.h"

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

/// 20 keyframes, 2000 points.
WorldProblem LocalWorld() {
  WorldOptions options;
  options.range = 5.2;
  return MakeWorld(options);
}

void Bundle(benchmark::State& state) {
  const WorldProblem world = LocalWorld();
  BundleResult result;
  for (auto _ : state) result = AdjustBundle(world.problem, {});
  state.counters["observations"] = static_cast<double>(world.problem.seen.size());
  state.counters["iterations"] = result.iterations;
  state.counters["final_cost"] = result.final_cost;
}
BENCHMARK(Bundle)->Unit(benchmark::kMillisecond);

void BundleCeres(benchmark::State& state) {
  const WorldProblem world = LocalWorld();
  const std::vector<bool> all(world.problem.seen.size(), true);
  CeresBundleResult result;
  for (auto _ : state) result = CeresAdjustBundle(world.problem, all, true, 1e-6);
  state.counters["observations"] = static_cast<double>(world.problem.seen.size());
  state.counters["iterations"] = result.iterations;
  state.counters["final_cost"] = result.cost;
}
BENCHMARK(BundleCeres)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace yorb
