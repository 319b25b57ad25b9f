// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/make_detector.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/log.h"
#include "detection/box_file.h"
#include "detection/file_detector.h"
#include "detection/motion_category.h"
#include "detection/yolo_detector.h"
#include "runs/find_vocabulary.h"
#include "runs/run_map.h"

namespace yorb {
namespace {

/// Unknown names are static; a user who wrote them should hear of it, once.
void WarnOfUnknownNames(const BoxFile& file, const MotionTable& motions) {
  std::set<std::string> unknown;
  for (const TimedBoxes& moment : file.moments) {
    for (const Box& box : moment.boxes) {
      if (!motions.Knows(box.name)) unknown.insert(box.name);
    }
  }
  if (unknown.empty()) return;
  constexpr size_t kMostNamed = 10;
  std::string names;
  size_t num_named = 0;
  for (const std::string& name : unknown) {
    if (num_named++ == kMostNamed) break;
    names += (names.empty() ? "'" : ", '") + name + "'";
  }
  if (unknown.size() > kMostNamed) names += " and " + std::to_string(unknown.size() - kMostNamed) + " more";
  LogWarning("boxes-unknown", file.path + ": no motion is known of the class " + names +
                                  "; it counts as static (models/classes.txt has the table)");
}

Status TakeFile(const Config& config, const Dataset& dataset, RunParts& parts) {
  const auto file = ReadBoxFile(config.detections);
  if (!file) return file.error();
  WarnOfUnknownNames(*file, parts.slam.motions);
  std::vector<Timestamp> frames;
  for (size_t i = 0; i < dataset.size(); ++i) frames.push_back(dataset.TimeOf(i));
  auto detector = FileDetector::Make(*file, frames);
  if (!detector) return detector.error();
  parts.num_boxes_unmatched = (*detector)->num_unmatched();
  parts.slam.detector = *std::move(detector);
  return Status::Ok();
}

Status TakeNetwork(const Config& config, RunParts& parts) {
  DetectionOptions options = config.detection;
  parts.sure_confidence = SureConfidence(config);
  if (config.dynamics == "full") options.confidence = std::min(options.confidence, options.faint_confidence);
  auto detector = YoloDetector::Open(options);
  if (!detector)
    return BadInput(detector.error().message + (options.model.empty() ? "; --dynamics off needs none" : ""));
  const std::vector<std::string>& names = (*detector)->names();
  const auto moves = [&](const std::string& name) { return parts.slam.motions.Of(name) == Motion::kHigh; };
  if (std::none_of(names.begin(), names.end(), moves)) {
    LogWarning("network-sees-nobody", "none of the network's " + std::to_string(names.size()) +
                                          " classes moves by itself, so that nothing will be removed");
  }
  parts.slam.detector = *std::move(detector);
  return Status::Ok();
}

/// A network that was named in vain is worth a word, and one that is not there an end.
Status CheckModelIsUsed(const Config& config) {
  const std::string& model = config.detection.model;
  if (model.empty() || (config.dynamics != "off" && config.detections.empty())) return Status::Ok();
  std::error_code ignored;
  if (!std::filesystem::exists(model, ignored)) return BadInput(model + " (the network to use) does not exist");
  LogWarning("model-unused", model + " is not used: " +
                                 (config.dynamics == "off" ? "nothing is removed with --dynamics off"
                                                           : "the boxes come from " + config.detections));
  return Status::Ok();
}

Status TakeDetector(const Config& config, const Dataset& dataset, RunParts& parts) {
  if (const Status fine = CheckModelIsUsed(config); !fine) return fine;
  if (config.dynamics == "off") {
    if (config.detections.empty()) return Status::Ok();
    if (const auto file = ReadBoxFile(config.detections); !file) return file.error();
    LogWarning("boxes-unused",
               config.detections + " is not used: nothing is removed with --dynamics off; give full or paper");
    return Status::Ok();
  }
  if (config.dynamics == "exact" && config.detections.empty()) {
    return BadInput("--dynamics exact needs boxes: name their file with --detections");
  }
  auto motions = InstalledMotionTable();
  if (!motions) return motions.error();
  parts.slam.motions = *std::move(motions);
  return config.detections.empty() ? TakeNetwork(config, parts) : TakeFile(config, dataset, parts);
}

}  // namespace

Result<RunParts> MakeParts(const Config& config, const Dataset& dataset) {
  RunParts parts;
  auto vocabulary = FindVocabulary(config.places);
  if (!vocabulary) return vocabulary.error();
  parts.slam.vocabulary = *std::move(vocabulary);
  if (const Status taken = TakeDetector(config, dataset, parts); !taken) return taken.error();
  auto map = LoadRunMap(config, dataset.rig());
  if (!map) return map.error();
  parts.slam.map = *std::move(map);
  return parts;
}

}  // namespace yorb
