// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "core/text.h"
#include "core/time.h"

namespace yorb {

/// One picture that a list names.
struct ListedPicture {
  Timestamp time;
  std::string name;  ///< as the list has it, without quotes
  std::string path;  ///< where it lies: relative names are relative to the list's folder
  int line = 0;      ///< of the list; 0: in a folder without one
};

/// The pictures of one list, in the order of the list.
struct PictureList {
  std::string file;
  std::vector<ListedPicture> pictures;

  std::vector<Timestamp> Times() const;
};

/// Reads `timestamp file` lines: rgb.txt, depth.txt. Separators may be blanks, tabs or a comma; names may hold blanks
/// and stand in quotes. Bad input names file and line.
Result<PictureList> ReadPictureList(const std::string& path);

/// Bad input where stamps go back or repeat (with file and line), or count something else than seconds; a warning where
/// they may.
Status CheckStamps(const PictureList& list);

/// What speaks for stamps that count frames: steps of half a second and more; empty where nothing does.
std::string StrangeStamps(const PictureList& list);

/// Reads a time stamp of a list line; the complaint tells counts of nanoseconds and decimal commas from rubbish.
Result<Timestamp> ReadStamp(std::string_view text, const std::string& where);

/// The file that a list in `folder` means: without quotes, absolute or relative to the folder. What follows a blank is
/// part of the name only if such a file is there.
ListedPicture LocatePicture(const std::string& folder, std::string_view text);

}  // namespace yorb
