// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

namespace yorb {

/// How the light on a scene behaves.
enum class LightKind {
  kSteady,   ///< as it was recorded
  kRamp,     ///< a slow wave between x0.03 and x2, eight seconds long
  kFlicker,  ///< another factor of 0.1 to 2 in every frame
  kSwitch,   ///< off (x0.02) and on again every four seconds, at once
  kShade,    ///< a hard shadow (x0.03) wanders over the picture
  kDim,      ///< x0.02 all the time
};

/// The words for them, "steady" first, in the order of the enumeration.
const std::vector<std::string>& LightNames();
std::optional<LightKind> ParseLight(const std::string& name);
std::string ToString(LightKind kind);

/// A change of light, and the sensor that sees it.
struct MovingLight {
  LightKind kind = LightKind::kSteady;
  double noise = 1;   ///< 0: none; 1: shot and read noise of a small sensor
  uint64_t seed = 1;  ///< of the flicker and the noise; a frame's depend on this and its number alone
};

/// The factor on the light (not on the grey levels) `seconds` after the start of the recording; of shade: outside of
/// the shadow.
double LightFactor(const MovingLight& light, size_t frame, double seconds);

/// Whether a pixel lies in the wandering shadow at that moment; never, but for shade.
bool IsInShadow(LightKind kind, double seconds, cv::Point pixel, cv::Size size);

/// The picture (8-bit, of one channel or three) as the sensor would have taken it in that light. Grey levels are taken
/// for the 1/2.2th power of the light, so that a factor f changes them by f^(1/2.2); what is too bright saturates. With
/// steady light and no noise the picture itself.
cv::Mat InLight(const MovingLight& light, size_t frame, double seconds, const cv::Mat& picture);

}  // namespace yorb
