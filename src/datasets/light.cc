// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/random.h"

namespace yorb {
namespace {

constexpr double kGamma = 2.2;
constexpr double kBright = 2, kRampDark = 0.03, kFlickerDark = 0.1, kOff = 0.02, kShadow = 0.03;
constexpr double kRampPeriodS = 8, kRampBrightestS = 2, kSwitchS = 4;
constexpr double kShadowPeriodS = 10, kShadowTiltPeriodS = 17, kMostTiltRad = 0.5;
constexpr double kShadowReach = 1.4;  // of its edge's way, in widths of the picture, whose middle is the way's middle
constexpr int kFullWell = 4000;       // electrons of a white pixel
constexpr int kStepsAnElectron = 16;
constexpr double kReadNoise = 5;  // electrons
constexpr uint64_t kFlickerStream = 1, kNoiseStream = 2;

/// Between two factors, evenly by their logarithm: `place` is 0 at the dark end and 1 at the bright one.
double Between(double dark, double bright, double place) { return dark * std::pow(bright / dark, place); }

/// A number of its own for each frame and use.
Random RandomOf(const MovingLight& light, size_t frame, uint64_t use) {
  return Random(light.seed, 2 * static_cast<uint64_t>(frame) + use);
}

/// The shadow lies to the left of this column of a row.
int FirstLitColumn(double seconds, int row, cv::Size size) {
  const double place = 0.5 + 0.5 * std::sin(2 * std::numbers::pi * seconds / kShadowPeriodS);
  const double middle = size.width * (kShadowReach * place - (kShadowReach - 1) / 2);
  const double slope = std::tan(kMostTiltRad * std::sin(2 * std::numbers::pi * seconds / kShadowTiltPeriodS));
  const double edge = std::ceil(middle - slope * (row - size.height / 2.0));
  return static_cast<int>(std::clamp(edge, 0.0, static_cast<double>(size.width)));
}

/// Electrons that each grey level stands for, and back.
struct Sensor {
  std::array<float, 256> electrons{};
  std::vector<uint8_t> grey;  ///< of 0 ... kFullWell electrons, in fine steps

  Sensor() : grey(kFullWell * kStepsAnElectron + 1) {
    for (size_t i = 0; i < electrons.size(); ++i)
      electrons[i] = static_cast<float>(kFullWell * std::pow(static_cast<double>(i) / 255, kGamma));
    for (size_t i = 0; i < grey.size(); ++i) {
      const double light = static_cast<double>(i) / static_cast<double>(grey.size() - 1);
      grey[i] = static_cast<uint8_t>(std::lround(255 * std::pow(light, 1 / kGamma)));
    }
  }

  uint8_t GreyOf(float count) const {
    const float kept = std::clamp(count, 0.f, static_cast<float>(kFullWell));
    return grey[static_cast<size_t>(kept * kStepsAnElectron + 0.5f)];
  }
};

/// The sensor at work on one picture.
class Exposure {
 public:
  Exposure(double noise, uint64_t seed) : noise_(static_cast<float>(noise)), random_(seed) {}

  /// So many values under one factor on the light.
  void Expose(const uint8_t* from, uint8_t* to, int count, float factor) {
    static const Sensor sensor;
    constexpr auto kReadVariance = static_cast<float>(kReadNoise * kReadNoise);
    if (count <= 0) return;
    cv::Mat normal(1, count, CV_32FC1, cv::Scalar(0));
    if (noise_ > 0) random_.fill(normal, cv::RNG::NORMAL, 0, 1);
    const float* const error = normal.ptr<float>();
    for (int i = 0; i < count; ++i) {
      const float electrons = sensor.electrons[from[i]] * factor;
      to[i] = sensor.GreyOf(electrons + noise_ * error[i] * std::sqrt(electrons + kReadVariance));
    }
  }

 private:
  float noise_;
  cv::RNG random_;
};

}  // namespace

const std::vector<std::string>& LightNames() {
  static const std::vector<std::string> names = {"steady", "ramp", "flicker", "switch", "shade", "dim"};
  return names;
}

std::optional<LightKind> ParseLight(const std::string& name) {
  const auto& names = LightNames();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<LightKind>(found - names.begin());
}

std::string ToString(LightKind kind) { return LightNames()[static_cast<size_t>(kind)]; }

double LightFactor(const MovingLight& light, size_t frame, double seconds) {
  switch (light.kind) {
    case LightKind::kRamp: {
      const double wave = std::cos(2 * std::numbers::pi * (seconds - kRampBrightestS) / kRampPeriodS);
      return Between(kRampDark, kBright, 0.5 + 0.5 * wave);
    }
    case LightKind::kFlicker:
      return Between(kFlickerDark, kBright, RandomOf(light, frame, kFlickerStream).Uniform());
    case LightKind::kSwitch:
      return static_cast<int64_t>(std::floor(seconds / kSwitchS)) % 2 == 0 ? 1.0 : kOff;
    case LightKind::kDim:
      return kOff;
    case LightKind::kSteady:
    case LightKind::kShade:
      break;
  }
  return 1;
}

bool IsInShadow(LightKind kind, double seconds, cv::Point pixel, cv::Size size) {
  return kind == LightKind::kShade && pixel.x < FirstLitColumn(seconds, pixel.y, size);
}

cv::Mat InLight(const MovingLight& light, size_t frame, double seconds, const cv::Mat& picture) {
  if (picture.empty() || (light.kind == LightKind::kSteady && light.noise <= 0)) return picture;
  Exposure exposure(light.noise, RandomOf(light, frame, kNoiseStream).Next());
  const auto factor = static_cast<float>(LightFactor(light, frame, seconds));
  const int channels = picture.channels();
  cv::Mat result(picture.size(), picture.type());
  for (int y = 0; y < picture.rows; ++y) {
    const uint8_t* const from = picture.ptr(y);
    uint8_t* const to = result.ptr(y);
    const int begin = light.kind == LightKind::kShade ? FirstLitColumn(seconds, y, picture.size()) * channels : 0;
    exposure.Expose(from, to, begin, static_cast<float>(kShadow));
    exposure.Expose(from + begin, to + begin, picture.cols * channels - begin, factor);
  }
  return result;
}

}  // namespace yorb
