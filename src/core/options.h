// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

namespace yorb {

// How options become configuration without YAML outside of `system`: every options struct stands beside the code that
// reads it and lists its fields once, in a static member template that works for const and non-const alike:
//
//   struct FeatureOptions {
//     int wanted = 1000;      ///< points a frame
//     double scale_factor = 1.2;
//
//     template <typename Self, typename Visitor>
//     static void Visit(Self& self, Visitor&& visit) {
//       visit("wanted", self.wanted, Range(50, 20000));
//       visit("scale_factor", self.scale_factor, Range(1.01, 2.0));
//       visit("detector", self.detector, OneOf({"fixed", "adaptive"}));
//     }
//   };
//
// Field types: bool, int, int64_t, double, std::string, and structs that have a Visit of their own (`visit("group",
// self.group)`). The visitor in system/config_io.cc reads, writes, checks and names them.

/// The values that a number may take, both ends included.
struct Range {
  double low;
  double high;
  Range(double low_value, double high_value) : low(low_value), high(high_value) {}
};

/// The words that a text may be.
struct OneOf {
  std::vector<std::string> words;
  OneOf(std::initializer_list<const char*> list) : words(list.begin(), list.end()) {}
};

/// Any value of the field's type (a path, a switch).
struct AnyValue {};

}  // namespace yorb
