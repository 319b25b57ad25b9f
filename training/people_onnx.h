// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>

#include "core/result.h"
#include "detection/onnx_model.h"
#include "training/people_head.h"

namespace yorb {

/// The maps of a detector that the heads of strides 8 and 16 read.
struct FeatureTaps {
  std::string fine, coarse;  ///< values of the graph
  int64_t fine_channels = 0, coarse_channels = 0;
  cv::Size input;  ///< of the network, px
};

/// The network as it was before WithPeopleHead; as it is where it has no map of people.
OnnxModel WithoutPeopleHead(OnnxModel model);

/// Looks for what the convolutions read that give "stride8" and "stride16", as `ExportOnnx` names them. Bad input, with
/// the words `path` before it, where the network has none, or has a map of people already.
Result<FeatureTaps> FindFeatureTaps(const OnnxModel& model, const std::string& path);

/// The network with the two maps, fine and coarse, as its only outputs.
OnnxModel WithTapsForOutputs(OnnxModel model, const FeatureTaps& taps);

/// The network with the head on top: one more output, "people" (1, 1, H / 8, W / 8) of logits, and the metadata
/// `people`, the stride of its cells. Bad input where the network enlarges nothing, as the head must.
Result<OnnxModel> WithPeopleHead(OnnxModel model, const FeatureTaps& taps, const PeopleHead& head,
                                 const std::string& path);

}  // namespace yorb
