// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "training/class_table.h"
#include "training/network.h"

namespace yorb {

/// A trained detector from which another one learns. Its maps correspond to the learner's cell by cell: strides and
/// anchors are the same.
struct Teacher {
  Network network{nullptr};  ///< in evaluation mode, norms folded into the convolutions
  ClassTable table;
  std::vector<int64_t> own_class, learner_class;  ///< the classes that both know, pair by pair
};

/// Reads an ONNX file of YOLOv5n or YOLOv5s with three heads, exported by anyone: its convolutions are taken in the
/// order of the file. Without names in its metadata 80 classes are COCO's. Bad input when it is no such network, or has
/// no class in common with `learner`.
Result<Teacher> ReadTeacher(const std::string& path, const ClassTable& learner);

}  // namespace yorb
