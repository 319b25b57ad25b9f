// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/photometric.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "pictures/jpeg.h"

namespace yorb {
namespace {

/// Gains of hue, saturation and brightness by tables of 256 entries.
void VaryHsv(const PhotometricOptions& options, cv::Mat pixels, Random& random) {
  const double hue = 1 + random.Uniform(-options.hue, options.hue);
  const double saturation = 1 + random.Uniform(-options.saturation, options.saturation);
  const double brightness = 1 + random.Uniform(-options.brightness, options.brightness);
  cv::Mat table(1, 256, CV_8UC3);
  for (int i = 0; i < 256; ++i) {
    table.at<cv::Vec3b>(i) = {static_cast<uint8_t>(static_cast<int>(i * hue + 0.5) % 180),
                              cv::saturate_cast<uint8_t>(i * saturation), cv::saturate_cast<uint8_t>(i * brightness)};
  }
  cv::Mat hsv;
  cv::cvtColor(pixels, hsv, cv::COLOR_BGR2HSV);
  cv::LUT(hsv, table, hsv);
  cv::cvtColor(hsv, pixels, cv::COLOR_HSV2BGR);
}

/// A line of equal weights: a camera that moved while it exposed.
void BlurByMotion(cv::Mat pixels, Random& random) {
  const int length = 3 + 2 * static_cast<int>(random.Below(4));
  const double angle = random.Uniform(0, CV_PI);
  cv::Mat kernel = cv::Mat::zeros(length, length, CV_32F);
  const double reach = length / 2;
  const cv::Point middle(length / 2, length / 2);
  const cv::Point end(static_cast<int>(std::lround(std::cos(angle) * reach)),
                      static_cast<int>(std::lround(std::sin(angle) * reach)));
  cv::line(kernel, middle - end, middle + end, cv::Scalar(1));
  cv::filter2D(pixels, pixels, -1, kernel / cv::sum(kernel)[0]);
}

void AddNoise(double deviation, cv::Mat pixels, Random& random) {
  cv::RNG generator(random.Next());
  cv::Mat noise(pixels.size(), CV_16SC3), noisy;
  generator.fill(noise, cv::RNG::NORMAL, 0, deviation);
  cv::add(pixels, noise, pixels, cv::noArray(), CV_8U);
}

void Compress(cv::Mat pixels, Random& random) {
  const Result<std::string> bytes = EncodeJpeg(pixels, 35 + static_cast<int>(random.Below(56)));
  if (!bytes) return;
  const DecodedPicture decoded = DecodeJpeg(*bytes);
  if (decoded.kind == DecodedPicture::Kind::kWhole) decoded.pixels.copyTo(pixels);
}

}  // namespace

void VaryLight(const PhotometricOptions& options, cv::Mat pixels, Random& random) {
  VaryHsv(options, pixels, random);
  if (random.Uniform() < options.grey) {
    cv::Mat grey;
    cv::cvtColor(pixels, grey, cv::COLOR_BGR2GRAY);
    cv::cvtColor(grey, pixels, cv::COLOR_GRAY2BGR);
  }
  if (random.Uniform() < options.blur) {
    if (random.Uniform() < 0.5)
      BlurByMotion(pixels, random);
    else
      cv::GaussianBlur(pixels, pixels, cv::Size(), random.Uniform(0.5, 1.6));
  }
  if (random.Uniform() < options.noise) AddNoise(random.Uniform(1, options.most_noise), pixels, random);
  if (random.Uniform() < options.jpeg) Compress(pixels, random);
}

}  // namespace yorb
