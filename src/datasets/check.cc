// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/check.h"

#include <algorithm>
#include <filesystem>

#include "core/stats.h"
#include "core/text.h"
#include "datasets/associate.h"
#include "datasets/depth_watch.h"
#include "datasets/open_dataset.h"
#include "datasets/tum.h"
#include "pictures/picture_file.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

constexpr size_t kSamples = 20;      // pictures looked into, spread over the recording
constexpr double kLongGap = 0.5;     // seconds without a colour picture
constexpr double kManyHoles = 0.5;   // share of pixels without depth
constexpr double kFewTruths = 0.5;   // share of colour pictures with a true pose
constexpr double kTruthNear = 0.02;  // seconds
constexpr double kAllNear = 0.95;    // share that counts as all

using Level = Finding::Level;

std::string Percent(double share) { return FormatFixed(100 * share, 1) + " %"; }

std::string CountOfUnreadable(size_t count, size_t of, const std::string& first) {
  return std::to_string(count) + " of the " + std::to_string(of) + " looked into cannot be read, the first: " + first;
}

Status CheckColour(const TumLists& lists, size_t i, const cv::Mat& stored) {
  if (Status no_depth = CheckIsNoDepth(lists, i, stored); !no_depth) return no_depth;
  const auto usable = ToColourAndGrey(stored, lists.colour.pictures[i].path);
  return usable ? Status::Ok() : Status(usable.error());
}

ListFacts FactsOf(const PictureList& list) {
  ListFacts facts;
  const auto times = list.Times();
  facts.count = times.size();
  if (times.empty()) return facts;
  facts.first = times.front();
  facts.last = times.back();
  const double step = MedianStep(times);
  if (step > 0) facts.rate_hz = 1 / step;
  for (size_t i = 1; i < times.size(); ++i) {
    facts.longest_gap_s = std::max(facts.longest_gap_s.value_or(0), SecondsBetween(times[i - 1], times[i]));
  }
  return facts;
}

/// Gathers findings; each step reads on as far as the steps before it allow.
class Examiner {
 public:
  Examiner(const std::string& folder, const std::string& camera) : camera_(camera) { check_.folder = folder; }

  SequenceCheck Examine() {
    if (!Passed("layout", CheckLayout(check_.folder))) return check_;
    auto lists = ReadTumLists(check_.folder);
    if (lists) {
      lists_ = std::move(*lists);
      ReportLists();
      ReportFiles();
    } else {
      Add(Level::kError, "lists", lists.error().message);
    }
    ReportCamera();
    if (lists_) ReportPictures();
    if (lists_) ReportTruth();
    return check_;
  }

 private:
  void Add(Level level, const std::string& topic, const std::string& text) {
    check_.findings.push_back({level, topic, text});
  }

  bool Passed(const std::string& topic, const Status& status) {
    if (!status) Add(Level::kError, topic, status.error().message);
    return status.ok();
  }

  void ReportLists();
  void ReportPairs();
  void ReportFiles();
  void ReportCamera();
  void ReportPictures();
  void CompareSizes(const cv::Size& size);
  void ReportDepth();
  bool HasReadableDepth();
  void ReportTruth();
  void SampleDepth(size_t frame, const cv::Size& size);

  std::string camera_;
  SequenceCheck check_;
  std::optional<TumLists> lists_;
  std::optional<ChosenCamera> chosen_;
  std::optional<Rig> rig_;
  std::vector<double> depths_m_;
  size_t num_depth_pixels_ = 0, num_depth_pictures_ = 0;
  bool is_depth_float_ = false;
  std::vector<std::string> depth_errors_, depth_faults_;  // of a wrong kind; not to be read at all
};

void Examiner::ReportLists() {
  check_.colour = FactsOf(lists_->colour);
  check_.depth = FactsOf(lists_->depth);
  const ListFacts& colour = check_.colour;
  std::string rates = std::to_string(colour.count) + " colour pictures";
  if (colour.rate_hz) rates += " at " + FormatFixed(*colour.rate_hz, 1) + " Hz";
  rates += ", " + std::to_string(check_.depth.count) + " depth pictures";
  if (check_.depth.rate_hz) rates += " at " + FormatFixed(*check_.depth.rate_hz, 1) + " Hz";
  if (colour.count > 1) rates += ", " + FormatFixed(SecondsBetween(*colour.first, *colour.last), 1) + " s";
  Add(Level::kFine, "stamps", rates + (lists_->are_associated ? " (" + lists_->colour.file + ")" : ""));
  if (const std::string strange = StrangeStamps(lists_->colour); !strange.empty()) {
    Add(Level::kWarning, "stamps", strange);
  }
  if (colour.longest_gap_s && *colour.longest_gap_s > kLongGap) {
    Add(Level::kWarning, "stamps",
        "the longest gap between colour pictures is " + FormatFixed(*colour.longest_gap_s, 2) + " s");
  }
  ReportPairs();
}

