// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/average_precision.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/iou.h"

namespace yorb {
namespace {

constexpr int kNumThresholds = 10;

struct JudgedHit {
  float confidence = 0;
  std::array<bool, kNumThresholds> is_right{};
};

/// Judges the boxes of one class in one picture at one threshold.
void JudgeAt(double threshold, size_t column, const std::vector<SceneBox>& truth, const std::vector<Detection>& found,
             std::vector<JudgedHit>& verdicts) {
  std::vector<bool> is_taken(truth.size());
  for (size_t i = 0; i < found.size(); ++i) {
    double best = threshold;
    int best_index = -1;
    for (size_t t = 0; t < truth.size(); ++t) {
      const double iou = is_taken[t] ? 0 : IoU(found[i].box, truth[t]);
      if (iou >= best) best = iou, best_index = static_cast<int>(t);
    }
    if (best_index < 0) continue;
    is_taken[static_cast<size_t>(best_index)] = true;
    verdicts[verdicts.size() - found.size() + i].is_right[column] = true;
  }
}

/// Area under the precision's upper hull, read at 101 points of recall.
double AveragePrecision(const std::vector<JudgedHit>& verdicts, size_t column, int num_true) {
  std::vector<double> precision, recall;
  int num_right = 0;
  for (size_t i = 0; i < verdicts.size(); ++i) {
    num_right += verdicts[i].is_right[column];
    precision.push_back(static_cast<double>(num_right) / static_cast<double>(i + 1));
    recall.push_back(static_cast<double>(num_right) / num_true);
  }
  for (size_t i = precision.size(); i-- > 1;) precision[i - 1] = std::max(precision[i - 1], precision[i]);
  double sum = 0;
  for (int point = 0; point <= 100; ++point) {
    const auto at = std::lower_bound(recall.begin(), recall.end(), point / 100.0 - 1e-12);
    if (at != recall.end()) sum += precision[static_cast<size_t>(at - recall.begin())];
  }
  return sum / 101;
}

}  // namespace

std::vector<ClassScore> ScoreClasses(const std::vector<JudgedPicture>& pictures, int num_classes) {
  std::vector<ClassScore> scores;
  for (int c = 0; c < num_classes; ++c) {
    ClassScore score{.class_index = c};
    std::vector<JudgedHit> verdicts;
    for (const JudgedPicture& picture : pictures) {
      std::vector<SceneBox> truth;
      std::vector<Detection> found;
      for (const SceneBox& box : picture.truth) {
        if (box.class_index == c) truth.push_back(box);
      }
      for (const Detection& detection : picture.found) {
        if (detection.box.class_index == c) found.push_back(detection);
      }
      score.num_true += static_cast<int>(truth.size());
      for (const Detection& detection : found) verdicts.push_back({detection.confidence, {}});
      for (int i = 0; i < kNumThresholds; ++i) JudgeAt(0.5 + 0.05 * i, static_cast<size_t>(i), truth, found, verdicts);
    }
    if (score.num_true == 0) continue;
    std::stable_sort(verdicts.begin(), verdicts.end(),
                     [](const auto& a, const auto& b) { return a.confidence > b.confidence; });
    score.ap50 = AveragePrecision(verdicts, 0, score.num_true);
    for (size_t i = 0; i < kNumThresholds; ++i) score.ap += AveragePrecision(verdicts, i, score.num_true) / 10;
    scores.push_back(score);
  }
  return scores;
}

}  // namespace yorb
