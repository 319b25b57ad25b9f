// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/rigid3.h"
#include "synthetic/room.h"

namespace yorb {

/// How a hand moves the camera; the first four are modelled on TUM's sequences of the same names.
enum class PathKind {
  kXyz,         ///< along its own axes in turn, looking the same way
  kHalfsphere,  ///< on a part of a sphere round the desk, looking at it
  kRpy,         ///< turning about its own axes in turn
  kStatic,      ///< held still, as still as a hand can
  kLoop,        ///< once round the room, looking outwards, back to the start
};

/// The words of the command line, in the order of PathKind.
const std::vector<std::string>& PathNames();

/// Nothing for an unknown word.
std::optional<PathKind> ParsePathKind(const std::string& name);

/// Where the camera is at any moment: smooth, at a hand's speeds (about 0.2 m/s and 20 degrees/s at most, but for a
/// loop that has to be round in little time), with a hand's sway and tremor.
class CameraPath {
 public:
  /// `duration_s`: a loop is round when it is over; the other paths go on for ever.
  CameraPath(PathKind kind, const Stage& stage, double duration_s, uint64_t seed);

  Rigid3 WorldFromCamera(double seconds) const;

 private:
  struct Wave {
    double amplitude = 0, rate = 0, phase = 0;
  };
  static constexpr size_t kNumWaves = 5;

  Rigid3 Intended(double seconds) const;
  Rigid3 Loop(double seconds) const;
  Rigid3 HandSway(double seconds) const;

  PathKind kind_;
  Stage stage_;
  double duration_s_;
  std::array<std::array<Wave, kNumWaves>, 6> sway_;  // three turns (radians), three ways (metres)
};

}  // namespace yorb
