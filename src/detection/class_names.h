// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace yorb {

/// A class name as names are compared: case, blanks, underscores and hyphens do not count ("Dining table" is
/// "dining_table").
std::string FoldClassName(std::string_view name);

/// COCO's 80 classes, in the order in which detectors number them.
const std::vector<std::string>& CocoNames();

/// Names as exports carry them: the text of a Python dict with numbers for keys ({0: 'person', 1: "driver's seat"}), of
/// a Python list, or the same as JSON. Nothing for any other text, and where a number from 0 on is missing.
std::optional<std::vector<std::string>> ParseClassNames(std::string_view text);

inline constexpr long long kMostListedClasses = 100000;  ///< numbers beyond it are no class's

/// A list of names, a line each. Where every line begins with a number ("0 person", "0: person"), they say which class
/// is meant, unless none is 0 and names would be alike ("20 km/h", "50 km/h"); a class without a line has an empty
/// name. Bad input names file and line.
Result<std::vector<std::string>> ReadClassList(const std::string& path);

/// The names as such a Python dict, which is what readers of YOLO models know; ParseClassNames reads it again.
std::string ClassNamesText(const std::vector<std::string>& names);

/// All numbers that stand in a text, whatever stands between them: "[640, 480]", "640 480", "(10,13), (16,30)".
std::vector<double> NumbersIn(std::string_view text);

}  // namespace yorb
