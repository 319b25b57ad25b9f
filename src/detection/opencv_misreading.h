// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "detection/onnx_model.h"

namespace yorb {

/// The shape of what is computed under a name; empty where it is not in the network that OpenCV made.
using ShapeOfValue = std::function<std::vector<int64_t>(const std::string&)>;

/// OpenCV 4.6 computes some operators in another way than ONNX says, without a word, and dies of one. Which and why, in
/// words such as "Softmax: ..."; empty where nothing is known to be wrong. As far as the file alone tells: this must be
/// asked before OpenCV reads the network.
std::string MisreadingInFile(const OnnxModel& model);

/// The same of what depends on shapes.
std::string MisreadingOfShapes(const OnnxModel& model, const ShapeOfValue& shape_of);

}  // namespace yorb
