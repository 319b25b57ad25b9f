// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <torch/torch.h>

#include <functional>
#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"
#include "detection/engine.h"
#include "detection/onnx_model.h"
#include "training/people_onnx.h"
#include "training/scene.h"

namespace yorb {

/// What a head for people learns from: maps of the frozen network, half floats, and the cells' labels.
struct FeatureSet {
  torch::Tensor fine;    ///< (N, fine channels, H / 8, W / 8)
  torch::Tensor coarse;  ///< (N, coarse channels, H / 16, W / 16)
  torch::Tensor labels;  ///< (N, H / 8, W / 8), floats; see `LabelCells`

  int64_t size() const { return labels.size(0); }
};

/// Runs a frozen network up to the maps that the head reads. Not for several threads at once.
class FeatureMaker {
 public:
  static Result<FeatureMaker> Make(const OnnxModel& model, const FeatureTaps& taps, const std::string& path);

  /// A set of one, for a scene of the input's size with a mask of people.
  Result<FeatureSet> Run(const Scene& scene);

 private:
  explicit FeatureMaker(std::unique_ptr<Engine> engine) : engine_(std::move(engine)) {}

  std::unique_ptr<Engine> engine_;
};

/// How many scenes (at least one), and who makes them: any thread may ask for scene `i`, and gets the same whoever
/// asks.
struct SceneSource {
  int64_t count = 0;
  std::function<Result<Scene>(int64_t)> make;
};

/// The maps of all scenes, on as many threads as there are makers (at least one). `progress` hears now and then how
/// many are done, and says whether to go on; failure where it says no.
Result<FeatureSet> MakeFeatures(const SceneSource& source, std::vector<FeatureMaker> makers,
                                const std::function<bool(int64_t)>& progress);

/// The failure of somebody's having asked for the end.
Error Stopped();

}  // namespace yorb
