// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/result.h"
#include "training/labels.h"
#include "training/pack.h"
#include "training/people_masks.h"

namespace yorb {

/// A picture whose people are known by boxes: where there is none, there is nobody.
struct PlainScene {
  std::shared_ptr<const Pack> pack;  ///< null: the picture is a file
  size_t index = 0;                  ///< in the pack
  std::string file;
  std::vector<LabelBox> people;
};

/// Pictures to learn from where nobody is.
struct PlainScenes {
  std::vector<PlainScene> empty;    ///< nobody in them: people can be pasted
  std::vector<PlainScene> peopled;  ///< with people in boxes
};

/// Scenes of packs, or of folders of labelled pictures (YOLO text; the class is called person in their classes.txt).
/// What boxes of a teacher say counts, too: those of DIR/labels_teacher/A for DIR/images/A, those that a pack holds as
/// doubtful. Pictures with nothing but such boxes, or that are not judged for people, are left out.
Result<PlainScenes> FindPlainScenes(const std::vector<std::string>& paths);

/// Its picture; the mask says that nobody is outside of the boxes, and nothing of what is within.
Result<MaskedPicture> ReadPlainScene(const PlainScene& scene);

}  // namespace yorb
