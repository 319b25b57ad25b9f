// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/people_check.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "detection/engine.h"

namespace yorb {
namespace {

constexpr double kMostDifference = 1e-3;  // of logits: rounding in another order

/// All outputs of a network for a picture.
Result<std::vector<torch::Tensor>> OutputsOf(const OnnxModel& model, const cv::Mat& picture, const std::string& name) {
  EngineInput input;
  input.path = name;
  input.width = picture.cols;
  input.height = picture.rows;
  const auto engine = MakeOpenCvEngine(model, input);
  if (!engine) return engine.error();
  cv::Mat rgb;
  cv::cvtColor(picture, rgb, cv::COLOR_BGR2RGB);
  const auto views = (*engine)->Run(rgb);
  if (!views) return views.error();
  std::vector<torch::Tensor> outputs;
  for (const TensorView& view : *views)
    outputs.push_back(torch::from_blob(const_cast<float*>(view.data), view.dims, view.strides).clone());
  return outputs;
}

}  // namespace

Result<double> CheckPeopleOutput(const PeopleFiles& files, const FeatureTaps& taps, PeopleHead head,
                                 const cv::Mat& picture) {
  const torch::NoGradGuard no_grad;
  const auto before = OutputsOf(files.before, picture, "the network");
  if (!before) return before.error();
  const auto after = OutputsOf(files.after, picture, "the network with a map of people");
  if (!after) return after.error();
  const auto maps = OutputsOf(WithTapsForOutputs(files.before, taps), picture, "the network up to its heads");
  if (!maps) return maps.error();
  if (after->size() != before->size() + 1) return Failure("the written file has not one output more than the network");
  for (size_t i = 0; i < before->size(); ++i) {
    if (!(*before)[i].equal((*after)[i]))
      return Failure("the output " + files.before.outputs[i].name + " is not what it was without the map of people");
  }
  const torch::Tensor wanted = head((*maps)[0], (*maps)[1]);
  if (after->back().sizes() != wanted.sizes())
    return Failure("the map of people in the written file has another shape");
  const double difference = (after->back() - wanted).abs().max().item<double>();
  if (!(difference <= kMostDifference))
    return Failure("the map of people in the written file differs by " + std::to_string(difference) +
                   " from what was trained");
  return difference;
}

}  // namespace yorb
