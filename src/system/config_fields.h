// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "system/config.h"

namespace yorb {

/// One value of the configuration, whatever its type.
struct ConfigField {
  std::string key;                              ///< dotted: features.wanted
  std::string text;                             ///< the present value, so that it reads back as the same
  std::string wanted;                           ///< what may stand there, in words: "a whole number from 1 to 12"
  bool is_text = false;                         ///< a word rather than a number or a switch
  std::function<bool(const std::string&)> set;  ///< false, and nothing changed, where the text may not stand there
};

/// All values of `config` in the order of their declaration; valid for as long as `config` lives and stays in place.
std::vector<ConfigField> FieldsOf(Config& config);

}  // namespace yorb
