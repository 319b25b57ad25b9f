// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/tum.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/log.h"
#include "core/text.h"
#include "datasets/associate.h"
#include "datasets/associations.h"
#include "datasets/depth_watch.h"
#include "pictures/picture_file.h"
#include "pictures/picture_folder.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

constexpr double kFewPairs = 0.3;  // of the colour pictures with depth, below which something is wrong with the lists

bool IsFile(const std::string& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

bool Exists(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

std::string In(const std::string& folder, const char* name) { return (fs::path(folder) / name).string(); }

constexpr const char* kOtherAssociations[] = {"associate.txt", "association.txt", "associated.txt"};

/// associations.txt, or the other names that it goes by where there is no rgb.txt; empty if none is there.
std::string AssociationsFile(const std::string& folder) {
  if (Exists(In(folder, "associations.txt"))) return In(folder, "associations.txt");
  if (Exists(In(folder, "rgb.txt"))) return "";
  for (const char* name : kOtherAssociations) {
    if (Exists(In(folder, name))) return In(folder, name);
  }
  return "";
}

Result<TumLists> FromAssociations(const std::string& folder, const std::string& file) {
  auto read = ReadAssociations(file);
  if (!read) return read.error();
  TumLists lists{folder, std::move(read->colour), std::move(read->depth), {}, true};
  if (const Status stamps = CheckStamps(lists.colour); !stamps) return stamps.error();
  size_t num_far = 0;
  for (size_t i = 0; i < lists.colour.pictures.size(); ++i) {
    lists.depth_of.push_back(static_cast<int>(i));
    const double apart = SecondsBetween(lists.colour.pictures[i].time, lists.depth.pictures[i].time);
    num_far += std::abs(apart) > kMaxPairDifference;
  }
  if (num_far > 0) {
    LogWarning("pairs", file + ": " + std::to_string(num_far) + " of " + std::to_string(lists.depth_of.size()) +
                            " pairs are more than 20 ms apart");
  }
  return lists;
}

void SortByTime(PictureList& list) {
  const auto earlier = [](const ListedPicture& a, const ListedPicture& b) { return a.time < b.time; };
  if (std::is_sorted(list.pictures.begin(), list.pictures.end(), earlier)) return;
  LogWarning("depth-order", list.file + " is not in the order of time; it is read as if it were");
  std::stable_sort(list.pictures.begin(), list.pictures.end(), earlier);
}

Error NoDepthList(const std::string& folder) {
  return BadInput(
      In(folder, "depth.txt") +
      " does not exist, and yorb needs depth (it is RGB-D): depth.txt names the depth pictures (16-bit PNG) "
      "as rgb.txt does the colour ones, a line each, such as '1305031102.160407 depth/1305031102.160407.png'");
}

Result<TumLists> FromTwoLists(const std::string& folder) {
  auto colour = ReadPictureList(In(folder, "rgb.txt"));
  if (!colour) return colour.error();
  if (const Status stamps = CheckStamps(*colour); !stamps) return stamps.error();
  if (!Exists(In(folder, "depth.txt"))) return NoDepthList(folder);
  auto depth = ReadPictureList(In(folder, "depth.txt"));
  if (!depth) return depth.error();
  SortByTime(*depth);
  const auto colour_times = colour->Times(), depth_times = depth->Times();
  TumLists lists{folder, std::move(*colour), std::move(*depth), Associate(colour_times, depth_times), false};
  const size_t num_pairs = lists.NumWithDepth(), num_colour = lists.depth_of.size();
  if (num_pairs == 0) {
    return BadInput(folder + ": no colour picture has a depth picture within 20 ms: " + lists.colour.file + " covers " +
                    RangeText(colour_times) + ", " + lists.depth.file + " " + RangeText(depth_times));
  }
  if (static_cast<double>(num_pairs) < kFewPairs * static_cast<double>(num_colour)) {
    LogWarning("pairs", folder + ": only " + std::to_string(num_pairs) + " of " + std::to_string(num_colour) +
                            " colour pictures have a depth picture within 20 ms");
  }
  return lists;
}

/// Whether the file or its folder is called depth, and not "rgb_in_depth" or so.
bool IsNamedDepth(const std::string& name) {
  const fs::path path = name;
  for (const fs::path& part : {path.parent_path().filename(), path.filename()}) {
    const std::string word = LowerCase(part.string());
    const auto speaks_of = [&](const char* what) { return word.find(what) != std::string::npos; };
    const bool is_other = speaks_of("rgb") || speaks_of("colo") || speaks_of("infra") || speaks_of("ir_") ||
                          speaks_of("_ir") || speaks_of("grey") || speaks_of("gray");
    if (speaks_of("depth") && !is_other) return true;
  }
  return false;
}

bool IsColour(const cv::Mat& pixels) { return !pixels.empty() && pixels.channels() >= 3; }

/// A picture of the same name with another ending, as conversions leave them: for the complaint.
std::string WithAnotherEnding(const std::string& path) {
  for (const char* ending : {".png", ".jpg", ".jpeg", ".tiff", ".tif", ".pgm", ".bmp"}) {
    const std::string other = fs::path(path).replace_extension(ending).string();
    if (IsFile(other)) return "; there is " + other;
  }
  return "";
}

class TumDataset : public Dataset {
 public:
  TumDataset(TumLists lists, Rig rig, int colour_bits)
      : lists_(std::move(lists)), rig_(std::move(rig)), colour_bits_(colour_bits) {}

  size_t size() const override { return lists_.colour.pictures.size(); }
  Timestamp TimeOf(size_t i) const override { return lists_.colour.pictures[i].time; }
  std::string PictureName(size_t i) const override { return lists_.colour.pictures[i].name; }
  const Rig& rig() const override { return rig_; }
  Result<LoadedFrame> Load(size_t i) const override;

 private:
  Status LoadDepth(size_t i, LoadedFrame& frame) const;

  TumLists lists_;
  Rig rig_;
  int colour_bits_;
};

Result<LoadedFrame> TumDataset::Load(size_t i) const {
  const ListedPicture& listed = lists_.colour.pictures[i];
  LoadedFrame frame;
  const StoredPicture stored = ReadPictureFile(listed.path);
  if (!stored.fault.empty()) {
    LogWarning("picture-skipped", listed.path + " " + stored.fault + "; the frame is left out");
    frame.num_skipped = 1;
    return frame;
  }
  auto picture = ToColourAndGrey(stored.pixels, listed.path, colour_bits_);
  if (!picture) return picture.error();
  const cv::Size size(rig_.camera.width, rig_.camera.height);
  if (picture->grey.size() != size) {
    return BadInput(listed.path + " is " + SizeText(picture->grey.size()) + ", the pictures before it are " +
                    SizeText(size) + "; pictures must not change size within a recording");
  }
  frame.orientation = stored.orientation;
  frame.images = ImageSet{listed.time, picture->grey, picture->colour, {}};
  if (const Status depth = LoadDepth(i, frame); !depth) return depth.error();
  return frame;
}

Status TumDataset::LoadDepth(size_t i, LoadedFrame& frame) const {
  const int index = lists_.depth_of[i];
  if (index < 0) return Status::Ok();
  const ListedPicture& listed = lists_.depth.pictures[static_cast<size_t>(index)];
  const StoredPicture stored = ReadPictureFile(listed.path);
  if (!stored.fault.empty()) {
    const bool is_told = i > 0 && lists_.depth_of[i - 1] == index;  // a depth picture that serves two frames
    if (!is_told) LogWarning("depth-skipped", listed.path + " " + stored.fault + "; its frame has no depth");
    frame.num_skipped += !is_told;
    return Status::Ok();
  }
  if (Status kind = CheckDepth(stored.pixels, frame.images->grey.size(), listed.path); !kind) return kind;
  if (stored.pixels.depth() == CV_16U && rig_.depth_factor <= 0) return UnknownDepthFactor(rig_, listed.path);
  frame.images->depth = {stored.pixels, rig_.depth_factor > 0 ? 1.0 / rig_.depth_factor : 1.0};
  frame.depth = GlanceAt(frame.images->depth);
  return Status::Ok();
}

}  // namespace

Error UnknownDepthFactor(const Rig& rig, const std::string& picture) {
  return BadInput(
      "camera " + rig.name + " states no depth factor, and " + picture +
      " holds 16-bit units: add depth_factor (in ORB-SLAM settings DepthMapFactor) to the camera file, 1000 "
      "where the pictures hold millimetres, 5000 for TUM's");
}

size_t TumLists::NumWithDepth() const {
  return static_cast<size_t>(std::count_if(depth_of.begin(), depth_of.end(), [](int index) { return index >= 0; }));
}

std::vector<std::string> ListNames() {
  std::vector<std::string> names = {"associations.txt", "rgb.txt", "depth.txt"};
  names.insert(names.end(), std::begin(kOtherAssociations), std::end(kOtherAssociations));
  return names;
}

bool HasTumLayout(const std::string& folder) {
  return !AssociationsFile(folder).empty() || Exists(In(folder, "rgb.txt"));
}

Result<TumLists> ReadTumLists(const std::string& folder) {
  const std::string associations = AssociationsFile(folder);
  return associations.empty() ? FromTwoLists(folder) : FromAssociations(folder, associations);
}

Result<PictureList> ReadColourList(const std::string& folder) {
  const std::string associations = AssociationsFile(folder);
  auto list = associations.empty() ? ReadPictureList(In(folder, "rgb.txt")) : [&]() -> Result<PictureList> {
    auto read = ReadAssociations(associations);
    if (!read) return read.error();
    return std::move(read->colour);
  }();
  if (!list) return list.error();
  if (const Status stamps = CheckStamps(*list); !stamps) return stamps.error();
  return list;
}

Result<TumLists> ReadAnyPictures(const std::string& folder) {
  if (!AssociationsFile(folder).empty() || Exists(In(folder, "depth.txt"))) return ReadTumLists(folder);
  TumLists lists{folder, {folder, {}}, {}, {}, false};
  if (HasTumLayout(folder)) {
    auto colour = ReadColourList(folder);
    if (!colour) return colour.error();
    lists.colour = *std::move(colour);
  } else {
    for (const std::string& path : PicturesIn(folder)) {
      const auto second = static_cast<int64_t>(lists.colour.pictures.size());
      lists.colour.pictures.push_back(
          {{second * 1'000'000'000}, fs::path(path).lexically_relative(folder).string(), path, 0});
    }
    LogInfo(folder + " has no list: its pictures get the time stamps 0, 1, 2 and so on in the order of their names");
  }
  lists.depth_of.assign(lists.colour.pictures.size(), -1);
  return lists;
}

Status LookForFiles(const TumLists& lists) {
  for (const PictureList* list : {&lists.colour, &lists.depth}) {
    const auto& pictures = list->pictures;
    const auto is_missing = [](const ListedPicture& picture) { return !IsFile(picture.path); };
    const auto first = std::find_if(pictures.begin(), pictures.end(), is_missing);
    if (first == pictures.end()) continue;
    const auto num_missing = std::count_if(first, pictures.end(), is_missing);
    const std::string how_many = std::to_string(num_missing) + " of the " + std::to_string(pictures.size());
    const std::string what = Exists(first->path) ? " is no file" : " is missing";
    if (first->line == 0)
      return BadInput(first->path + what + "; " + how_many + " pictures of " + list->file + " are not there");
    return BadInput(first->path + what + " (" + list->file + ", line " + std::to_string(first->line) + "); " +
                    how_many + " files that the list names are not there" + WithAnotherEnding(first->path));
  }
  return Status::Ok();
}

Result<FirstPicture> ReadFirstPicture(const std::vector<ListedPicture>& pictures) {
  std::string first_fault;
  for (size_t i = 0; i < pictures.size(); ++i) {
    StoredPicture stored = ReadPictureFile(pictures[i].path);
    if (stored.fault.empty()) return FirstPicture{i, std::move(stored.pixels)};
    if (i == 0) first_fault = pictures[i].path + " " + stored.fault;
  }
  return BadInput("none of the " + std::to_string(pictures.size()) + " pictures can be read: " + first_fault);
}

Status CheckIsNoDepth(const TumLists& lists, size_t i, const cv::Mat& stored) {
  if (stored.type() != CV_16UC1 && stored.type() != CV_32FC1) return Status::Ok();
  const ListedPicture& colour = lists.colour.pictures[i];
  const int index = lists.depth_of[i];
  const ListedPicture* depth = index < 0 ? nullptr : &lists.depth.pictures[static_cast<size_t>(index)];
  std::string reason;
  if (depth != nullptr && depth->path == colour.path) {
    reason = "it is named as depth, too";
  } else if (depth != nullptr && IsColour(ReadPictureFile(depth->path).pixels)) {
    reason = depth->path + ", which is named as its depth, is in colour";
  } else if (IsNamedDepth(colour.name)) {
    reason = "its name says so";
  }
  if (reason.empty()) return Status::Ok();
  return BadInput(colour.path + " (" + lists.colour.file + ", line " + std::to_string(colour.line) +
                  ") is a depth picture that is named as colour: " + reason +
                  "; are the two lists or columns swapped?");
}

int UsedBits(const PictureList& colour) {
  constexpr size_t kSamples = 10;
  const size_t count = colour.pictures.size(), num_samples = std::min(kSamples, count);
  int bits = 0;
  for (size_t k = 0; k < num_samples; ++k) {
    const cv::Mat pixels = ReadPictureFile(colour.pictures[k * count / num_samples].path).pixels;
    if (!pixels.empty() && pixels.depth() != CV_16U) return 16;
    if (!pixels.empty()) bits = std::max(bits, UsedBits(pixels));
  }
  return bits == 0 ? 16 : bits;
}

std::unique_ptr<Dataset> MakeTumDataset(TumLists lists, Rig rig, int colour_bits) {
  return std::make_unique<TumDataset>(std::move(lists), std::move(rig), colour_bits);
}

}  // namespace yorb
