// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/result.h"

namespace yorb {

/// A picture and where its labels stand.
struct LabelledFile {
  std::string picture;
  std::string labels;  ///< YOLO text, or Pascal VOC where it ends with .xml; it need not exist
  std::string name;    ///< of the picture, without folder and ending
};

/// All pictures under a folder, sorted. The labels of DIR/images/A/B.jpg are DIR/labels/A/B.txt; where the path has no
/// folder "images", they stand beside the picture, as LabelImg writes them (.txt or .xml). Bad input when the folder is
/// missing or has no picture.
Result<std::vector<LabelledFile>> FindLabelledFiles(const std::string& folder);

/// DIR/FOLDER/A/B.ending for a picture DIR/images/A/B.jpg; nothing where the path has no folder "images".
std::optional<std::string> FileBeside(const std::string& picture, const std::string& folder, const std::string& ending);

/// The list of classes that belongs to a folder of pictures: classes.txt in it, or in one of the folders around it.
Result<std::string> FindClassList(const std::string& folder);

}  // namespace yorb
