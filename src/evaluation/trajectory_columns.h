// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "core/time.h"

namespace yorb {

/// Which column holds what.
struct TrajectoryColumns {
  size_t stamp = 0;
  std::array<size_t, 3> position = {1, 2, 3};
  std::array<size_t, 4> quaternion_xyzw = {4, 5, 6, 7};
  size_t count = 8;  ///< columns a line
  int stamp_decimals =
      0;  ///< 9: stamps are nanoseconds, 6: microseconds, 3: milliseconds, 0: seconds, -1: by their size
};

/// What a header's words say; nothing unless each of time, x, y, z, qx, qy, qz, qw is named exactly once.
std::optional<TrajectoryColumns> ColumnsFromHeader(const std::vector<std::string_view>& words);

/// The unit of a stamp by its size: seconds since 1970 have ten digits, nanoseconds nineteen. As `stamp_decimals`.
int StampDecimalsBySize(double stamp);

/// Reads "1403636579763555584" with 9 decimals as 1403636579.763555584 s, without loss.
std::optional<Timestamp> ParseScaledStamp(std::string_view text, int decimals);

/// The fields of a line, parted by commas where it has any, else by blanks; one comma at the end counts for nothing.
std::vector<std::string_view> SplitColumns(std::string_view line);

}  // namespace yorb
