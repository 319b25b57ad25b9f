// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "training/class_table.h"
#include "training/labels.h"

namespace yorb {

/// Reads Pascal VOC XML as LabelImg writes it: of each `object` its `name` and its `bndbox` in pixels of the picture
/// whose `size` stands in the file. Boxes marked `difficult` come back as doubtful.
Result<std::vector<LabelBox>> ReadVocLabels(const std::string& path, const ClassTable& classes);

}  // namespace yorb
