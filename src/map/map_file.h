// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/result.h"
#include "map/map.h"

namespace yorb {

// A map in one file: chunks (map/chunk_file.h) of little-endian numbers, each chunk with its own checksum.
//
//   "HEAD"  counts of what follows, the ids that come next, loops closed, name of the vocabulary
//   "CAMS"  cameras with their pyramids, each once, however many frames they took
//   "KEYF"  one a keyframe: pose, sub-map, tree, loops, frame with points and descriptors, which landmark each point
//   shows "GONE"  what is known of the keyframes that were removed: old poses stay answerable "LAND"  landmarks, some
//   thousand a chunk "ROOT"  the sub-maps in the order of the run's results; only where there are several
//
// Frames that were only tracked are not in it. Views of landmarks and neighbours of keyframes follow from the rest and
// are computed anew, and so are bags of words.

/// The version of the format that is written, and the only one that is read.
constexpr uint32_t kMapFileVersion = 1;

/// What is known of a map beside itself.
struct MapFacts {
  std::string vocabulary;              ///< that found its places, by name or digest; empty: none
  std::vector<KeyframeId> roots = {};  ///< of all sub-maps, in the order of the run that wrote them; empty: not known
};

/// A map from a file.
struct SavedMap {
  Map map;
  MapFacts facts;
  uint64_t num_bytes = 0;  ///< of the file
};

/// Reads a map, equal to the bit to the one that was written. Bad input names the file: missing, of another kind or
/// version, cut, changed, or holding what cannot be. Nothing is believed before its checksum and its limits were looked
/// at, and Map::Check() has the last word.
Result<SavedMap> ReadMapFile(const std::string& path);

/// The camera that a map's newest pictures were taken with, without reading the rest of the file. Bad input as there.
Result<Rig> ReadMapCamera(const std::string& path);

/// Writes a map whole or not at all: until then the old file stays as it is.
Status WriteMapFile(const std::string& path, const Map& map, const MapFacts& facts);

/// Whether a map may be written there: looked at before the work whose result it is. Bad input for a folder, or
/// what reads as one, a file that is no map or write-protected, and a place where no file can be made; else missing
/// folders are made.
Status CheckMapTarget(const std::string& path);

}  // namespace yorb
