// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/engine.h"

#if defined(YORB_HAS_XNNPACK)
#include <pthreadpool.h>

#include <utility>

#include "detection/net_compile.h"

namespace yorb {
namespace {

using Threads = std::shared_ptr<pthreadpool>;

Threads MakeThreads(int count) {
  if (count <= 1) return nullptr;
  return {pthreadpool_create(static_cast<size_t>(count)), [](pthreadpool_t gone) { pthreadpool_destroy(gone); }};
}

class XnnpackEngine : public Engine {
 public:
  XnnpackEngine(CompiledNet net, Threads threads, const EngineInput& input)
      : threads_(std::move(threads)), net_(std::move(net)), input_(input) {}

  std::string name() const override { return "XNNPACK"; }

  Result<std::vector<TensorView>> Run(const cv::Mat& picture) override {
    // Pixels are next to their channels in both. Of several pictures that a file wants the first counts.
    for (int image = 0; image < input_.batch; ++image) {
      float* to = net_.input.data.get() + image * net_.input.strides[0];
      cv::Mat floats(picture.size(), CV_32FC(picture.channels()), to);
      picture.convertTo(floats, CV_32F, input_.scale());
    }
    net_.program.Run();
    std::vector<TensorView> views;
    for (const NetValue& output : net_.outputs) views.push_back({output.data.get(), output.dims, output.strides});
    return views;
  }

  void ReadOnly(const SparseOutput& read) override {
    if (const auto& head = net_.heads[read.output]) head->ComputeWhere(read.channels, read.least);
  }

 private:
  Threads threads_;  // longer-lived than the steps that use them
  CompiledNet net_;
  EngineInput input_;
};

}  // namespace

Result<std::unique_ptr<Engine>> MakeXnnpackEngine(const OnnxModel& model, const EngineInput& input, int threads) {
  Threads pool = MakeThreads(threads);
  auto net = CompileNet(model, input, pool.get());
  if (!net) return net.error();
  return std::unique_ptr<Engine>(std::make_unique<XnnpackEngine>(*std::move(net), std::move(pool), input));
}

}  // namespace yorb

#else

namespace yorb {

Result<std::unique_ptr<Engine>> MakeXnnpackEngine(const OnnxModel&, const EngineInput&, int) {
  return BadInput("graph: this build is without XNNPACK");
}

}  // namespace yorb

#endif
