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

/// Whether OpenCV would give wrong numbers without a word.
bool IsMisreadByOpenCv(const Made& made) {
  return !made && made.error().message.find(kNorByOpenCv) != std::string::npos;
}

}  // namespace

Result<std::unique_ptr<Engine>> MakeEngine(const OnnxModel& model, const EngineInput& input,
                                           const DetectionOptions& options) {
  const bool may_choose = options.engine == "auto", is_for_opencv = options.engine == "opencv";
  if (may_choose || options.engine == "onnxruntime") {
    Made made = MakeOnnxRuntimeEngine(model, input, options.threads);
    if (made) return made;
    if (!may_choose) return CannotRun(input.path, "ONNX Runtime", made.error());
  }
  Made made = MakeXnnpackEngine(model, input, options.threads);
  if (made && !is_for_opencv) return made;
  if (IsMisreadByOpenCv(made)) return BadInput(input.path + " cannot be run: " + made.error().message);
  if (is_for_opencv) return MakeOpenCvEngine(model, input);
  if (!may_choose) return CannotRun(input.path, "XNNPACK", made.error());
  LogInfo(input.path + ": XNNPACK does not know its " + made.error().message + "; OpenCV runs it");
  return MakeOpenCvEngine(model, input, made.error().message);
}

}  // namespace yorb
