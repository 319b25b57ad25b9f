// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/files.h"
#include "experiments/dynamic.h"

namespace yorb {

/// Figures in `folder`, as SVG: for each sequence with truth the tracks beside the truth and the error over time, of
/// each way's first run (the paper's Fig. 10); errors as bars, published ones paler (Tables 8 and 9); times (Table 10);
/// and the tables as text and JSON. The same as PNG, where drawings can be turned into pictures.
std::vector<FileToWrite> DynamicFiles(const DynamicReport& report, const std::vector<DynamicSequence>& sequences,
                                      const std::string& folder);

}  // namespace yorb
