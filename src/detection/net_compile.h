// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/result.h"
#include "detection/engine.h"
#include "detection/net_head.h"
#include "detection/net_program.h"
#include "detection/onnx_model.h"

namespace yorb {

/// A network ready to run at one size.
struct CompiledNet {
  NetProgram program;
  NetValue input;                               ///< channels last: filled before each run
  std::vector<NetValue> outputs;                ///< read behind it
  std::vector<std::shared_ptr<NetHead>> heads;  ///< of each output; null where it is not of that kind
  std::vector<std::vector<int64_t>> shapes;     ///< of each node's first output
};

/// Compiles a network. The error names the first operator that is not known, for instance "operator Gelu".
Result<CompiledNet> CompileNet(const OnnxModel& model, const EngineInput& input, pthreadpool* threads);

}  // namespace yorb
