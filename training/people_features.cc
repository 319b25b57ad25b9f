// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/people_features.h"

#include <cstring>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "core/prefetch.h"
#include "training/people_cells.h"

namespace yorb {
namespace {

constexpr size_t kScenesAhead = 4;

torch::Tensor HalfOf(const TensorView& view) {
  return torch::from_blob(const_cast<float*>(view.data), view.dims, view.strides, torch::kFloat32).to(torch::kFloat16);
}

torch::Tensor TensorOf(const cv::Mat& labels) {
  const torch::Tensor tensor = torch::empty({1, labels.rows, labels.cols});
  std::memcpy(tensor.data_ptr<float>(), labels.data, labels.total() * sizeof(float));
  return tensor;
}

/// Room for so many of what `one` is of.
FeatureSet MakeRoom(const FeatureSet& one, int64_t count) {
  const auto room = [&](const torch::Tensor& like) {
    std::vector<int64_t> shape = like.sizes().vec();
    shape[0] = count;
    return torch::empty(shape, like.options());
  };
  return {room(one.fine), room(one.coarse), room(one.labels)};
}

void Put(const FeatureSet& one, int64_t at, FeatureSet& all) {
  all.fine[at].copy_(one.fine[0]);
  all.coarse[at].copy_(one.coarse[0]);
  all.labels[at].copy_(one.labels[0]);
}

}  // namespace

Error Stopped() { return Failure("stopped before the end; nothing was written"); }

Result<FeatureMaker> FeatureMaker::Make(const OnnxModel& model, const FeatureTaps& taps, const std::string& path) {
  EngineInput input;
  input.path = path;
  input.width = taps.input.width;
  input.height = taps.input.height;
  Result<std::unique_ptr<Engine>> engine = MakeOpenCvEngine(WithTapsForOutputs(model, taps), input);
  if (!engine) return engine.error();
  return FeatureMaker(std::move(*engine));
}

Result<FeatureSet> FeatureMaker::Run(const Scene& scene) {
  cv::Mat rgb;
  cv::cvtColor(scene.pixels, rgb, cv::COLOR_BGR2RGB);
  const Result<std::vector<TensorView>> maps = engine_->Run(rgb);
  if (!maps) return maps.error();
  return FeatureSet{HalfOf((*maps)[0]), HalfOf((*maps)[1]), TensorOf(LabelCells(scene.people_mask))};
}

Result<FeatureSet> MakeFeatures(const SceneSource& source, std::vector<FeatureMaker> makers,
                                const std::function<bool(int64_t)>& progress) {
  const auto num_threads = static_cast<int64_t>(makers.size());
  std::vector<std::unique_ptr<Prefetch<Result<FeatureSet>>>> streams;
  for (int64_t first = 0; first < num_threads; ++first) {
    const auto maker = std::make_shared<FeatureMaker>(std::move(makers[static_cast<size_t>(first)]));
    const auto make = [=, &source, i = first]() mutable -> std::optional<Result<FeatureSet>> {
      if (i >= source.count) return std::nullopt;
      const Result<Scene> scene = source.make(i);
      i += num_threads;
      return scene ? maker->Run(*scene) : Result<FeatureSet>(scene.error());
    };
    streams.push_back(std::make_unique<Prefetch<Result<FeatureSet>>>(make, kScenesAhead));
  }
  FeatureSet all;
  for (int64_t i = 0; i < source.count; ++i) {
    const std::optional<Result<FeatureSet>> next = streams[static_cast<size_t>(i % num_threads)]->Next();
    const Result<FeatureSet>& one = next.value();
    if (!one) return one.error();
    if (i == 0) all = MakeRoom(*one, source.count);
    Put(*one, i, all);
    if (!progress(i + 1)) return Stopped();
  }
  return all;
}

}  // namespace yorb
