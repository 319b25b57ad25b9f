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

/// What the numbers of label files mean.
struct LabelForm {
  std::vector<std::string> classes;  ///< by number; empty text: no class has this number
  size_t num_keypoint_numbers = 0;   ///< that follow each box, where a data.yaml states a kpt_shape
};

/// Pictures with true boxes in YOLO's layout: pictures anywhere under DIR/images, and at the same place under
/// DIR/labels a text file each, with lines `class x y width height` or polygons `class x1 y1 x2 y2 x3 y3 ...`.
struct LabelledSet {
  std::string folder;
  std::vector<std::string> classes;  ///< empty text: no class has this number
  std::vector<LabelledPicture> pictures;
};

/// Reads DIR/images/SET (empty: all of DIR/images). A picture whose label file is empty or missing has nothing in it;
/// label files that belong to no picture are told of in one warning; bad input names file and line.
Result<LabelledSet> ReadLabelledSet(const std::string& folder, const std::string& set);

/// The boxes of one label file.
Result<std::vector<LabelledBox>> ReadLabelFile(const std::string& path, const LabelForm& form);

/// From DIR/classes.txt, DIR/data.yaml, DIR/labels/classes.txt, DIR/labels/SET/classes.txt or the data.yaml of the
/// folder above, the first that is there; else from the one list in DIR that has another name (coco128.yaml,
/// obj.names); else the classes are COCO's, with a warning.
Result<LabelForm> ReadLabelForm(const std::string& folder, const std::string& set);

}  // namespace yorb
