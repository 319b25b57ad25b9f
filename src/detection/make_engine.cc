// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/make_engine.h"

#include "core/log.h"

namespace yorb {

namespace {

using Made = Result<std::unique_ptr<Engine>>;

Error CannotRun(const std::string& path, const char* engine, const Error& reason) {
  return BadInput(path + " cannot be run by " + engine + ": " + reason.message);
}

}  // namespace

Result<std::unique_ptr<Engine>> MakeEngine(const OnnxModel& model, const EngineInput& input,
                                           const DetectionOptions& options) {
  if (options.engine == "opencv") return MakeOpenCvEngine(model, input);
  const bool may_choose = options.engine == "auto";
  if (may_choose || options.engine == "onnxruntime") {
    Made made = MakeOnnxRuntimeEngine(model, input, options.threads);
    if (made) return made;
    if (!may_choose) return CannotRun(input.path, "ONNX Runtime", made.error());
  }
  Made made = MakeXnnpackEngine(model, input, options.threads);
  if (made) return made;
  if (!may_choose) return CannotRun(input.path, "XNNPACK", made.error());
  LogInfo(input.path + ": XNNPACK does not know its " + made.error().message + "; OpenCV runs it");
  return MakeOpenCvEngine(model, input);
}

}  // namespace yorb
