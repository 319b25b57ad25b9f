// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/time.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include "core/text.h"

namespace yorb {
namespace {

constexpr int kNanoDigits = 9;
constexpr int kMaxDigits = 18;  // what int64 holds for certain

/// The digits of a decimal number with the point taken out, and where the point stood.
struct Decimal {
  std::string digits;
  int point = 0;
  bool is_negative = false;
};

std::optional<Decimal> ReadDecimal(std::string_view text) {
  Decimal decimal;
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) {
    decimal.is_negative = text.front() == '-';
    text.remove_prefix(1);
  }
  const size_t mantissa_end = std::min(text.find_first_of("eE"), text.size());
  const std::string_view mantissa = text.substr(0, mantissa_end);
  const size_t point = std::min(mantissa.find('.'), mantissa.size());
  decimal.digits = std::string(mantissa.substr(0, point));
  if (point < mantissa.size()) decimal.digits += mantissa.substr(point + 1);
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (decimal.digits.empty() || !std::all_of(decimal.digits.begin(), decimal.digits.end(), is_digit))
    return std::nullopt;
  decimal.point = static_cast<int>(point);
  if (mantissa_end < text.size()) {
    const auto exponent = ParseInteger(text.substr(mantissa_end + 1));
    if (!exponent || *exponent > 30 || *exponent < -60) return std::nullopt;
    decimal.point += static_cast<int>(*exponent);
  }
  return decimal;
}

}  // namespace

std::optional<Timestamp> ParseTimestamp(std::string_view text) {
  auto decimal = ReadDecimal(Trim(text));
  if (!decimal) return std::nullopt;
  std::string& digits = decimal->digits;
  int point = decimal->point;
  if (point < 0) {
    digits.insert(0, static_cast<size_t>(-point), '0');
    point = 0;
  }
  const size_t wanted = static_cast<size_t>(point + kNanoDigits);
  const bool round_up = digits.size() > wanted && digits[wanted] >= '5';
  digits.resize(wanted, '0');
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size()));
  if (digits.size() > kMaxDigits + 1) return std::nullopt;
  int64_t ns = 0;
  if (!digits.empty() && std::from_chars(digits.data(), digits.data() + digits.size(), ns).ec != std::errc()) {
    return std::nullopt;
  }
  if (round_up && ns == std::numeric_limits<int64_t>::max()) return std::nullopt;
  ns += round_up;
  return Timestamp{decimal->is_negative ? -ns : ns};
}

std::string ToString(Timestamp time) {
  const bool is_negative = time.ns < 0;
  const uint64_t ns = is_negative ? 0 - static_cast<uint64_t>(time.ns) : static_cast<uint64_t>(time.ns);
  std::string fraction = std::to_string(ns % 1000000000u);
  fraction.insert(0, kNanoDigits - fraction.size(), '0');
  if (ns % 1000 == 0) fraction.resize(6);
  return (is_negative ? "-" : "") + std::to_string(ns / 1000000000u) + "." + fraction;
}

std::string RangeText(const std::vector<Timestamp>& times) {
  if (times.empty()) return "";
  const auto range = std::minmax_element(times.begin(), times.end());
  return ToString(*range.first) + " to " + ToString(*range.second);
}

}  // namespace yorb
