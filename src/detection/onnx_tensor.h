// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "detection/onnx_model.h"

namespace yorb {

/// Reads a TensorProto. `folder` is where weights in other files lie. The error has no file name before it.
Result<OnnxTensor> ParseOnnxTensor(std::string_view message, const std::string& folder);

}  // namespace yorb
