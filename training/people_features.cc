// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/people_features.h"

#include <algorithm>
#include <cstring>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "training/people_cells.h"

namespace yorb {
namespace {

constexpr int64_t kScenesARound = 16;  // of each thread, before anybody is told how far it is

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

void Put(const FeatureSet& one, int64_t at, const FeatureSet& all) {
  all.fine[at].copy_(one.fine[0]);
  all.coarse[at].copy_(one.coarse[0]);
  all.labels[at].copy_(one.labels[0]);
}

Result<FeatureSet> MakeOne(const SceneSource& source, int64_t i, FeatureMaker& maker) {
  const Result<Scene> scene = source.make(i);
  return scene ? maker.Run(*scene) : Result<FeatureSet>(scene.error());
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
  const Result<FeatureSet> first = MakeOne(source, 0, makers.front());
  if (!first) return first.error();
  FeatureSet all = MakeRoom(*first, source.count);
  const size_t num_threads = makers.size();
  const auto round = static_cast<int64_t>(num_threads) * kScenesARound;
  for (int64_t begin = 0; begin < source.count; begin += round) {
    const int64_t end = std::min(begin + round, source.count);
    std::vector<Status> done(num_threads);
    ParallelFor(num_threads, static_cast<int>(num_threads), [&](size_t turn) {
      for (auto i = begin + static_cast<int64_t>(turn); i < end && done[turn]; i += static_cast<int64_t>(num_threads)) {
        const Result<FeatureSet> one = MakeOne(source, i, makers[turn]);
        if (one) Put(*one, i, all);
        if (!one) done[turn] = one.error();
      }
    });
    for (const Status& status : done) {
      if (!status) return status.error();
    }
    if (!progress(end)) return Stopped();
  }
  return all;
}

}  // namespace yorb
