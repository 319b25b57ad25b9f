// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <filesystem>

#include "map/map_file.h"
#include "map/test_map.h"

namespace yorb {
namespace {

std::string Path() { return (std::filesystem::temp_directory_path() / "map_bench.map").string(); }

/// Rooms of a hundred keyframes each.
const Map& MapOf(int64_t num_keyframes) {
  static Map map;
  if (map.num_keyframes() != static_cast<size_t>(num_keyframes)) {
    map = *Map::FromParts(SyntheticMapParts(static_cast<int>(num_keyframes / 100), 100));
  }
  return map;
}

void Label(benchmark::State& state, const Map& map) {
  state.SetLabel(std::to_string(map.num_landmarks()) + " landmarks, " +
                 std::to_string(std::filesystem::file_size(Path()) >> 20) + " MiB");
}

void BM_WriteMap(benchmark::State& state) {
  const Map& map = MapOf(state.range(0));
  for (auto _ : state) {
    if (!WriteMapFile(Path(), map, {})) state.SkipWithError("cannot be written");
  }
  Label(state, map);
}

void BM_ReadMap(benchmark::State& state) {
  const Map& map = MapOf(state.range(0));
  if (!WriteMapFile(Path(), map, {})) state.SkipWithError("cannot be written");
  for (auto _ : state) {
    const auto read = ReadMapFile(Path());
    if (!read) state.SkipWithError("cannot be read");
  }
  Label(state, map);
  std::filesystem::remove(Path());
}

BENCHMARK(BM_WriteMap)->Unit(benchmark::kMillisecond)->Arg(1000)->Arg(10000)->UseRealTime();
BENCHMARK(BM_ReadMap)->Unit(benchmark::kMillisecond)->Arg(1000)->Arg(10000)->UseRealTime();

}  // namespace
}  // namespace yorb
