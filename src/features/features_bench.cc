// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Every stage of the extractor beside its portable twin, and the whole beside cv::ORB and the way ORB-SLAM2 does it.
// On a picture of fr1_xyz where the real data are there, on a synthetic one elsewhere.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <opencv2/features2d.hpp>

#include "features/adaptive_fast.h"
#include "features/blur.h"
#include "features/descriptor.h"
#include "features/hamming.h"
#include "features/line_segments.h"
#include "features/orb_extractor.h"
#include "features/original_extractor.h"
#include "features/pyramid.h"
#include "features/quadtree.h"
#include "features/test_pictures.h"
#include "pictures/picture_file.h"

namespace yorb {
namespace {

constexpr int kLevels = 8, kWanted = 1000;
constexpr double kFactor = 1.2;

cv::Mat LoadPicture() {
  std::vector<cv::String> files;
  if (const std::string folder = DataFolder("fr1_xyz/rgb"); !folder.empty()) cv::glob(folder, files);
  if (files.empty()) return RectanglesPicture(640, 480, 1);
  const std::string& file = files[files.size() / 3];
  const auto picture = ToColourAndGrey(ReadPictureFile(file).pixels, file);
  YORB_CHECK(picture.ok(), file.c_str());
  return picture->grey;
}

const cv::Mat& Picture() {
  static const cv::Mat picture = LoadPicture();
  return picture;
}

GreyView View() { return {Picture().data, Picture().cols, Picture().rows, static_cast<ptrdiff_t>(Picture().step[0])}; }

const Pyramid& Levels() {
  static const Pyramid pyramid = [] {
    Pyramid built;
    built.Build(View(), kLevels, kFactor, BestInstructions());
    return built;
  }();
  return pyramid;
}

CornerArea InnerArea(const GreyView& level) {
  return {kFeatureBorder, kFeatureBorder, level.width - kFeatureBorder, level.height - kFeatureBorder};
}

/// range(0): 0 portable, 1 the best instructions.
Instructions PathOf(const benchmark::State& state) {
  return state.range(0) == 0 ? Instructions::kPortable : BestInstructions();
}

void BM_Pyramid(benchmark::State& state) {
  Pyramid pyramid;
  for (auto _ : state) pyramid.Build(View(), kLevels, kFactor, PathOf(state));
}
BENCHMARK(BM_Pyramid)->ArgName("wide")->Arg(0)->Arg(1);

void BM_PyramidOpenCv(benchmark::State& state) {
  std::vector<cv::Mat> levels(kLevels);
  levels[0] = Picture();
  for (auto _ : state) {
    for (size_t level = 1; level < kLevels; ++level) {
      const GreyView& view = Levels().Level(static_cast<int>(level));
      cv::resize(levels[level - 1], levels[level], {view.width, view.height}, 0, 0, static_cast<int>(state.range(0)));
    }
  }
}
BENCHMARK(BM_PyramidOpenCv)->ArgName("flag")->Arg(cv::INTER_LINEAR)->Arg(cv::INTER_LINEAR_EXACT);

void BM_Fast(benchmark::State& state) {
  Fast fast;
  const FastOptions options{static_cast<int>(state.range(1)), static_cast<int>(state.range(2)), kFeatureBorder};
  for (auto _ : state) {
    for (int level = 0; level < kLevels; ++level) {
      benchmark::DoNotOptimize(fast.Detect(Levels().Level(level), options, PathOf(state)).data());
    }
  }
}
BENCHMARK(BM_Fast)->ArgNames({"wide", "threshold", "arc"})->ArgsProduct({{0, 1}, {4, 7, 20}, {9, 12}});

void BM_Detector(benchmark::State& state) {
  CornerDetector detector;
  CornerOptions options;
  options.is_adaptive = state.range(1) == 1;
  for (auto _ : state) {
    for (int level = 0; level < kLevels; ++level) {
      benchmark::DoNotOptimize(detector.Detect(Levels().Level(level), options, 100, PathOf(state)).data());
    }
  }
}
BENCHMARK(BM_Detector)->ArgNames({"wide", "adaptive"})->ArgsProduct({{0, 1}, {0, 1}});

void BM_Quadtree(benchmark::State& state) {
  CornerDetector detector;
  const std::vector<Corner> corners = detector.Detect(Levels().Level(0), {}, 217, BestInstructions());
  const CornerArea area = InnerArea(Levels().Level(0));
  Quadtree quadtree;
  for (auto _ : state) {
    if (state.range(0) == 1) {
      benchmark::DoNotOptimize(quadtree.KeepSinglesAndBest(corners, area, 217).data());
    } else {
      benchmark::DoNotOptimize(quadtree.KeepBestOfEach(corners, area, 217).data());
    }
  }
}
BENCHMARK(BM_Quadtree)->ArgName("improved")->Arg(0)->Arg(1);

void BM_Blur(benchmark::State& state) {
  Blur blur;
  for (auto _ : state) {
    for (int level = 0; level < kLevels; ++level) {
      benchmark::DoNotOptimize(blur.Apply(Levels().Level(level), PathOf(state)).pixels);
    }
  }
}
BENCHMARK(BM_Blur)->ArgName("wide")->Arg(0)->Arg(1);

void BM_Orientation(benchmark::State& state) {
  int x = 100;
  for (auto _ : state)
    benchmark::DoNotOptimize(OrientationOf(Levels().Level(0), x = 100 + (x * 7 + 1) % 300, 200, PathOf(state)));
}
BENCHMARK(BM_Orientation)->ArgName("wide")->Arg(0)->Arg(1);

void BM_Descriptor(benchmark::State& state) {
  float angle = 0;
  for (auto _ : state) {
    angle = std::fmod(angle + 0.7f, 6.28f);
    benchmark::DoNotOptimize(DescribeAt(Levels().Level(0), 300, 200, angle, PathOf(state)));
  }
}
BENCHMARK(BM_Descriptor)->ArgName("wide")->Arg(0)->Arg(1);

void BM_LineSegments(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(FindLineSegments(Picture()));
}
BENCHMARK(BM_LineSegments)->Unit(benchmark::kMillisecond);

void BM_Hamming(benchmark::State& state) {
  Random random(1);
  std::vector<Descriptor> rows(1000);
  for (Descriptor& row : rows) row = {random.Next(), random.Next(), random.Next(), random.Next()};
  std::vector<uint16_t> distances(rows.size());
  const hamming::Path paths[] = {hamming::Portable, hamming::Avx2(), hamming::Avx512()};
  const hamming::Path path = paths[state.range(0)];
  if (path == nullptr) return state.SkipWithError("not on this processor");
  for (auto _ : state) {
    path(rows[7], rows.data(), rows.size(), distances.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(rows.size()));
}
BENCHMARK(BM_Hamming)->ArgName("popcnt_avx2_avx512")->DenseRange(0, 2);

void BM_Extract(benchmark::State& state) {
  FeatureOptions options;
  options.over_extraction = 1;
  options.detector = state.range(0) == 1 ? "adaptive" : "fixed";
  options.distribution = state.range(1) == 1 ? "improved" : "quadtree";
  OrbExtractor extractor(options);
  for (auto _ : state) benchmark::DoNotOptimize(extractor.Extract(Picture()).keypoints.data());
}
BENCHMARK(BM_Extract)->ArgNames({"adaptive", "improved"})->ArgsProduct({{0, 1}, {0, 1}})->Unit(benchmark::kMillisecond);

void BM_CvOrb(benchmark::State& state) {
  cv::setNumThreads(1);
  const cv::Ptr<cv::ORB> orb = cv::ORB::create(kWanted);
  for (auto _ : state) {
    std::vector<cv::KeyPoint> keypoints;
    cv::Mat descriptors;
    orb->detectAndCompute(Picture(), cv::noArray(), keypoints, descriptors);
    benchmark::DoNotOptimize(descriptors.data);
  }
}
BENCHMARK(BM_CvOrb)->Unit(benchmark::kMillisecond);

/// What ORB-SLAM2's extractor does, stage by stage: cells, full quadtree, a blur for each level.
void BM_OriginalWay(benchmark::State& state) {
  cv::setNumThreads(1);
  OriginalExtractor extractor({});
  for (auto _ : state) benchmark::DoNotOptimize(extractor.Extract(Picture()).keypoints.data());
}
BENCHMARK(BM_OriginalWay)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace yorb
