// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "matching/by_flow.h"

#include <opencv2/video/tracking.hpp>

namespace yorb {

std::vector<std::optional<Eigen::Vector2f>> FollowByFlow(const cv::Mat& from, const cv::Mat& to,
                                                         const std::vector<FlowGuess>& guesses) {
  constexpr int kWindowPx = 21, kLevels = 3;
  constexpr double kMostOffPx = 1;        // on the way back
  constexpr double kLeastTexture = 1e-3;  // smallest eigenvalue of the gradients' matrix, grey values a pixel
  std::vector<std::optional<Eigen::Vector2f>> followed(guesses.size());
  if (guesses.empty() || from.empty() || from.size() != to.size()) return followed;
  std::vector<cv::Point2f> start, there, back;
  for (const FlowGuess& guess : guesses) {
    start.emplace_back(guess.from_px.x(), guess.from_px.y());
    there.emplace_back(guess.to_px.x(), guess.to_px.y());
  }
  back = start;
  const cv::Size window(kWindowPx, kWindowPx);
  const cv::TermCriteria enough(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 20, 0.03);
  std::vector<uint8_t> is_found, is_back;
  std::vector<cv::Mat> from_levels, to_levels;
  cv::buildOpticalFlowPyramid(from, from_levels, window, kLevels);
  cv::buildOpticalFlowPyramid(to, to_levels, window, kLevels);
  cv::calcOpticalFlowPyrLK(from_levels, to_levels, start, there, is_found, cv::noArray(), window, kLevels, enough,
                           cv::OPTFLOW_USE_INITIAL_FLOW, kLeastTexture);
  cv::calcOpticalFlowPyrLK(to_levels, from_levels, there, back, is_back, cv::noArray(), window, kLevels, enough,
                           cv::OPTFLOW_USE_INITIAL_FLOW, kLeastTexture);
  for (size_t i = 0; i < guesses.size(); ++i) {
    if (is_found[i] != 0 && is_back[i] != 0 && cv::norm(back[i] - start[i]) < kMostOffPx) {
      followed[i] = Eigen::Vector2f(there[i].x, there[i].y);
    }
  }
  return followed;
}

}  // namespace yorb
