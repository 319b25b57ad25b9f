// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/file_detector.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

#include "core/log.h"
#include "core/text.h"

namespace yorb {
namespace {

constexpr double kMostApart = 0.015;   // seconds between a box and its frame
constexpr double kMostStretch = 0.02;  // of one side against the other, as rounding leaves it

/// The frame nearest to a moment; nothing where none is near enough.
const Timestamp* NearestFrame(Timestamp time, const std::vector<Timestamp>& frames, double most_apart) {
  const auto after = std::lower_bound(frames.begin(), frames.end(), time);
  const Timestamp* nearest = nullptr;
  double least = most_apart + 1e-6;
  for (const auto candidate : {after, after == frames.begin() ? frames.end() : after - 1}) {
    if (candidate == frames.end()) continue;
    const double apart = std::abs(SecondsBetween(*candidate, time));
    if (apart < least) least = apart, nearest = &*candidate;
  }
  return nearest;
}

Error NoneFits(const BoxFile& file, const std::vector<Timestamp>& frames) {
  constexpr double kAnotherClockS = 1;  // by which a sensor's and a detector's stamps of one picture differ at most
  std::vector<Timestamp> times;
  double least = kAnotherClockS;
  for (const TimedBoxes& moment : file.moments) {
    times.push_back(moment.time);
    const Timestamp* nearest = NearestFrame(moment.time, frames, least);
    if (nearest != nullptr) least = std::min(least, std::abs(SecondsBetween(*nearest, moment.time)));
  }
  const bool is_near = least < kAnotherClockS;
  return BadInput(
      file.path + (is_near ? ": " : " belongs to another recording: ") + "none of its moments, " + RangeText(times) +
      ", is within 15 ms of a picture" + (frames.empty() ? "" : "; the pictures cover " + RangeText(frames)) +
      (is_near ? "; the nearest is " + FormatFixed(1000 * least, 0) + " ms away: give each box the stamp of its picture"
               : ""));
}

/// A box that stands there twice, as where files were joined, is one thing: two would share its points and its body.
/// Of equal ones the first stays.
void DropDoubles(std::vector<Box>& boxes) {
  const auto is_before = [](const Box* a, const Box* b) {
    return std::tie(a->left, a->top, a->right, a->bottom, a->name) <
           std::tie(b->left, b->top, b->right, b->bottom, b->name);
  };
  std::set<const Box*, decltype(is_before)> known(is_before);
  std::vector<Box> single;
  for (const Box& box : boxes) {
    if (known.insert(&box).second) single.push_back(box);
  }
  boxes = std::move(single);
}

}  // namespace

Result<std::unique_ptr<FileDetector>> FileDetector::Make(const BoxFile& file, const std::vector<Timestamp>& frames) {
  std::unique_ptr<FileDetector> detector(new FileDetector());
  detector->path_ = file.path;
  detector->rows_ = file.rows;
  detector->names_all_ = file.names_all;
  size_t num_matched = 0;
  for (const TimedBoxes& moment : file.moments) {
    const Timestamp* frame = NearestFrame(moment.time, frames, kMostApart);
    if (frame == nullptr) {
      detector->num_unmatched_ += moment.boxes.size();
      continue;
    }
    ++num_matched;
    detector->by_frame_[*frame].push_back(moment);
  }
  if (num_matched == 0 && !file.moments.empty()) return NoneFits(file, frames);
  if (detector->num_unmatched_ > 0) {
    LogWarning("boxes-unmatched", file.path + ": " + std::to_string(detector->num_unmatched_) +
                                      " boxes are farther than 15 ms from every picture and are left out");
  }
  if (const size_t num_dropped = file.num_dropped(); num_dropped > 0) {
    LogWarning("boxes-dropped", file.path + ": " + std::to_string(num_dropped) +
                                    " boxes are empty, swapped or no numbers and are left out");
  }
  return detector;
}

Status FileDetector::Scale(TimedBoxes& moment, int width, int height) {
  if (moment.width == 0 || (moment.width == width && moment.height == height)) return Status::Ok();
  const double x = static_cast<double>(width) / moment.width, y = static_cast<double>(height) / moment.height;
  const std::string sizes = path_ + ", " + rows_ + " " + std::to_string(moment.line) + ": boxes of a picture of " +
                            SizeText(moment.width, moment.height) + " pixels for one of " + SizeText(width, height);
  if (std::abs(x / y - 1) > kMostStretch)
    return BadInput(sizes + "; find them anew in these pictures, or leave width and height out of the file");
  if (!has_told_of_size_) LogWarning("boxes-scaled", sizes + "; such boxes are scaled");
  has_told_of_size_ = true;
  for (Box& box : moment.boxes) box.left *= x, box.right *= x, box.top *= y, box.bottom *= y;
  return Status::Ok();
}

Result<Detections> FileDetector::Detect(const ImageSet& images) {
  const auto found = by_frame_.find(images.timestamp);
  Detections detections;
  detections.has_looked = names_all_ || found != by_frame_.end();
  std::vector<Box> boxes;
  if (found == by_frame_.end()) {
    detections.says_nobody = detections.has_looked;
    return detections;
  }
  size_t num_dropped = 0;
  for (TimedBoxes moment : found->second) {
    num_dropped += moment.num_dropped;
    if (const Status scaled = Scale(moment, images.grey.cols, images.grey.rows); !scaled) return scaled.error();
    boxes.insert(boxes.end(), moment.boxes.begin(), moment.boxes.end());
  }
  std::stable_sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.confidence > b.confidence; });
  DropDoubles(boxes);
  detections.says_nobody = boxes.empty() && num_dropped == 0;
  for (const Box& whole : boxes) {
    const Box box = Cut(whole, images.grey.cols, images.grey.rows);
    if (HasArea(box)) {
      detections.boxes.push_back(box);
    } else if (!has_told_of_outside_) {
      has_told_of_outside_ = true;
      LogWarning("boxes-outside", path_ + ": a box for the picture of " + ToString(images.timestamp) +
                                      " lies outside of its " + SizeText(images.grey.cols, images.grey.rows) +
                                      " pixels; such boxes are left out (were they made on larger pictures?)");
    }
  }
  return detections;
}

}  // namespace yorb
