// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/detection_map.h"

#include <algorithm>
#include <map>

#include "core/iou.h"

namespace yorb {
namespace {

constexpr size_t kNumOverlaps = 10;
constexpr size_t kMostBoxes = 100;  // of a class in one picture, for average precision: COCO's maxDets

double LeastOverlap(size_t index) { return 0.5 + 0.05 * static_cast<double>(index); }

/// One found box of a class: whether it is right, for every least overlap.
struct JudgedHit {
  double confidence = 0;
  bool is_on_curve = true;  ///< whether average precision knows it
  std::vector<bool> is_hit;
};

/// All about one class.
struct ClassHits {
  size_t num_true = 0;
  std::vector<JudgedHit> hits;
};

std::vector<JudgedBox> OfClass(const std::vector<JudgedBox>& boxes, int label) {
  std::vector<JudgedBox> chosen;
  std::copy_if(boxes.begin(), boxes.end(), std::back_inserter(chosen),
               [&](const JudgedBox& box) { return box.label == label; });
  return chosen;
}

/// Of the true boxes that are free the one that overlaps most, if enough; of equal ones the last, as COCO has it.
std::optional<size_t> BestFree(const JudgedBox& box, const std::vector<JudgedBox>& truth,
                               const std::vector<bool>& is_taken, double least) {
  std::optional<size_t> best;
  double most = std::min(least, 1 - 1e-10);
  for (size_t i = 0; i < truth.size(); ++i) {
    const double overlap = is_taken[i] ? -1 : IoU(box, truth[i]);
    if (overlap < most) continue;
    most = overlap;
    best = i;
  }
  return best;
}

/// Judges the boxes of one class in one picture.
void Judge(const JudgedPicture& picture, int label, ClassHits& all) {
  const std::vector<JudgedBox> truth = OfClass(picture.truth, label);
  std::vector<JudgedBox> found = OfClass(picture.found, label);
  std::stable_sort(found.begin(), found.end(),
                   [](const JudgedBox& a, const JudgedBox& b) { return a.confidence > b.confidence; });
  const size_t first = all.hits.size();
  all.num_true += truth.size();
  for (size_t i = 0; i < found.size(); ++i)
    all.hits.push_back({found[i].confidence, i < kMostBoxes, std::vector<bool>(kNumOverlaps)});
  for (size_t k = 0; k < kNumOverlaps; ++k) {
    std::vector<bool> is_taken(truth.size(), false);
    for (size_t i = 0; i < found.size(); ++i) {
      const auto best = BestFree(found[i], truth, is_taken, LeastOverlap(k));
      if (best) is_taken[*best] = true;
      all.hits[first + i].is_hit[k] = best.has_value();
    }
  }
}

std::vector<bool> HitsAt(const std::vector<JudgedHit>& judged, size_t overlap) {
  std::vector<bool> hits;
  for (const JudgedHit& one : judged) {
    if (one.is_on_curve) hits.push_back(one.is_hit[overlap]);
  }
  return hits;
}

ClassScore ScoreOf(int label, ClassHits& all, double confidence) {
  std::stable_sort(all.hits.begin(), all.hits.end(),
                   [](const JudgedHit& a, const JudgedHit& b) { return a.confidence > b.confidence; });
  ClassScore score{label, all.num_true, 0, 0, std::nullopt, 0};
  for (size_t k = 0; k < kNumOverlaps; ++k) {
    const double ap = AveragePrecision(HitsAt(all.hits, k), all.num_true);
    if (k == 0) score.ap50 = ap;
    score.ap += ap;
  }
  score.ap /= kNumOverlaps;
  double num_found = 0, num_hits = 0;
  for (const JudgedHit& one : all.hits) {
    if (one.confidence < confidence) break;
    ++num_found;
    num_hits += one.is_hit[0] ? 1 : 0;
  }
  if (num_found > 0) score.precision = num_hits / num_found;
  score.recall = num_hits / static_cast<double>(all.num_true);
  return score;
}

}  // namespace

double AveragePrecision(const std::vector<bool>& hits, size_t num_true) {
  constexpr int kPoints = 101;
  if (num_true == 0) return 0;
  std::vector<double> precision, recall;
  double num_hits = 0;
  for (const bool is_hit : hits) {
    num_hits += is_hit ? 1 : 0;
    precision.push_back(num_hits / static_cast<double>(precision.size() + 1));
    recall.push_back(num_hits / static_cast<double>(num_true));
  }
  for (size_t i = precision.size(); i > 1; --i) precision[i - 2] = std::max(precision[i - 2], precision[i - 1]);
  double sum = 0;
  for (int point = 0; point < kPoints; ++point) {
    const auto reached = std::lower_bound(recall.begin(), recall.end(), point * 0.01);
    if (reached != recall.end()) sum += precision[static_cast<size_t>(reached - recall.begin())];
  }
  return sum / kPoints;
}

DetectionScores ScoreDetections(const std::vector<JudgedPicture>& pictures, double confidence) {
  std::map<int, ClassHits> classes;
  for (const JudgedPicture& picture : pictures) {
    for (const JudgedBox& box : picture.truth) classes[box.label];
  }
  DetectionScores scores;
  double sum50 = 0, sum = 0;
  for (auto& [label, hits] : classes) {
    for (const JudgedPicture& picture : pictures) Judge(picture, label, hits);
    scores.classes.push_back(ScoreOf(label, hits, confidence));
    sum50 += scores.classes.back().ap50;
    sum += scores.classes.back().ap;
  }
  if (scores.classes.empty()) return scores;
  const auto count = static_cast<double>(scores.classes.size());
  scores.map50 = sum50 / count;
  scores.map50_95 = sum / count;
  return scores;
}

}  // namespace yorb
