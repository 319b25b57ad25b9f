// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/shaped_engine.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "detection/make_engine.h"

namespace yorb {

Result<std::vector<TensorView>> RunOn(Engine& engine, const cv::Mat& picture) {
  auto outputs = engine.Run(picture);
  if (!outputs) return outputs;
  for (TensorView& view : *outputs) {
    if (view.dims.size() != 2 || view.dims[0] == 1) continue;
    view.dims.insert(view.dims.begin(), 1);
    view.strides.insert(view.strides.begin(), 0);
  }
  return outputs;
}

HeadFacts FactsOf(const std::vector<TensorView>& outputs, const Network& network) {
  HeadFacts facts;
  for (const TensorView& output : outputs) facts.shapes.push_back(output.dims);
  const auto is_joined = [&](const OnnxValue& output) { return LastOperator(network.model, output.name) == "Concat"; };
  const std::vector<OnnxValue>& named = network.model.outputs;
  facts.are_joined = std::all_of(named.begin(), named.end(), is_joined);
  facts.width = network.input.width, facts.height = network.input.height;
  facts.num_names = static_cast<int>(network.names.size());
  facts.names_file = network.names_file;
  facts.task = network.task;
  facts.num_keypoint_values = network.num_keypoint_values;
  return facts;
}

Result<ShapedEngine> MakeShapedEngine(const Network& network, const DetectionOptions& options) {
  auto engine = MakeEngine(network.model, network.input, options);
  if (!engine) return engine.error();
  // A picture of nothing: only a run shows all shapes, and engines set themselves up in the first one.
  const cv::Mat blank(network.input.height, network.input.width, network.input.channels == 1 ? CV_8UC1 : CV_8UC3,
                      cv::Scalar::all(114));
  auto outputs = RunOn(**engine, blank);
  if (!outputs) return outputs.error();
  const auto layout = RecogniseLayout(FactsOf(*outputs, network));
  if (!layout) return BadInput(network.input.path + " " + layout.error().message);
  return ShapedEngine{network.input, *std::move(engine), *layout, *std::move(outputs)};
}

cv::Size InputSizeFor(const cv::Size& picture, int long_side_px) {
  const auto whole_cells = [](double side) {
    return kCellSize * std::max(1, static_cast<int>(std::ceil(side / kCellSize - 1e-6)));
  };
  const double scale = static_cast<double>(long_side_px) / std::max(picture.width, picture.height);
  return {whole_cells(picture.width * scale), whole_cells(picture.height * scale)};
}

}  // namespace yorb
