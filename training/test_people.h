// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// For tests only: a small detector with weights by chance.
#pragma once

#include <string>

#include "detection/onnx_model.h"
#include "training/export_onnx.h"

namespace yorb {

inline const cv::Size kTinyInput{96, 64};

inline OnnxModel MakeTinyDetector() {
  torch::manual_seed(1);
  const ClassTable table{{"person", "chair"}, {"high", "low"}};
  Network network(MakeLayout("yolo-mo-n", table.size()));
  network->eval();
  const auto model = ReadOnnxBytes(ExportOnnx(network, table, kTinyInput), "tiny.onnx");
  YORB_CHECK(model.ok(), "what is exported can be read");
  return *model;
}

}  // namespace yorb
