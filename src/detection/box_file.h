// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/time.h"
#include "detection/box.h"

namespace yorb {

/// What a box file says of one moment.
struct TimedBoxes {
  Timestamp time;
  std::vector<Box> boxes;
  int line = 0;               ///< of the file, or which entry of a JSON list
  int width = 0, height = 0;  ///< of the picture that the boxes were found in, in pixels; 0: not said
  size_t num_dropped = 0;     ///< boxes that were empty, swapped or no numbers: somebody may have been meant
};

/// Boxes that were found before: by another program, or by whoever knows the truth.
struct BoxFile {
  std::string path;
  std::vector<TimedBoxes> moments;  ///< in the order of the file
  std::string rows = "line";        ///< what the moments stand in, for messages: "line", or "entry" of a JSON list
  bool names_all = false;           ///< a moment without a line has nobody in it (people.txt), else nobody looked

  size_t num_dropped() const;  ///< of all moments
};

/// Reads people.txt (`timestamp left top right bottom visible_px`, all persons), JSON lines or one JSON list of what
/// they hold, told apart by the first line. Bad input names file and line. JSON lines may say `width` and `height` of
/// their picture. Boxes that all look like fractions of the picture are bad input, too.
Result<BoxFile> ReadBoxFile(const std::string& path);

/// A moment as a JSON line, `{"timestamp": ..., "boxes": [...]}`, without a line end. `time`, `image`, `width` and
/// `height` stand in it where they are given.
struct BoxLine {
  std::optional<Timestamp> time;
  std::optional<std::string> image;
  std::optional<int> width, height;
};
std::string ToJsonLine(const BoxLine& about, const std::vector<Box>& boxes);

}  // namespace yorb
