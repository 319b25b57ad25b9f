// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/make_engine.h"

namespace yorb {

Result<std::unique_ptr<Engine>> MakeEngine(const OnnxModel& model, const EngineInput& input,
                                           const DetectionOptions& options) {
  (void)options;
  return MakeOpenCvEngine(model, input);
}

}  // namespace yorb
