// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace yorb {

/// All pictures in a folder and the folders below it, by the endings of their names, in the order of their names,
/// in which numbers count by their value: 2.png comes before 10.png. Linked folders are followed, each place once;
/// hidden files and folders are passed over.
std::vector<std::string> PicturesUnder(const std::string& folder);

/// The same of videos.
std::vector<std::string> VideosUnder(const std::string& folder);

/// The pictures of the folder itself, without those below it.
std::vector<std::string> PicturesIn(const std::string& folder);

}  // namespace yorb
