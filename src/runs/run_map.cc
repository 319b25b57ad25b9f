// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/run_map.h"

#include <memory>
#include <utility>

#include "core/log.h"
#include "core/text.h"
#include "system/slam.h"

namespace yorb {
namespace {

std::string CountsOf(const Map& map) {
  return std::to_string(map.num_keyframes()) + " keyframes, " + std::to_string(map.num_landmarks()) + " landmarks";
}

void WarnOfOtherCamera(const std::string& path, const Map& map, const Rig& rig) {
  std::string other;
  map.VisitKeyframes([&](const Keyframe& keyframe) {
    if (!keyframe.frame->rig->ProjectsLike(rig)) other = keyframe.frame->rig->name;
  });
  if (other.empty()) return;
  LogWarning("map-camera", path + " was made with the camera " + other + "; these pictures are taken as those of " +
                               rig.name + ", which has other numbers");
}

}  // namespace

Status CheckMapOptions(const Config& config, const std::string& save_map) {
  if (config.localize_only && config.load_map.empty()) {
    return BadInput("--localize-only needs a map; name its file with --load-map");
  }
  if (save_map.empty()) return Status::Ok();
  if (config.localize_only) {
    return BadInput(
        "--save-map with --localize-only: the map stays as it is, so that there is nothing to save; leave "
        "one of them out");
  }
  return CheckMapTarget(save_map);
}

Result<MapSnapshot> LoadRunMap(const Config& config, const Rig& rig) {
  if (config.load_map.empty()) return MapSnapshot();
  auto saved = ReadMapFile(config.load_map);
  if (!saved) return saved.error();
  if (saved->map.num_keyframes() == 0) return BadInput(config.load_map + " holds no keyframe; make the map anew");
  const Status fits = Slam::CheckMap(config, saved->map, rig);
  if (!fits) return fits.error();
  LogInfo("map " + config.load_map + ": " + CountsOf(saved->map));
  if (config.localize_only) WarnOfOtherCamera(config.load_map, saved->map, rig);
  return MapSnapshot(std::make_shared<const Map>(std::move(saved->map)));
}

Result<bool> SaveRunMap(const std::string& path, const Map& map, const Vocabulary* vocabulary,
                        const std::vector<KeyframeId>& roots) {
  if (map.num_keyframes() == 0) {
    LogWarning("map-empty", path + " was not written: there is no map");
    return false;
  }
  const Status written = WriteMapFile(path, map, {vocabulary ? HexText(vocabulary->digest()) : "", roots});
  if (!written) return written.error();
  LogInfo("map in " + path + ": " + CountsOf(map));
  return true;
}

}  // namespace yorb
