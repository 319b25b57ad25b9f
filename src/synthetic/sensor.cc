// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic/sensor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/random.h"

namespace yorb {
namespace {

constexpr double kBaseline = 0.075;           // metres from the projector to the infrared camera
constexpr float kDisparityFocal = 535;        // pixels of the infrared camera at its own size, whatever the picture's
constexpr float kDisparityStep = 0.125f;      // pixels
constexpr float kDisparityDeviation = 0.06f;  // pixels: 1.5 mm at 1 m, 2.4 cm at 4 m
constexpr float kNearest = 0.45f, kFarthest = 4.5f;  // metres; holes become more from there on
constexpr float kGrazing = 0.3f;                     // cosine of the angle below which holes become more
constexpr int kTableBits = 12;

// Normal numbers from a table, four a draw: a picture needs a million of them.
class QuickGaussians {
 public:
  QuickGaussians() {
    Random random(20);
    for (float& value : table_) value = static_cast<float>(random.Gaussian());
  }
  float operator[](uint64_t bits) const { return table_[bits & (table_.size() - 1)]; }

 private:
  std::array<float, 1 << kTableBits> table_{};
};

const QuickGaussians& Gaussians() {
  static const QuickGaussians kTable;
  return kTable;
}

// A picture of normal numbers that resemble their neighbours (an autoregression along both axes).
cv::Mat SharedNoise(cv::Size size, float resemblance, Random random) {
  const QuickGaussians& gaussians = Gaussians();
  cv::Mat noise(size, CV_32FC1);
  const float fresh = 1 - resemblance * resemblance;
  std::vector<float> above(static_cast<size_t>(size.width) + 1, 0.f);
  for (int y = 0; y < size.height; ++y) {
    auto* row = noise.ptr<float>(y);
    const float share = y == 0 ? std::sqrt(fresh) : fresh;
    float left = 0;
    for (int x = 0; x < size.width; ++x) {
      const float here = gaussians[random.Next() >> 20] * (x == 0 ? share / std::sqrt(fresh) : share);
      left = row[x] = resemblance * left + resemblance * above[x + 1] - resemblance * resemblance * above[x] + here;
    }
    std::copy(row, row + size.width, above.begin() + 1);
  }
  return noise;
}

// Which pixels of a row the projector, which stands to the right, does not reach: something further right with more
// disparity is in its way.
void MarkShadow(const float* depth, int width, float focal_baseline, std::vector<uint8_t>& is_dark) {
  float nearest_line = -1e9f;
  for (int x = width - 1; x >= 0; --x) {
    const float disparity = depth[x] > 0 ? focal_baseline / depth[x] : 0;
    const float line = disparity - static_cast<float>(x);
    is_dark[x] = line < nearest_line - 1.5f;
    nearest_line = std::max(nearest_line, line);
  }
}

// Cosine of the angle between the optical axis and the surface's normal, from the differences of the neighbours.
float FacingCosine(const cv::Mat& depth, int x, int y, float focal) {
  const auto at = [&](int column, int row) {
    return depth.at<float>(std::clamp(row, 0, depth.rows - 1), std::clamp(column, 0, depth.cols - 1));
  };
  const float unit = 2 * at(x, y) / focal;  // metres between the neighbours, across
  const float slope_x = (at(x + 1, y) - at(x - 1, y)) / unit, slope_y = (at(x, y + 1) - at(x, y - 1)) / unit;
  return 1 / std::sqrt(1 + slope_x * slope_x + slope_y * slope_y);
}

uint16_t ToUnits(float metres, double factor) {
  const double units = std::round(metres * factor);
  return units < 65535 ? static_cast<uint16_t>(units) : 0;
}

}  // namespace

void AddColourNoise(const SensorOptions& options, uint64_t frame, cv::Mat& colour) {
  if (options.noise <= 0) return;
  const QuickGaussians& gaussians = Gaussians();
  Random random(options.seed, frame * 4 + 1);
  const auto scale = static_cast<float>(options.noise);
  for (int y = 0; y < colour.rows; ++y) {
    auto* row = colour.ptr<uchar>(y);
    for (int x = 0; x < colour.cols; ++x, row += 3) {
      const uint64_t bits = random.Next();
      // Brightness grain is shared by the channels, colour grain is not.
      const float dark = scale * (2.2f - 1.0f * static_cast<float>(row[1]) / 255), shared = dark * gaussians[bits];
      for (int c = 0; c < 3; ++c)
        row[c] = cv::saturate_cast<uchar>(static_cast<float>(row[c]) + shared +
                                          0.6f * dark * gaussians[bits >> (kTableBits * (c + 1))]);
    }
  }
}

cv::Mat MeasureDepth(const SensorOptions& options, uint64_t frame, const Rig& rig, const cv::Mat& exact) {
  cv::Mat units(exact.size(), CV_16UC1, cv::Scalar::all(0));
  const auto noise = static_cast<float>(options.noise);
  if (noise <= 0) {
    for (int y = 0; y < exact.rows; ++y) {
      for (int x = 0; x < exact.cols; ++x) units.at<uint16_t>(y, x) = ToUnits(exact.at<float>(y, x), rig.depth_factor);
    }
    return units;
  }
  const cv::Mat error = SharedNoise(exact.size(), 0.6f, Random(options.seed, frame * 4 + 2));
  const cv::Mat failure = SharedNoise(exact.size(), 0.75f, Random(options.seed, frame * 4 + 3));
  const auto focal = static_cast<float>(rig.camera.fx),
             focal_baseline = static_cast<float>(kBaseline) * kDisparityFocal;
  std::vector<uint8_t> is_dark(static_cast<size_t>(exact.cols));
  for (int y = 0; y < exact.rows; ++y) {
    const auto* depth = exact.ptr<float>(y);
    MarkShadow(depth, exact.cols, static_cast<float>(kBaseline) * focal, is_dark);
    for (int x = 0; x < exact.cols; ++x) {
      const float z = depth[x];
      if (z < kNearest || is_dark[x]) continue;
      const float grazing = std::max(0.f, kGrazing - FacingCosine(exact, x, y, focal)) / kGrazing;
      if (failure.at<float>(y, x) * noise > 2.9f - 1.8f * std::max(0.f, z - kFarthest) - 4.5f * grazing) continue;
      const float disparity = focal_baseline / z + noise * kDisparityDeviation * error.at<float>(y, x);
      const float stepped = kDisparityStep * std::round(disparity / kDisparityStep);
      if (stepped > 0) units.at<uint16_t>(y, x) = ToUnits(focal_baseline / stepped, rig.depth_factor);
    }
  }
  return units;
}

}  // namespace yorb
