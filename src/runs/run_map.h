// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "camera/rig.h"
#include "core/result.h"
#include "map/map_file.h"
#include "system/config.h"

namespace yorb {

/// The map that a run begins with.
struct RunMap {
  MapSnapshot map;  ///< null: a new one is begun
  MapFacts facts;
};

/// Bad input where what is asked of maps cannot be done: `localize_only` without a map, nothing to save, no place to
/// save it to. Looked at before any work.
Status CheckMapOptions(const Config& config, const std::string& save_map);

/// Reads the map that the configuration names; none where it names none. Warns where it was made with another camera.
Result<RunMap> LoadRunMap(const Config& config, const Rig& rig);

/// Writes a map; false, with a warning, where it is empty: then nothing is written.
Result<bool> SaveRunMap(const std::string& path, const Map& map, const MapFacts& facts);

}  // namespace yorb
