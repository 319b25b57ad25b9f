// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/detector_people.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "core/files.h"
#include "core/iou.h"
#include "core/text.h"
#include "detection/class_names.h"
#include "runs/picture_source.h"

namespace yorb {
namespace {

constexpr double kLeastOverlap = 0.5;

/// The person that a box lies on and that no stronger box has taken; nothing where there is none.
int BestFree(const Box& box, const std::vector<TruePerson>& people, const std::vector<bool>& is_taken) {
  int best = -1;
  double most = kLeastOverlap;
  for (size_t i = 0; i < people.size(); ++i) {
    const double overlap = is_taken[i] ? 0 : IoU(box, people[i].box);
    if (overlap < most) continue;
    most = overlap;
    best = static_cast<int>(i);
  }
  return best;
}

}  // namespace

Result<std::vector<TruePerson>> ReadTruePeople(const std::string& path) {
  const auto file = ReadTextFile(path);
  if (!file) return file.error();
  std::vector<TruePerson> people;
  for (const TextLine& line : file->lines) {
    const auto words = SplitAtBlanks(line.text);
    const auto time = ParseTimestamp(words.front());
    std::vector<double> n;
    for (size_t i = 1; i < words.size(); ++i) n.push_back(ParseDouble(words[i]).value_or(std::nan("")));
    const bool is_sound =
        time && n.size() == 5 && std::all_of(n.begin(), n.end(), [](double value) { return std::isfinite(value); });
    if (!is_sound) return BadInput(file->Where(line) + ": a line is 'timestamp left top right bottom visible_px'");
    people.push_back({*time, Box{"person", 1, n[0], n[1], n[2], n[3]}, n[4]});
  }
  return people;
}

bool MustBeFound(const TruePerson& person, int width, int height) {
  constexpr double kLeastOfPicture = 0.02, kLeastBody = 0.35;
  const double area = person.box.width() * person.box.height();
  return area >= kLeastOfPicture * width * height && person.visible_px >= kLeastBody * area;
}

PeopleScore ScorePeople(const std::vector<Box>& found, const std::vector<TruePerson>& people, const cv::Size& size) {
  PeopleScore score;
  score.num_pictures = 1;
  std::vector<bool> is_taken(people.size(), false);
  for (const Box& box : found) {
    if (FoldClassName(box.name) != "person") continue;
    const int best = BestFree(box, people, is_taken);
    if (best >= 0) {
      is_taken[static_cast<size_t>(best)] = true;
    } else {
      ++score.num_false;
    }
  }
  for (size_t i = 0; i < people.size(); ++i) {
    if (!MustBeFound(people[i], size.width, size.height)) continue;
    ++score.num_true;
    score.num_found += is_taken[i] ? 1 : 0;
  }
  return score;
}

Result<PeopleScore> MeasurePeople(const std::string& sequence, Detector& detector,
                                  const std::function<bool()>& should_stop) {
  const auto people = ReadTruePeople((std::filesystem::path(sequence) / "people.txt").string());
  if (!people) return people.error();
  std::map<Timestamp, std::vector<TruePerson>> by_time;
  for (const TruePerson& person : *people) by_time[person.time].push_back(person);
  const auto source = OpenPictureSource(sequence);
  if (!source) return source.error();
  PeopleScore sum;
  sum.sequence = OwnName(sequence);
  while ((*source)->HasNext() && !(should_stop && should_stop())) {
    const auto picture = (*source)->Next();
    if (!picture) {
      sum.unreadable.Add(picture.error());
      continue;
    }
    if (!picture->time) return BadInput(sequence + " is no sequence with time stamps, which people.txt refers to");
    const auto detections = detector.Detect(ImageSetOf(picture->pixels));
    if (!detections) return detections.error();
    const PeopleScore one = ScorePeople(detections->boxes, by_time[*picture->time], picture->pixels.size());
    sum.num_pictures += one.num_pictures, sum.num_true += one.num_true;
    sum.num_found += one.num_found, sum.num_false += one.num_false;
  }
  return sum;
}

}  // namespace yorb
