// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "detection/detector.h"
#include "detection/engine.h"

namespace yorb {

/// The engine that the options name; for `auto` the fastest that knows all operators of the network.
Result<std::unique_ptr<Engine>> MakeEngine(const OnnxModel& model, const EngineInput& input,
                                           const DetectionOptions& options);

}  // namespace yorb
