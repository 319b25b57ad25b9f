// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace yorb {

/// A moment: whole nanoseconds since the data set's own epoch. Integers, because a double holds a stamp like
/// 1305031102.175304 to 0.2 microseconds only, and equal stamps must compare equal.
struct Timestamp {
  int64_t ns = 0;

  /// Seconds since the epoch of the data set; for display and for differences that were taken first.
  double seconds() const { return static_cast<double>(ns) * 1e-9; }

  friend bool operator==(Timestamp a, Timestamp b) { return a.ns == b.ns; }
  friend bool operator!=(Timestamp a, Timestamp b) { return a.ns != b.ns; }
  friend bool operator<(Timestamp a, Timestamp b) { return a.ns < b.ns; }
  friend bool operator<=(Timestamp a, Timestamp b) { return a.ns <= b.ns; }
  friend bool operator>(Timestamp a, Timestamp b) { return a.ns > b.ns; }
  friend bool operator>=(Timestamp a, Timestamp b) { return a.ns >= b.ns; }
};

/// `later` - `earlier` in seconds, to the microsecond: a stamp that was printed from a double differs from the original
/// in the seventh decimal, and the same recording must give the same motion to the bit.
inline double SecondsBetween(Timestamp earlier, Timestamp later) {
  const int64_t ns = later.ns - earlier.ns;
  return static_cast<double>((ns + (ns < 0 ? -500 : 500)) / 1000) * 1e-6;
}

/// Reads "1305031102.175304", "1.305031102175304e9" and the like without going through a double. Digits finer than a
/// nanosecond are rounded. Nothing for other text, for nan and inf, and beyond +-292 years.
std::optional<Timestamp> ParseTimestamp(std::string_view text);

/// Seconds with a decimal point in every locale: six decimals, or nine where six would lose something.
std::string ToString(Timestamp time);

/// What times cover, whatever their order: "1.000000 to 2.500000"; empty for none.
std::string RangeText(const std::vector<Timestamp>& times);

}  // namespace yorb
