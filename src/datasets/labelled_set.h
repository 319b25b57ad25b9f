// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/result.h"

namespace yorb {

/// A true box in fractions of the picture, 0 to 1.
struct LabelledBox {
  int label = 0;  ///< number in the set's list of classes
  double left = 0, top = 0, right = 0, bottom = 0;
};

/// One picture and what is in it.
struct LabelledPicture {
  std::string picture;
  std::vector<LabelledBox> boxes;
};

/// Pictures with true boxes in YOLO's layout: pictures anywhere under DIR/images, and at the same place under
/// DIR/labels a text file each, with lines `class x y width height` or polygons `class x1 y1 x2 y2 x3 y3 ...`.
struct LabelledSet {
  std::string folder;
  std::vector<std::string> classes;  ///< empty text: no class has this number
  std::vector<LabelledPicture> pictures;
};

/// Reads DIR/images/SET (empty: all of DIR/images). Class names stand in DIR/classes.txt,
/// DIR/data.yaml or DIR/labels/classes.txt, or are COCO's, with a warning.
/// A picture whose label file is empty or missing has nothing in it; bad input names file and line.
Result<LabelledSet> ReadLabelledSet(const std::string& folder, const std::string& set);

/// The boxes of one label file.
Result<std::vector<LabelledBox>> ReadLabelFile(const std::string& path, const std::vector<std::string>& classes);

/// The classes of a set, by number.
Result<std::vector<std::string>> ReadClassList(const std::string& folder);

}  // namespace yorb
