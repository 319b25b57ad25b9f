// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "camera/rig.h"
#include "core/result.h"
#include "map/map_file.h"
#include "places/vocabulary.h"
#include "system/config.h"

namespace yorb {

/// Bad input where what is asked of maps cannot be done: `localize_only` without a map, nothing to save, no place to
/// save it to. Looked at before any work.
Status CheckMapOptions(const Config& config, const std::string& save_map);

/// Reads the map that the configuration names; null where it names none. Warns where it was made with another camera.
Result<MapSnapshot> LoadRunMap(const Config& config, const Rig& rig);

/// Writes a map, with the digest of the vocabulary (which may be null) that found its places, and the order of its
/// sub-maps; false, with a warning, where it is empty: then nothing is written.
Result<bool> SaveRunMap(const std::string& path, const Map& map, const Vocabulary* vocabulary,
                        const std::vector<KeyframeId>& roots);

}  // namespace yorb