void Examiner::ReportPairs() {
  std::vector<double> apart_s;
  for (size_t i = 0; i < lists_->depth_of.size(); ++i) {
    if (lists_->depth_of[i] < 0) continue;
    const Timestamp depth = lists_->depth.pictures[static_cast<size_t>(lists_->depth_of[i])].time;
    apart_s.push_back(std::abs(SecondsBetween(lists_->colour.pictures[i].time, depth)));
  }
  const auto is_far = [](double apart) { return apart > kMaxPairDifference; };  // as lists of associations may be
  const auto num_far = static_cast<size_t>(std::count_if(apart_s.begin(), apart_s.end(), is_far));
  check_.num_pairs = apart_s.size() - num_far;
  check_.median_pair_distance_s = Quantile(apart_s, 0.5);
  const double share = static_cast<double>(*check_.num_pairs) / static_cast<double>(check_.colour.count);
  Add(share < kAllNear ? Level::kWarning : Level::kFine, "pairs",
      std::to_string(*check_.num_pairs) + " of " + std::to_string(check_.colour.count) +
          " colour pictures have depth within 20 ms, " + FormatFixed(*check_.median_pair_distance_s * 1e3, 1) +
          " ms apart (median)" +
          (num_far > 0 ? "; " + std::to_string(num_far) + " pairs of the list are farther apart" : ""));
}

void Examiner::ReportFiles() {
  if (Passed("files", LookForFiles(*lists_))) Add(Level::kFine, "files", "every listed file is there");
}

void Examiner::ReportCamera() {
  auto chosen = ChooseCamera(check_.folder, camera_);
  if (!chosen) return Add(Level::kError, "camera", chosen.error().message);
  check_.camera = chosen->rig.name;
  const Pinhole& camera = chosen->rig.camera;
  Add(Level::kFine, "camera",
      chosen->rig.name + " (" + chosen->how + "): fx " + FormatFixed(camera.fx, 2) + ", fy " +
          FormatFixed(camera.fy, 2) + ", cx " + FormatFixed(camera.cx, 2) + ", cy " + FormatFixed(camera.cy, 2) +
          (camera.HasDistortion() ? ", distorted" : ""));
  const std::string unlike = UnlikeFolderName(check_.folder, chosen->rig);
  if (!unlike.empty()) Add(Level::kWarning, "camera", unlike);
  chosen_ = std::move(*chosen);
}

void Examiner::ReportPictures() {
  const auto& pictures = lists_->colour.pictures;
  const size_t num_samples = std::min(kSamples, pictures.size());
  std::optional<cv::Size> size;
  bool is_fine = true;
  std::string first_fault;
  for (size_t k = 0; k < num_samples; ++k) {
    const size_t i = k * pictures.size() / num_samples;
    const StoredPicture stored = ReadPictureFile(pictures[i].path);
    ++check_.num_sampled;
    if (!stored.fault.empty()) {
      if (++check_.num_unreadable == 1) first_fault = pictures[i].path + " " + stored.fault;
      continue;
    }
    if (const Status usable = CheckColour(*lists_, i, stored.pixels); !usable) {
      if (is_fine) Add(Level::kError, "pictures", usable.error().message);
      is_fine = false;
    }
    if (size && stored.pixels.size() != *size) {
      is_fine = false;
      Add(Level::kError, "pictures",
          pictures[i].path + " is " + SizeText(stored.pixels.size()) + ", others are " + SizeText(*size));
    }
    if (!size) size = stored.pixels.size();
    SampleDepth(i, *size);
  }
  if (!size) return Add(Level::kError, "pictures", "none of the pictures looked into can be read: " + first_fault);
  if (check_.num_unreadable > 0) {
    Add(Level::kWarning, "pictures",
        CountOfUnreadable(check_.num_unreadable, check_.num_sampled, first_fault) + "; their frames would be left out");
  }
  check_.width = size->width;
  check_.height = size->height;
  if (is_fine) {
    Add(Level::kFine, "pictures",
        SizeText(*size) + ", " + std::to_string(check_.num_sampled) + " looked into, " +
            std::to_string(check_.num_unreadable) + " unreadable");
  }
  if (chosen_) CompareSizes(*size);
  ReportDepth();
}

void Examiner::CompareSizes(const cv::Size& size) {
  const auto rig = FitChosenCamera(*chosen_, size.width, size.height);
  if (!rig) return Add(Level::kError, "camera", rig.error().message);
  rig_ = *rig;
  if (const std::string odd = rig_->Oddity(); !odd.empty()) Add(Level::kWarning, "camera", odd + "; check its file");
  if (chosen_->rig.camera.width != 0 && chosen_->rig.camera.width != size.width) {
    Add(Level::kWarning, "camera", "the camera is for pictures of another size and would be scaled to them");
  }
}

