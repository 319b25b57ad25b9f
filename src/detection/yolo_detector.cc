// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/yolo_detector.h"

#include <filesystem>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/installed.h"
#include "core/log.h"
#include "detection/class_names.h"
#include "detection/head_layout.h"
#include "detection/letterbox.h"
#include "detection/make_engine.h"

namespace yorb {
namespace {

constexpr size_t kMostBoxes = 300;  // a picture

HeadFacts FactsOf(const std::vector<TensorView>& outputs, const Network& network) {
  HeadFacts facts;
  for (const TensorView& output : outputs) facts.shapes.push_back(output.dims);
  facts.width = network.input.width, facts.height = network.input.height;
  facts.num_names = static_cast<int>(network.names.size());
  facts.num_keypoint_values = network.num_keypoint_values;
  return facts;
}

/// The names of the classes where the file has none: COCO's for 80, else numbers, with a warning.
void NameClasses(int num_classes, Network& network) {
  if (!network.names.empty()) return;
  if (num_classes == static_cast<int>(CocoNames().size())) {
    network.names = CocoNames();
    network.names_source = "COCO";
    return;
  }
  for (int i = 0; i < num_classes; ++i) network.names.push_back("class" + std::to_string(i));
  network.names_source = "their numbers";
  LogWarning("class-names", network.input.path +
                                " carries no class names; its classes are called class0, class1 and so on: " +
                                "write their names, a line each, into " + network.input.path + ".names");
}

/// Whether the sigmoid of raw maps is still to come: as the graph says, else as the numbers look.
bool AreLogits(const Network& network, const HeadLayout& layout, const std::vector<TensorView>& outputs) {
  for (const RawMap& map : layout.maps) {
    if (!EndsInSigmoid(network.model, network.model.outputs[map.output].name)) return LookLikeLogits(outputs, layout);
  }
  return false;
}

/// What the network sees: scaled and framed, RGB or grey.
cv::Mat InputOf(const ImageSet& images, const Letterbox& fit, int channels) {
  const bool has_colour = channels == 3 && !images.colour.empty();
  const cv::Mat framed = Letterboxed(has_colour ? images.colour : images.grey, fit);
  if (channels == 1) return framed;
  cv::Mat rgb;
  cv::cvtColor(framed, rgb, has_colour ? cv::COLOR_BGR2RGB : cv::COLOR_GRAY2RGB);
  return rgb;
}

}  // namespace

ImageSet ImageSetOf(const cv::Mat& bgr) {
  ImageSet images;
  if (bgr.channels() == 1) {
    images.grey = bgr;
  } else {
    images.colour = bgr;
    cv::cvtColor(bgr, images.grey, cv::COLOR_BGR2GRAY);
  }
  return images;
}

Result<std::string> DefaultNetwork() {
  const auto folder = InstalledFolder("models");
  const std::string path = (std::filesystem::path(folder.value_or("models")) / "yolo_mo.onnx").string();
  std::error_code ignored;
  if (folder && std::filesystem::exists(path, ignored)) return path;
  return BadInput(path + ", the network that comes with yorb, is not there; name another one (--model FILE.onnx)");
}

Result<std::unique_ptr<YoloDetector>> YoloDetector::Open(const DetectionOptions& options) {
  if ((options.width > 0) != (options.height > 0))
    return BadInput(
        "detection.width and detection.height go together; 0 for both takes the size that the network's file says");
  const auto path = options.model.empty() ? DefaultNetwork() : Result<std::string>(options.model);
  if (!path) return path.error();
  auto network = OpenNetwork(*path, {options.width, options.height});
  if (!network) return network.error();
  auto engine = MakeEngine(network->model, network->input, options);
  if (!engine) return engine.error();

  // A picture of nothing: only a run shows all shapes, and engines set themselves up in the first one.
  const cv::Mat blank(network->input.height, network->input.width, network->input.channels == 1 ? CV_8UC1 : CV_8UC3,
                      cv::Scalar::all(114));
  const auto outputs = (*engine)->Run(blank);
  if (!outputs) return outputs.error();
  const HeadFacts facts = FactsOf(*outputs, *network);
  const auto layout = RecogniseLayout(facts);
  if (!layout) return BadInput(*path + " " + layout.error().message);
  NameClasses(layout->num_classes, *network);

  std::unique_ptr<YoloDetector> detector(new YoloDetector());
  detector->layout_ = *layout;
  detector->decode_.confidence = options.confidence;
  detector->decode_.is_logits = AreLogits(*network, *layout, *outputs);
  detector->decode_.anchors = network->anchors.empty() ? StandardAnchors() : network->anchors;
  if (detector->decode_.anchors.size() < 6 * layout->maps.size())
    return BadInput(*path + " has " + std::to_string(layout->maps.size()) +
                    " raw maps and too few anchors in its metadata");
  for (const RawMap& map : layout->maps) {
    if (map.anchor_axis != 0) continue;
    const int64_t num_channels = (*outputs)[map.output].dims[static_cast<size_t>(map.value_axis)];
    const ObjectnessRead read = ObjectnessOf(num_channels, detector->decode_);
    (*engine)->ReadOnly({map.output, read.channels, read.least});
  }
  detector->most_overlap_ = options.most_overlap;
  detector->input_ = network->input;
  detector->names_ = network->names;
  detector->engine_ = *std::move(engine);
  LogInfo(*path + ": " + LayoutText(*layout, facts) + (detector->decode_.is_logits ? " of logits" : "") + ", input " +
          std::to_string(facts.width) + "x" + std::to_string(facts.height) + ", " +
          std::to_string(detector->names_.size()) + " classes named by " + network->names_source + ", run by " +
          detector->engine_->name());
  return detector;
}

std::string YoloDetector::NameOf(int label) const {
  const auto index = static_cast<size_t>(label);
  return index < names_.size() ? names_[index] : "class" + std::to_string(label);
}

Result<Detections> YoloDetector::Detect(const ImageSet& images) {
  const Letterbox fit = FitLetterbox(images.grey.size(), input_size());
  const auto outputs = engine_->Run(InputOf(images, fit, input_.channels));
  if (!outputs) return outputs.error();
  const double most_overlap = layout_.kind == LayoutKind::kCornerRows ? 1.0 : most_overlap_;
  Detections detections;
  for (const RawBox& raw : SuppressDoubles(DecodeBoxes(*outputs, layout_, decode_), most_overlap, kMostBoxes)) {
    const Box whole{NameOf(raw.label),         raw.confidence,
                    fit.ToPictureX(raw.left),  fit.ToPictureY(raw.top),
                    fit.ToPictureX(raw.right), fit.ToPictureY(raw.bottom)};
    Box box = Cut(whole, fit.picture.width, fit.picture.height);
    if (HasArea(box)) detections.boxes.push_back(std::move(box));
  }
  return detections;
}

}  // namespace yorb
