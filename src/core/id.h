// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>

namespace yorb {

/// A typed, dense number that names one row of one kind (frame, keyframe, landmark) and is never used again.
/// `Id<Keyframe>` and `Id<Landmark>` do not mix; the default is "none".
template <typename Kind>
class Id {
 public:
  constexpr Id() = default;
  constexpr explicit Id(uint32_t value) : value_(value) {}

  constexpr bool IsValid() const { return value_ != kNone; }
  constexpr uint32_t value() const { return value_; }

  friend constexpr bool operator==(Id a, Id b) { return a.value_ == b.value_; }
  friend constexpr bool operator!=(Id a, Id b) { return a.value_ != b.value_; }
  friend constexpr bool operator<(Id a, Id b) { return a.value_ < b.value_; }

 private:
  static constexpr uint32_t kNone = 0xffffffffu;
  uint32_t value_ = kNone;
};

}  // namespace yorb

template <typename Kind>
struct std::hash<yorb::Id<Kind>> {
  size_t operator()(yorb::Id<Kind> id) const noexcept { return std::hash<uint32_t>()(id.value()); }
};
