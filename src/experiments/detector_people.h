// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/time.h"
#include "detection/detector.h"
#include "runs/unreadable.h"

namespace yorb {

/// A person in people.txt, with what is visible of them.
struct TruePerson {
  Timestamp time;
  Box box;
  double visible_px = 0;
};

/// Reads `timestamp left top right bottom visible_px`.
Result<std::vector<TruePerson>> ReadTruePeople(const std::string& path);

/// Whom a detector must find: boxes of at least 2 % of the picture, at least 35 % of them body.
bool MustBeFound(const TruePerson& person, int width, int height);

/// How people whose places are known are found in a sequence.
struct PeopleScore {
  std::string sequence;
  size_t num_pictures = 0;
  size_t num_true = 0, num_found = 0;  ///< of those who must be found, at an overlap of .5
  size_t num_false = 0;                ///< boxes of persons that lie on none of all people in people.txt
  Unreadable unreadable;               ///< pictures that are left out

  double recall() const { return num_true == 0 ? 0 : static_cast<double>(num_found) / static_cast<double>(num_true); }
};

/// One picture: by falling confidence each box of a person takes the best free person that it overlaps by half.
PeopleScore ScorePeople(const std::vector<Box>& found, const std::vector<TruePerson>& people, const cv::Size& size);

/// Lets a detector see every picture of a sequence with a people.txt.
Result<PeopleScore> MeasurePeople(const std::string& sequence, Detector& detector,
                                  const std::function<bool()>& should_stop);

}  // namespace yorb
