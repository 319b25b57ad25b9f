// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/files.h"
#include "core/result.h"
#include "map/map_file.h"
#include "runs/point_cloud.h"

namespace yorb {

/// What `yorb map info` says: a JSON object, or lines for people.
std::string MapInfoJson(const SavedMap& saved);
std::string MapInfoText(const std::string& path, const SavedMap& saved);

/// What a map is written out as, by the ending of the file's name.
enum class MapExport { kPly, kPcd, kKeyframes };

/// Bad input for an ending that is not known.
Result<MapExport> MapExportOf(const std::string& path);

/// The roots of the sub-maps in the order of the run's results, trajectory.txt and so on; where the file does not tell,
/// the one with most keyframes first.
std::vector<KeyframeId> RootsInOrder(const SavedMap& saved);

/// The landmarks of the map, or the poses of its keyframes as a TUM list by time. Each sub-map has a world of its own
/// and so a file of its own: X.ply, X_2.ply and so on.
std::vector<FileToWrite> ExportedFiles(const SavedMap& saved, const std::string& path, MapExport kind);

/// What a sub-map consists of, by which one can tell which it is: keyframes, landmarks, the time they cover.
std::string SubmapText(const Map& map, KeyframeId root);

/// A cloud in the bytes of its kind, which must be PLY or PCD.
std::string CloudBytes(const PointCloud& cloud, MapExport kind);

}  // namespace yorb