void Examiner::SampleDepth(size_t frame, const cv::Size& size) {
  const int index = lists_->depth_of[frame];
  if (index < 0) return;
  const std::string& path = lists_->depth.pictures[static_cast<size_t>(index)].path;
  const StoredPicture stored = ReadPictureFile(path);
  if (!stored.fault.empty()) {
    depth_faults_.push_back(path + " " + stored.fault);
    return;
  }
  if (const Status kind = CheckDepth(stored.pixels, size, path); !kind) {
    depth_errors_.push_back(kind.error().message);
    return;
  }
  ++num_depth_pictures_;
  is_depth_float_ = stored.pixels.type() == CV_32FC1;
  // The factor is put in later, when the camera is known to fit.
  const DepthImage depth{stored.pixels, 1.0};
  constexpr int kStep = 4;
  for (int y = kStep / 2; y < size.height; y += kStep) {
    for (int x = kStep / 2; x < size.width; x += kStep, ++num_depth_pixels_) {
      if (const float units = depth.At(x, y); units > 0) depths_m_.push_back(units);
    }
  }
}

/// Tells of depth pictures that are none, each kind in one line; whether there are others.
bool Examiner::HasReadableDepth() {
  if (!depth_errors_.empty()) Add(Level::kError, "depth", depth_errors_.front());
  const size_t num_others = depth_errors_.size() + num_depth_pictures_;
  if (const size_t num_faults = depth_faults_.size(); num_faults > 0) {
    const std::string& first = depth_faults_.front();
    if (num_others == 0) {
      Add(Level::kError, "depth", "none of the depth pictures looked into can be read: " + first);
    } else {
      Add(Level::kWarning, "depth",
          CountOfUnreadable(num_faults, num_faults + num_others, first) + "; their frames would have no depth");
    }
  }
  return num_depth_pictures_ > 0;
}

void Examiner::ReportDepth() {
  if (!HasReadableDepth()) return;
  if (depths_m_.empty())
    return Add(Level::kWarning, "depth", "no depth is measured in any picture looked into: no map could begin");
  check_.depth_hole_share = 1 - static_cast<double>(depths_m_.size()) / static_cast<double>(num_depth_pixels_);
  if (!rig_) return;
  if (!is_depth_float_ && rig_->depth_factor <= 0) {
    return Add(Level::kError, "depth", UnknownDepthFactor(*rig_, lists_->depth.pictures.front().path).message);
  }
  const double metres = is_depth_float_ ? 1.0 : 1.0 / rig_->depth_factor;
  check_.depth_p5_m = Quantile(depths_m_, 0.05) * metres;
  check_.depth_median_m = Quantile(depths_m_, 0.5) * metres;
  check_.depth_p95_m = Quantile(depths_m_, 0.95) * metres;
  const std::string complaint =
      DepthWatch::FactorComplaint(*check_.depth_median_m, is_depth_float_, rig_->depth_factor, rig_->name);
  if (!complaint.empty()) Add(Level::kWarning, "depth", complaint);
  Add(*check_.depth_hole_share > kManyHoles ? Level::kWarning : Level::kFine, "depth",
      FormatFixed(*check_.depth_p5_m, 2) + " to " + FormatFixed(*check_.depth_p95_m, 2) + " m, median " +
          FormatFixed(*check_.depth_median_m, 2) + " m; " + Percent(*check_.depth_hole_share) +
          " of the pixels without depth");
}

void Examiner::ReportTruth() {
  const std::string path = (fs::path(check_.folder) / "groundtruth.txt").string();
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return Add(Level::kFine, "truth", "no groundtruth.txt");
  const auto text = ReadTextFile(path);
  if (!text) return Add(Level::kWarning, "truth", text.error().message);
  std::vector<Timestamp> times;
  for (const TextLine& line : text->lines) {
    const auto fields = SplitAtBlanks(line.text);
    const auto time = ParseTimestamp(fields.front());
    if (!time || fields.size() != 8) {
      return Add(Level::kWarning, "truth", text->Where(line) + ": not 'timestamp tx ty tz qx qy qz qw'");
    }
    times.push_back(*time);
  }
  std::sort(times.begin(), times.end());
  size_t num_near = 0;
  for (const ListedPicture& picture : lists_->colour.pictures) {
    const auto after = std::lower_bound(times.begin(), times.end(), picture.time);
    const bool is_near = (after != times.end() && SecondsBetween(picture.time, *after) <= kTruthNear) ||
                         (after != times.begin() && SecondsBetween(*(after - 1), picture.time) <= kTruthNear);
    num_near += is_near;
  }
  check_.truth_share = static_cast<double>(num_near) / static_cast<double>(lists_->colour.pictures.size());
  Add(*check_.truth_share < kFewTruths ? Level::kWarning : Level::kFine, "truth",
      "groundtruth.txt has a pose within 20 ms for " + Percent(*check_.truth_share) + " of the colour pictures");
}

}  // namespace

bool SequenceCheck::is_usable() const {
  return std::none_of(findings.begin(), findings.end(), [](const Finding& f) { return f.level == Level::kError; });
}

SequenceCheck CheckSequence(const std::string& folder, const std::string& camera) {
  return Examiner(folder, camera).Examine();
}

}  // namespace yorb
