// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "detection/network.h"

namespace yorb {

/// One row of a network's table: the operators that belong to one named part of it, as "5" of "5.expand" and "5.dw", or
/// one convolution with what follows it where the file has no such names.
struct NetworkRow {
  std::string name;    ///< "5", or a number in brackets where the file has none
  std::string from;    ///< the rows that it reads; "picture" for the first
  std::string module;  ///< "Conv3x3/2 HardSwish", "Concat"
  int64_t parameters = 0;
  double gflops = 0;           ///< two a multiplication and addition; of convolutions and matrices
  std::vector<int64_t> shape;  ///< of what it gives
};

/// A network in numbers.
struct NetworkTable {
  std::vector<NetworkRow> rows;
  int64_t parameters = 0;
  size_t num_convolutions = 0;
  std::optional<double> gflops;  ///< nothing where an operator is not known
};

/// Takes a network apart. Shapes and operations need all its operators to be known.
NetworkTable TableOf(const Network& network);

}  // namespace yorb
