// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "core/result.h"
#include "datasets/dataset.h"

namespace yorb {

/// What is asked of a folder.
enum class Layout {
  kRecording,    ///< lists of colour and depth pictures in the order of time
  kAnyPictures,  ///< pictures with or without depth and lists (`ReadAnyPictures`): a camera is only located in them
};

/// Opens a recording: finds out its layout, reads its lists, looks for every listed file, and fits the camera to the
/// first picture. `camera` is a built-in name or a file; empty: only where the folder says which camera it is (a
/// camera.yaml in it, or one of TUM's own folder names), else bad input that names --camera.
Result<std::unique_ptr<Dataset>> OpenDataset(const std::string& folder, const std::string& camera,
                                             Layout layout = Layout::kRecording);

/// The built-in camera that a folder's own name stands for (`rgbd_dataset_freiburg1_xyz` is tum_fr1); empty if none.
std::string CameraOfFolderName(const std::string& folder);

/// In words, that the folder's name says one camera and another is used, the classic mistake of a copied command line;
/// empty where their focal lengths are alike, as those of two calibrations of one camera are.
std::string UnlikeFolderName(const std::string& folder, const Rig& rig);

/// The camera of a recording as its file has it, and how it was chosen.
struct ChosenCamera {
  Rig rig;
  std::string how;        ///< "as given", "the folder's camera.yaml", "by the folder's name", "of the map FILE"
  bool is_given = false;  ///< for these pictures: by the user or a file in the folder, not by a name or a map alone
};
Result<ChosenCamera> ChooseCamera(const std::string& folder, const std::string& camera);

/// Whether a folder says by itself which camera took it.
bool ShowsItsCamera(const std::string& folder);

/// The camera for pictures of this size; warns where it had to be scaled. One that was not given for them
/// must fit as it is.
Result<Rig> FitChosenCamera(const ChosenCamera& chosen, int width, int height);

/// OpenDataset with a camera that is chosen already.
Result<std::unique_ptr<Dataset>> OpenDataset(const std::string& folder, const ChosenCamera& chosen,
                                             Layout layout = Layout::kRecording);

/// Bad input unless the folder is one and has a layout that is read; the complaint says what it looks like.
Status CheckLayout(const std::string& folder, Layout layout = Layout::kRecording);

}  // namespace yorb
