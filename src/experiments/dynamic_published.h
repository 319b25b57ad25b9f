// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace yorb {

/// A figure that the authors of a system published; not measured here.
struct PublishedFigure {
  std::string system;
  double value = 0;
  std::string note;  ///< where it ran, and the like; may be empty
};

/// ATE RMSE in metres on a sequence of TUM's that has people, by its folder's name
/// (`rgbd_dataset_freiburg3_walking_xyz`, or `fr3_walking_xyz`); none for other sequences.
std::vector<PublishedFigure> PublishedErrors(const std::string& sequence);

/// Milliseconds a frame on TUM's sequences with people, each on the hardware of its authors.
std::vector<PublishedFigure> PublishedTimes();

/// In % against ORB-SLAM2, averaged over the sequences in which people walk, or sit: the paper's own figures.
struct PublishedReduction {
  std::string sequences;
  double rmse = 0, mean = 0, std = 0;
};
std::vector<PublishedReduction> PublishedReductions();

}  // namespace yorb
