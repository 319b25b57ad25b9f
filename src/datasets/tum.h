// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "camera/rig.h"
#include "core/result.h"
#include "datasets/dataset.h"
#include "datasets/picture_list.h"

namespace yorb {

/// The lists of a recording in TUM's layout, joined.
struct TumLists {
  std::string folder;
  PictureList colour, depth;
  std::vector<int> depth_of;    ///< for each colour picture its depth picture, or -1
  bool are_associated = false;  ///< read from associations.txt, which wins over rgb.txt and depth.txt

  size_t NumWithDepth() const;
};

/// The names that lists of TUM's layout go by.
std::vector<std::string> ListNames();

/// Whether a folder has lists of TUM's layout.
bool HasTumLayout(const std::string& folder);

/// Reads and joins the lists. Bad input where a list is wrong, and where no colour picture has a depth picture near.
Result<TumLists> ReadTumLists(const std::string& folder);

/// The colour pictures alone, as ReadTumLists takes them; depth need not be there.
Result<PictureList> ReadColourList(const std::string& folder);

/// Pictures that need neither depth nor order, for a camera that is only located: the lists of a recording, be it
/// without depth.txt; in a folder without lists the pictures in it, in the order of their names, a second apart.
Result<TumLists> ReadAnyPictures(const std::string& folder);

/// Bad input that names the first listed file that is not there, and counts the others.
Status LookForFiles(const TumLists& lists);

/// The first picture that can be decoded whole, and its index; bad input where there is none.
struct FirstPicture {
  size_t index = 0;
  cv::Mat pixels;
};
Result<FirstPicture> ReadFirstPicture(const std::vector<ListedPicture>& pictures);

/// Bad input where the colour picture of frame i is a depth picture that a list names as colour: 16-bit grey that is
/// named as depth, serves as depth, too, or has a colour picture for its depth.
Status CheckIsNoDepth(const TumLists& lists, size_t i, const cv::Mat& stored);

/// How many bits 16-bit colour pictures use, by a sample, so that all are scaled alike; 16 where they are 8-bit.
int UsedBits(const PictureList& colour);

/// What to say where a 16-bit depth picture meets a camera without a depth factor.
Error UnknownDepthFactor(const Rig& rig, const std::string& picture);

/// Makes the dataset. `rig` must fit the pictures; of 16-bit colour pictures so many bits count.
std::unique_ptr<Dataset> MakeTumDataset(TumLists lists, Rig rig, int colour_bits = 16);

}  // namespace yorb
