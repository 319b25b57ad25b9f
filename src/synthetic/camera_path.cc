// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic/camera_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.h"

namespace yorb {
namespace {

constexpr double kTurnSeconds = 4.5;  // a way there and back along one axis

// Camera axes in the world: z along `forward`, x to the right, y down.
Rigid3 Looking(const Eigen::Vector3d& from, const Eigen::Vector3d& forward) {
  const Eigen::Vector3d z = forward.normalized(), x = z.cross(Eigen::Vector3d::UnitZ()).normalized();
  Eigen::Matrix3d axes;
  axes << x, z.cross(x), z;
  return {axes, from};
}

// Axis by axis there and back: which axis has its turn, and how far it is out, in -0.65 .. 0.65; starts and ends at
// rest, so that the next axis takes over without a jerk.
struct Turn {
  int axis = 0;
  double out = 0;
};
Turn AxisInTurn(double seconds) {
  const double turn = std::floor(seconds / kTurnSeconds), t = seconds / kTurnSeconds - turn;
  const double window = std::sin(std::numbers::pi * t);
  return {static_cast<int>(turn - 3 * std::floor(turn / 3)), std::sin(2 * std::numbers::pi * t) * window * window};
}

// 0 to 1 with a soft start and stop.
double Ease(double t) {
  t = std::clamp(t, 0.0, 1.0);
  constexpr double kSoft = 0.12;                                              // share of the time for each of them
  const auto risen = [](double x) { return x * x * x - x * x * x * x / 2; };  // integral of smoothstep
  const double total = 1 - kSoft;
  if (t < kSoft) return kSoft * risen(t / kSoft) / total;
  if (t > 1 - kSoft) return 1 - kSoft * risen((1 - t) / kSoft) / total;
  return (t - kSoft / 2) / total;
}

}  // namespace

const std::vector<std::string>& PathNames() {
  static const std::vector<std::string> kNames{"xyz", "halfsphere", "rpy", "static", "loop"};
  return kNames;
}

std::optional<PathKind> ParsePathKind(const std::string& name) {
  const auto found = std::find(PathNames().begin(), PathNames().end(), name);
  if (found == PathNames().end()) return std::nullopt;
  return static_cast<PathKind>(found - PathNames().begin());
}

CameraPath::CameraPath(PathKind kind, const Stage& stage, double duration_s, uint64_t seed)
    : kind_(kind), stage_(stage), duration_s_(duration_s) {
  Random random(seed, 0xca3e7a);
  for (size_t axis = 0; axis < sway_.size(); ++axis) {
    const double size = axis < 3 ? 0.0025 : 0.0035;  // of the slow sway; the quick tremor is far smaller
    for (size_t i = 0; i < kNumWaves; ++i) {
      const double hertz = 0.25 * std::pow(2.1, static_cast<double>(i)) * random.Uniform(0.8, 1.25);
      sway_[axis][i] = {size * 0.25 / hertz * random.Uniform(0.7, 1.3), 2 * std::numbers::pi * hertz,
                        random.Uniform(0, 2 * std::numbers::pi)};
    }
  }
}

Rigid3 CameraPath::WorldFromCamera(double seconds) const { return Intended(seconds) * HandSway(seconds); }

Rigid3 CameraPath::HandSway(double seconds) const {
  Eigen::Matrix<double, 6, 1> step;
  for (size_t axis = 0; axis < sway_.size(); ++axis) {
    double sum = 0;
    for (const Wave& wave : sway_[axis]) sum += wave.amplitude * std::sin(wave.rate * seconds + wave.phase);
    step[static_cast<Eigen::Index>(axis)] = sum;
  }
  return {RotationFromVector(step.head<3>()), step.tail<3>()};
}

Rigid3 CameraPath::Intended(double seconds) const {
  const Rigid3 held = Looking(stage_.stand, stage_.focus - stage_.stand);
  switch (kind_) {
    case PathKind::kXyz: {
      const Eigen::Vector3d reach(0.45, 0.28, 0.4);  // to the right, down, forward
      const Turn turn = AxisInTurn(seconds);
      return held *
             Rigid3(Eigen::Quaterniond::Identity(), turn.out * reach[turn.axis] * Eigen::Vector3d::Unit(turn.axis));
    }
    case PathKind::kRpy: {
      const Eigen::Vector3d reach(0.5, 0.25, 0.45);  // roll, pitch, yaw
      const Turn turn = AxisInTurn(seconds);
      const std::array<Eigen::Vector3d, 3> axes{Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX(),
                                                Eigen::Vector3d::UnitY()};
      return held * Rigid3(RotationFromVector(turn.out * reach[turn.axis] * axes[static_cast<size_t>(turn.axis)]),
                           Eigen::Vector3d::Zero());
    }
    case PathKind::kHalfsphere: {
      const double azimuth = std::numbers::pi + 0.6 * std::sin(2 * std::numbers::pi * seconds / 15.0),
                   elevation = 0.3 + 0.24 * std::sin(2 * std::numbers::pi * seconds / 8.7 + 4.2);
      const Eigen::Vector3d out(std::cos(azimuth) * std::cos(elevation), std::sin(azimuth) * std::cos(elevation),
                                std::sin(elevation));
      return Looking(stage_.focus + (stage_.stand - stage_.focus).norm() * out, -out);
    }
    case PathKind::kStatic:
      return held;
    case PathKind::kLoop:
      break;
  }
  return Loop(seconds);
}

Rigid3 CameraPath::Loop(double seconds) const {
  constexpr double kMoving = 0.96;       // share of the time; the rest is spent at the start again
  constexpr double kAhead = 0.3;         // radians from straight outwards towards the way
  constexpr double kStepsOfARound = 14;  // a walker's head goes up and down
  const double angle = 2 * std::numbers::pi * Ease(seconds / (kMoving * duration_s_));
  const Eigen::Vector3d out(std::cos(angle), std::sin(angle), 0);
  const Eigen::Vector3d place(stage_.loop_radii.x() * out.x(), stage_.loop_radii.y() * out.y(),
                              0.015 * std::sin(kStepsOfARound * angle));
  const double gaze = angle + kAhead + 0.12 * std::sin(3 * angle);
  return Looking(stage_.loop_centre + place, {std::cos(gaze), std::sin(gaze), -0.17 + 0.06 * std::sin(2 * angle)});
}

}  // namespace yorb
