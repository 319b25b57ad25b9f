// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <opencv2/dnn.hpp>
#include <utility>

#include "detection/engine.h"
#include "detection/opencv_misreading.h"

namespace yorb {
namespace {

/// The operator that OpenCV's complaint is about: "> Node [Add@ai.onnx]: ..."; empty where it names none.
std::string OperatorIn(const std::string& complaint) {
  const size_t start = complaint.find("Node ["), end = complaint.find('@', start);
  return start == std::string::npos || end == std::string::npos ? "" : complaint.substr(start + 6, end - start - 6);
}

/// What may be done about a network that OpenCV does not read. 4.6 stumbles over most heads that decode their boxes
/// within the graph.
Error Unreadable(const std::string& path, const std::string& because, const std::string& complaint) {
  const std::string name = OperatorIn(complaint);
  return BadInput(
      path + " cannot be run by " + (because.empty() ? "" : "XNNPACK, for its " + because + ", nor by ") +
      "OpenCV DNN " CV_VERSION + (name.empty() ? "" : ", for its operator " + name) +
      "; export it with fixed sizes and its three raw head maps as outputs, or build yorb with ONNX Runtime");
}

Status Misread(const std::string& path, const std::string& misreading) {
  if (misreading.empty()) return Status::Ok();
  return BadInput(path +
                  " cannot be run by OpenCV DNN " CV_VERSION
                  ", which would give other numbers than the file means for its operator " +
                  misreading + "; export it without that, or build yorb with ONNX Runtime");
}

/// OpenCV names its layers after nodes, or after what these give.
ShapeOfValue ShapesIn(const cv::dnn::Net& net, const OnnxModel& model, const EngineInput& input) {
  struct Place {
    std::string layer;
    size_t output;
  };
  std::map<std::string, Place> places;
  for (const OnnxNode& node : model.nodes) {
    for (size_t i = 0; i < node.outputs.size(); ++i)
      places[node.outputs[i]] = {node.name.empty() ? "onnx_node_output_0!" + node.outputs[0] : "onnx_node!" + node.name,
                                 i};
  }
  const cv::dnn::MatShape picture{input.batch, input.channels, input.height, input.width};
  return [net, picture, places, input_name = model.inputs.front().name](const std::string& value) mutable {
    if (value == input_name) return std::vector<int64_t>(picture.begin(), picture.end());
    const auto place = places.find(value);
    const int layer = place == places.end() ? -1 : net.getLayerId(place->second.layer);
    if (layer < 0) return std::vector<int64_t>();
    std::vector<cv::dnn::MatShape> read, given;
    net.getLayerShapes(picture, layer, read, given);
    if (place->second.output >= given.size()) return std::vector<int64_t>();
    const cv::dnn::MatShape& shape = given[place->second.output];
    return std::vector<int64_t>(shape.begin(), shape.end());
  };
}

class OpenCvEngine : public Engine {
 public:
  OpenCvEngine(const cv::dnn::Net& net, std::vector<std::string> outputs, EngineInput input, std::string because)
      : net_(net), outputs_(std::move(outputs)), input_(std::move(input)), because_(std::move(because)) {}

  std::string name() const override { return "OpenCV DNN"; }

  Result<std::vector<TensorView>> Run(const cv::Mat& picture) override {
    try {
      Forward(picture);
    } catch (const cv::Exception& error) {
      return Unreadable(input_.path, because_, error.err);
    }
    std::vector<TensorView> views;
    for (const cv::Mat& result : results_) {
      if (result.depth() != CV_32F) return Unreadable(input_.path, because_, "an output holds no floats");
      TensorView view{result.ptr<float>(), {}, {}};
      for (int i = 0; i < result.dims; ++i) view.dims.push_back(result.size[i]);
      view.strides = DenseStrides(view.dims);
      views.push_back(std::move(view));
    }
    return views;
  }

 private:
  void Forward(const cv::Mat& picture) {
    cv::Mat blob;
    if (input_.batch == 1) {
      cv::dnn::blobFromImage(picture, blob, input_.scale());
    } else {  // the file wants several pictures: the first counts
      cv::dnn::blobFromImages(std::vector<cv::Mat>(static_cast<size_t>(input_.batch), picture), blob, input_.scale());
    }
    net_.setInput(blob);
    results_.clear();
    net_.forward(results_, outputs_);
  }

  cv::dnn::Net net_;
  std::vector<std::string> outputs_;
  EngineInput input_;
  std::string because_;
  std::vector<cv::Mat> results_;
};

}  // namespace

std::vector<int64_t> DenseStrides(const std::vector<int64_t>& dims) {
  std::vector<int64_t> strides(dims.size(), 1);
  for (size_t i = dims.size(); i > 1; --i) strides[i - 2] = strides[i - 1] * dims[i - 1];
  return strides;
}

Result<std::unique_ptr<Engine>> MakeOpenCvEngine(const OnnxModel& model, const EngineInput& input,
                                                 const std::string& because) {
  if (input.is_channels_last) {
    return BadInput(input.path + " cannot be run by " +
                    (because.empty() ? "" : "XNNPACK, for its " + because + ", nor by ") +
                    "OpenCV DNN, for the channels of its input stand last; export it with (1, 3, height, width)");
  }
  if (const Status fine = Misread(input.path, MisreadingInFile(model)); !fine) return fine.error();
  const std::string bytes = OnnxBytes(model);
  try {
    cv::dnn::Net net = cv::dnn::readNetFromONNX(bytes.data(), bytes.size());
    net.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
    if (const Status fine = Misread(input.path, MisreadingOfShapes(model, ShapesIn(net, model, input))); !fine)
      return fine.error();
    std::vector<std::string> outputs;
    for (const OnnxValue& output : model.outputs) outputs.push_back(output.name);
    return std::unique_ptr<Engine>(std::make_unique<OpenCvEngine>(net, std::move(outputs), input, because));
  } catch (const cv::Exception& error) {
    return Unreadable(input.path, because, error.err);
  }
}

}  // namespace yorb
