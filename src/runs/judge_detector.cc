// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/judge_detector.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "core/log.h"
#include "core/stats.h"
#include "core/stopwatch.h"
#include "core/text.h"
#include "detection/class_names.h"
#include "pictures/still_picture.h"

namespace yorb {
namespace {

using Json = nlohmann::ordered_json;

/// The numbers of a set's classes by folded name; those that are alike count as the first of them.
std::map<std::string, int> NumbersByName(const LabelledSet& set) {
  std::map<std::string, int> numbers;
  for (size_t i = 0; i < set.classes.size(); ++i) {
    const auto [known, is_new] = numbers.emplace(FoldClassName(set.classes[i]), static_cast<int>(i));
    if (is_new || set.classes[i].empty()) continue;
    const auto first = static_cast<size_t>(known->second);
    LogWarning("classes-alike", set.folder + ": its classes " + std::to_string(first) + " ('" + set.classes[first] +
                                    "') and " + std::to_string(i) + " ('" + set.classes[i] +
                                    "') have one name and count as one; case, blanks and underscores do not matter");
  }
  return numbers;
}

JudgedBox TruthOf(const LabelledBox& box, int label, const cv::Size& size) {
  return {label, 1, box.left * size.width, box.top * size.height, box.right * size.width, box.bottom * size.height};
}

bool IsWanted(const std::string& name, const std::vector<std::string>& wanted) {
  const auto is_same = [&](const std::string& word) { return FoldClassName(word) == FoldClassName(name); };
  return wanted.empty() || std::any_of(wanted.begin(), wanted.end(), is_same);
}

/// Columns of equal width.
std::string Row(const std::string& name, const std::vector<std::string>& cells) {
  std::string row = name;
  row.resize(std::max<size_t>(name.size() + 1, 20), ' ');
  for (const std::string& cell : cells) row += std::string(cell.size() < 10 ? 10 - cell.size() : 1, ' ') + cell;
  return row + "\n";
}

std::string Share(const std::optional<double>& value) { return value ? FormatFixed(*value, 3) : "-"; }

Json OrNull(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

/// A few of many names, for a complaint.
std::string SomeOf(const std::set<std::string>& names) {
  constexpr size_t kMost = 5;
  std::string text;
  size_t count = 0;
  for (const std::string& name : names) {
    if (count++ < kMost) text += (text.empty() ? "'" : ", '") + name + "'";
  }
  return text + (count > kMost ? " and " + std::to_string(count - kMost) + " more" : "");
}

/// Classes go by name, so that a set and a network that name them otherwise have nothing in common.
void WarnOfNames(const LabelledSet& set, const std::set<std::string>& unknown) {
  std::set<std::string> names(set.classes.begin(), set.classes.end());
  names.erase("");
  LogWarning("no-class-in-common", set.folder +
                                       ": no box that was found has a name of the set's, so that all scores are 0: the "
                                       "network has " +
                                       SomeOf(unknown) + ", the set " + SomeOf(names) +
                                       "; name them alike in the set's list of classes");
}

}  // namespace

Result<DetectorJudgement> JudgeDetector(const LabelledSet& set, Detector& detector, const JudgeOptions& options) {
  const std::map<std::string, int> numbers = NumbersByName(set);
  std::vector<JudgedPicture> pictures;
  std::vector<double> times_ms;
  std::set<std::string> unknown;
  bool has_known = false;
  Unreadable unreadable;
  for (const LabelledPicture& labelled : set.pictures) {
    if (options.should_stop && options.should_stop()) break;
    const auto pixels = ReadUprightPicture(labelled.picture);
    if (!pixels) {
      unreadable.Add(pixels.error());
      continue;
    }
    const ImageSet images = ImageSetOf(*pixels);
    const Stopwatch watch;
    const auto detections = detector.Detect(images);
    times_ms.push_back(watch.ms());
    if (!detections) return detections.error();
    JudgedPicture picture;
    for (const LabelledBox& box : labelled.boxes) {
      const std::string& name = set.classes[static_cast<size_t>(box.label)];
      if (!IsWanted(name, options.classes)) continue;
      picture.truth.push_back(TruthOf(box, numbers.at(FoldClassName(name)), pixels->size()));
    }
    for (const Box& box : detections->boxes) {
      const auto number = numbers.find(FoldClassName(box.name));
      if (number == numbers.end()) unknown.insert(box.name);
      if (number == numbers.end()) continue;
      has_known = true;
      picture.found.push_back({number->second, box.confidence, box.left, box.top, box.right, box.bottom});
    }
    pictures.push_back(std::move(picture));
  }
  if (!has_known && !unknown.empty()) WarnOfNames(set, unknown);
  return DetectorJudgement{ScoreDetections(pictures, options.confidence),
                           set.classes,
                           Summarize(times_ms).median,
                           options.confidence,
                           pictures.size(),
                           std::move(unreadable)};
}

std::string JudgementText(const DetectorJudgement& judgement) {
  std::string text = Row("class", {"truth", "AP50", "AP50-95", "precision", "recall"});
  for (const ClassScore& score : judgement.scores.classes) {
    text += Row(judgement.classes[static_cast<size_t>(score.label)],
                {std::to_string(score.num_true), Share(score.ap50), Share(score.ap), Share(score.precision),
                 Share(score.recall)});
  }
  text += Row("mean", {"", Share(judgement.scores.map50), Share(judgement.scores.map50_95)});
  return text + std::to_string(judgement.num_pictures) + " pictures, " + FormatFixed(judgement.latency_ms, 1) +
         " ms a picture (median); precision and recall at confidence " + FormatShortest(judgement.confidence) + "\n";
}

std::string JudgementJson(const DetectorJudgement& judgement) {
  Json classes = Json::array();
  for (const ClassScore& score : judgement.scores.classes) {
    classes.push_back({{"name", judgement.classes[static_cast<size_t>(score.label)]},
                       {"ap50", score.ap50},
                       {"ap", score.ap},
                       {"precision", OrNull(score.precision)},
                       {"recall", score.recall},
                       {"truth", score.num_true}});
  }
  const Json json{{"classes", classes},
                  {"map50", OrNull(judgement.scores.map50)},
                  {"map50_95", OrNull(judgement.scores.map50_95)},
                  {"latency_ms", judgement.num_pictures > 0 ? Json(judgement.latency_ms) : Json(nullptr)},
                  {"confidence", judgement.confidence}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace yorb
