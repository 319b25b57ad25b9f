// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/map_export.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "geometry/trajectory.h"
#include "runs/run_folder.h"

namespace yorb {
namespace {

std::string CameraOf(const Map& map) {
  std::string name;
  bool is_first = true;
  map.VisitKeyframes([&](const Keyframe& keyframe) {
    if (is_first) name = keyframe.frame->rig->name;
    is_first = false;
  });
  return name;
}

nlohmann::ordered_json TextOrNull(const std::string& text) {
  return text.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(text);
}

/// By time: a map that was gone on with may hold keyframes of an earlier one later.
Trajectory KeyframesOf(const Map& map, KeyframeId root) {
  Trajectory poses;
  map.VisitKeyframes([&](const Keyframe& keyframe) {
    if (keyframe.root == root) poses.push_back({keyframe.frame->timestamp, keyframe.cam_from_world.Inverse()});
  });
  std::stable_sort(poses.begin(), poses.end(),
                   [](const StampedPose& a, const StampedPose& b) { return a.timestamp < b.timestamp; });
  return poses;
}

PointCloud LandmarksOf(const Map& map, KeyframeId root) {
  PointCloud cloud;
  map.VisitLandmarks([&](const Landmark& landmark) {
    if (map.Find(landmark.reference)->root == root) cloud.points.push_back(landmark.position);
  });
  return cloud;
}

}  // namespace

std::string MapInfoJson(const SavedMap& saved) {
  const nlohmann::ordered_json json = {{"version", kMapFileVersion},
                                       {"keyframes", saved.map.num_keyframes()},
                                       {"landmarks", saved.map.num_landmarks()},
                                       {"submaps", RootsInOrder(saved).size()},
                                       {"loops", saved.map.num_loops()},
                                       {"camera", TextOrNull(CameraOf(saved.map))},
                                       {"vocabulary", TextOrNull(saved.facts.vocabulary)},
                                       {"bytes", saved.num_bytes}};
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string MapInfoText(const std::string& path, const SavedMap& saved) {
  const Map& map = saved.map;
  const auto row = [](const char* name, const std::string& value) {
    return "  " + std::string(name) + std::string(14 - std::string(name).size(), ' ') + value + "\n";
  };
  return path + ": a map of version " + std::to_string(kMapFileVersion) + "\n" +
         row("keyframes", std::to_string(map.num_keyframes())) + row("landmarks", std::to_string(map.num_landmarks())) +
         row("sub-maps", std::to_string(RootsInOrder(saved).size())) + row("loops", std::to_string(map.num_loops())) +
         row("camera", CameraOf(map)) +
         row("vocabulary", saved.facts.vocabulary.empty() ? "none" : saved.facts.vocabulary) +
         row("bytes", std::to_string(saved.num_bytes));
}

Result<MapExport> MapExportOf(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending == ".ply") return MapExport::kPly;
  if (ending == ".pcd") return MapExport::kPcd;
  if (ending == ".txt") return MapExport::kKeyframes;
  const std::string what = ending.empty() ? "no ending" : "the ending " + ending + ", which is not known";
  return BadInput(path + " has " + what + "; .ply and .pcd give the points, .txt the keyframes as a TUM list");
}

std::vector<KeyframeId> RootsInOrder(const SavedMap& saved) {
  if (!saved.facts.roots.empty()) return saved.facts.roots;
  std::map<uint32_t, size_t> sizes;
  saved.map.VisitKeyframes([&](const Keyframe& keyframe) { ++sizes[keyframe.root.value()]; });
  std::vector<KeyframeId> roots;
  for (const auto& [root, size] : sizes) roots.emplace_back(root);
  std::stable_sort(roots.begin(), roots.end(),
                   [&](KeyframeId a, KeyframeId b) { return sizes[a.value()] > sizes[b.value()]; });
  return roots;
}

std::vector<FileToWrite> ExportedFiles(const SavedMap& saved, const std::string& path, MapExport kind) {
  std::vector<FileToWrite> files;
  for (const KeyframeId root : RootsInOrder(saved)) {
    const std::string content = kind == MapExport::kKeyframes ? TumText(KeyframesOf(saved.map, root))
                                                              : CloudBytes(LandmarksOf(saved.map, root), kind);
    files.push_back({NumberedPath(path, files.size() + 1), content});
  }
  return files;
}

std::string SubmapText(const Map& map, KeyframeId root) {
  const Trajectory keyframes = KeyframesOf(map, root);
  return std::to_string(keyframes.size()) + (keyframes.size() == 1 ? " keyframe, " : " keyframes, ") +
         std::to_string(LandmarksOf(map, root).points.size()) + " landmarks, from " +
         ToString(keyframes.front().timestamp) + " to " + ToString(keyframes.back().timestamp) + " s";
}

std::string CloudBytes(const PointCloud& cloud, MapExport kind) {
  return kind == MapExport::kPcd ? PcdBytes(cloud) : PlyBytes(cloud);
}

}  // namespace yorb
