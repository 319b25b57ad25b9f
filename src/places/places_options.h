// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/options.h"

namespace yorb {

/// Options of recognising places; YAML group `places`.
struct PlacesOptions {
  std::string vocabulary;  ///< a file of yorb vocab train, or ORBvoc.txt; empty: the one that comes with yorb

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("vocabulary", self.vocabulary, AnyValue());
  }
};

}  // namespace yorb
