// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/engine.h"

#if defined(YORB_HAS_ONNXRUNTIME)
#include <onnxruntime_cxx_api.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace yorb {
namespace {

class OnnxRuntimeEngine : public Engine {
 public:
  OnnxRuntimeEngine(const OnnxModel& model, EngineInput input, int threads)
      : environment_(ORT_LOGGING_LEVEL_ERROR, "yorb"), input_(std::move(input)), bytes_(OnnxBytes(model)) {
    Ort::SessionOptions options;
    options.SetIntraOpNumThreads(threads);
    options.AddConfigEntry("session.intra_op.allow_spinning", "0");  // a spinning pool starves the rest of the system
    session_ = Ort::Session(environment_, bytes_.data(), bytes_.size(), options);
    input_name_ = model.inputs.front().name;
    for (const OnnxValue& output : model.outputs) output_names_.push_back(output.name);
  }

  std::string name() const override { return "ONNX Runtime"; }

  Result<std::vector<TensorView>> Run(const cv::Mat& picture) override {
    try {
      return RunOrThrow(picture);
    } catch (const Ort::Exception& error) {
      return BadInput(input_.path + " cannot be run by ONNX Runtime: " + error.what());
    }
  }

 private:
  std::vector<TensorView> RunOrThrow(const cv::Mat& picture) {
    std::vector<int64_t> dims{input_.batch, input_.channels, input_.height, input_.width};
    if (input_.is_channels_last) std::rotate(dims.begin() + 1, dims.begin() + 2, dims.end());
    const size_t plane = static_cast<size_t>(input_.width) * static_cast<size_t>(input_.height);
    numbers_.assign(plane * static_cast<size_t>(input_.batch * input_.channels), 0.f);
    std::vector<cv::Mat> planes;  // of several pictures that a file wants the first counts
    for (int channel = 0; channel < input_.channels; ++channel)
      planes.emplace_back(picture.size(), CV_32FC1, numbers_.data() + static_cast<size_t>(channel) * plane);
    cv::Mat floats;
    picture.convertTo(floats, CV_32F, input_.scale());
    if (input_.is_channels_last) {
      floats.copyTo(cv::Mat(picture.size(), CV_32FC(input_.channels), numbers_.data()));
    } else {
      cv::split(floats, planes);
    }
    const auto memory = Ort::MemoryInfo::CreateCpu(OrtDeviceAllocator, OrtMemTypeDefault);
    const Ort::Value value =
        Ort::Value::CreateTensor<float>(memory, numbers_.data(), numbers_.size(), dims.data(), dims.size());
    const char* input_name = input_name_.c_str();
    std::vector<const char*> names;
    for (const std::string& name : output_names_) names.push_back(name.c_str());
    results_ = session_.Run(Ort::RunOptions(), &input_name, &value, 1, names.data(), names.size());
    std::vector<TensorView> views;
    for (const Ort::Value& result : results_) {
      const std::vector<int64_t> shape = result.GetTensorTypeAndShapeInfo().GetShape();
      views.push_back({result.GetTensorData<float>(), shape, DenseStrides(shape)});
    }
    return views;
  }

  Ort::Env environment_;
  EngineInput input_;
  std::string bytes_;
  Ort::Session session_{nullptr};
  std::string input_name_;
  std::vector<std::string> output_names_;
  std::vector<float> numbers_;
  std::vector<Ort::Value> results_;
};

}  // namespace

Result<std::unique_ptr<Engine>> MakeOnnxRuntimeEngine(const OnnxModel& model, const EngineInput& input, int threads) {
  try {
    return std::unique_ptr<Engine>(std::make_unique<OnnxRuntimeEngine>(model, input, threads));
  } catch (const Ort::Exception& error) {
    return BadInput(std::string("graph: ") + error.what());
  }
}

}  // namespace yorb

#else

namespace yorb {

Result<std::unique_ptr<Engine>> MakeOnnxRuntimeEngine(const OnnxModel&, const EngineInput&, int) {
  return BadInput("graph: this build is without ONNX Runtime");
}

}  // namespace yorb

#endif
