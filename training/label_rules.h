// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bitset>
#include <string>
#include <vector>

#include "core/result.h"

namespace yorb {

constexpr int kMostPackedClasses = 128;
using ClassBits = std::bitset<kMostPackedClasses>;

/// What is known of the pictures whose names begin alike.
struct LabelRule {
  std::string prefix;        ///< "*": all others
  ClassBits judged;          ///< the classes whose absence from the labels means that they are absent from the picture
  bool is_squashed = false;  ///< the publisher made it square, whatever its shape was
};

/// Reads lines `prefix word...`; a word is `all`, a class number, a range `0-79`, or `squashed`. The first rule whose
/// prefix fits a picture's name counts.
Result<std::vector<LabelRule>> ReadLabelRules(const std::string& path);

/// The rule for a picture; without one every class is judged.
LabelRule RuleFor(const std::string& picture_name, const std::vector<LabelRule>& rules);

}  // namespace yorb
