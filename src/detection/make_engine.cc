// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/make_engine.h"

#include "core/log.h"

namespace yorb {

Result<std::unique_ptr<Engine>> MakeEngine(const OnnxModel& model, const EngineInput& input,
                                           const DetectionOptions& options) {
  if (options.engine == "opencv") return MakeOpenCvEngine(model, input);
  auto fast = MakeXnnpackEngine(model, input, options.threads);
  if (fast) return fast;
  if (options.engine == "xnnpack") return BadInput(input.path + " cannot be run by XNNPACK: " + fast.error().message);
  LogInfo(input.path + ": XNNPACK does not know its " + fast.error().message + "; OpenCV runs it");
  return MakeOpenCvEngine(model, input);
}

}  // namespace yorb
