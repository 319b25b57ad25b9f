// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/features_light.h"

#include <cmath>
#include <functional>
#include <utility>

#include "core/text.h"

namespace yorb {
namespace {

LightChange Make(std::string name, const std::function<double(double)>& level_of) {
  LightChange change;
  change.name = std::move(name);
  for (int level = 0; level < 256; ++level) {
    change.levels[static_cast<size_t>(level)] = cv::saturate_cast<uint8_t>(level_of(level));
  }
  return change;
}

LightChange Added(int levels) {
  return Make((levels > 0 ? "+" : "") + std::to_string(levels), [=](double level) { return level + levels; });
}

LightChange Bent(double gamma) {
  return Make("gamma " + FormatShortest(gamma), [=](double level) { return 255 * std::pow(level / 255, gamma); });
}

}  // namespace

LightChange Scaled(double factor) {
  return Make("x" + FormatShortest(factor), [=](double level) { return level * factor; });
}

std::vector<LightChange> LightChanges() {
  LightChange half = Scaled(0.3);
  half.name = "half dark";
  half.is_left_half = true;
  return {Scaled(0.6), Scaled(1.4), Added(-40), Added(40), Bent(0.5), Bent(2), half};
}

cv::Mat Relit(const cv::Mat& grey, const LightChange& change) {
  cv::Mat relit = grey.clone();
  const int end = change.is_left_half ? grey.cols / 2 : grey.cols;
  for (int y = 0; y < relit.rows; ++y) {
    uint8_t* row = relit.ptr<uint8_t>(y);
    for (int x = 0; x < end; ++x) row[x] = change.levels[row[x]];
  }
  return relit;
}

}  // namespace yorb
