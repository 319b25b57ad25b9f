// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/shaped_engine.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "detection/box_form.h"
#include "detection/make_engine.h"
#include "detection/people_map.h"

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
  std::vector<OnnxValue> named = network.model.outputs;
  if (network.has_people) facts.shapes.pop_back(), named.pop_back();
  facts.are_joined = std::all_of(named.begin(), named.end(), is_joined);
  facts.width = network.input.width, facts.height = network.input.height;
  facts.num_names = static_cast<int>(network.names.size());
  facts.names_file = network.names_file;
  facts.task = network.task;
  facts.num_keypoint_values = network.num_keypoint_values;
  return facts;
}

namespace {

/// With this input, which may differ from the network's own in how pixels are handed over.
Result<ShapedEngine> MakeWithInput(const EngineInput& input, const Network& network, const DetectionOptions& options) {
  auto engine = MakeEngine(network.model, input, options);
  if (!engine) return engine.error();
  // A picture of nothing: only a run shows all shapes, and engines set themselves up in the first one.
  const cv::Mat blank(input.height, input.width, input.channels == 1 ? CV_8UC1 : CV_8UC3, cv::Scalar::all(114));
  auto outputs = RunOn(**engine, blank);
  if (!outputs) return outputs.error();
  if (network.has_people && !IsPeopleMap(outputs->back()))
    return BadInput(input.path + " has an output `people` of " + ShapeText(outputs->back().dims) +
                    ", which is no map of people; (1, 1, height, width) is expected");
  const auto layout = RecogniseLayout(FactsOf(*outputs, network));
  if (!layout) return BadInput(input.path + " " + layout.error().message);
  return ShapedEngine{input, *std::move(engine), *layout, *std::move(outputs)};
}

bool HasBoxOfEachCell(LayoutKind kind) {
  return kind == LayoutKind::kAnchorRows || kind == LayoutKind::kCentreColumns || kind == LayoutKind::kCentreRows ||
         kind == LayoutKind::kCellRows || kind == LayoutKind::kBoxesApart;
}

/// The complaint about rows of cells that are not read after all, since shapes do not say what their numbers are.
Error UnclearBoxes(const ShapedEngine& shaped) {
  const std::string shape = ShapeText(shaped.blank_outputs[shaped.layout.output].dims);
  if (shaped.layout.kind == LayoutKind::kBoxesApart)
    return BadInput(shaped.input.path + " gives boxes " + shape +
                    " apart from their scores that are not seen to be corners, nor centre and size, in pixels; export "
                    "it with both in one output");
  return BadInput(shaped.input.path + " gives rows of all cells, " + shape +
                  ", that are neither YOLOX's as its export leaves them nor YOLOv6's; export YOLOX without "
                  "--decode_in_inference, others as YOLOv5's (1, N, 5+C) or YOLOv8's (1, 4+C, N)");
}

}  // namespace

Result<ShapedEngine> MakeShapedEngine(const Network& network, const DetectionOptions& options) {
  auto shaped = MakeWithInput(network.input, network, options);
  if (!shaped || !HasBoxOfEachCell(shaped->layout.kind)) return shaped;
  const LayoutKind kind = shaped->layout.kind;
  const bool is_of_cells = kind == LayoutKind::kCellRows;
  const HeadFacts facts = FactsOf(shaped->blank_outputs, network);
  const auto seen = BoxFormOf(shaped->blank_outputs, shaped->layout, facts);
  const bool is_yolox = seen && seen->form == BoxForm::kRelative;
  if (!seen && !is_of_cells && kind != LayoutKind::kBoxesApart) return shaped;  // centres, in all likelihood
  if (!seen || (is_of_cells && !is_yolox && !IsObjectnessOne(shaped->blank_outputs[shaped->layout.output])))
    return UnclearBoxes(*shaped);
  if (is_yolox) {  // it is trained on pictures as OpenCV reads them
    EngineInput input = network.input;
    input.are_bytes = input.is_bgr = true;
    shaped = MakeWithInput(input, network, options);
    if (!shaped) return shaped;
    shaped->layout.cells = CellsOfRows(facts.shapes[shaped->layout.output][1], facts);
  }
  shaped->layout.form = seen->form;
  if (seen->are_fractions)
    shaped->layout.unit_x = static_cast<float>(facts.width), shaped->layout.unit_y = static_cast<float>(facts.height);
  return shaped;
}

cv::Size InputSizeFor(const cv::Size& picture, int long_side_px) {
  const auto whole_cells = [](double side) {
    return kCellSize * std::max(1, static_cast<int>(std::ceil(side / kCellSize - 1e-6)));
  };
  const double scale = static_cast<double>(long_side_px) / std::max(picture.width, picture.height);
  return {whole_cells(picture.width * scale), whole_cells(picture.height * scale)};
}

}  // namespace yorb
