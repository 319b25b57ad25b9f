// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/masked_dataset.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <opencv2/core.hpp>
#include <optional>

#include "core/log.h"
#include "core/text.h"
#include "pictures/picture_file.h"
#include "pictures/picture_folder.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

/// The masks of a folder, by name without .png and, where that is one, by time stamp.
struct MaskFolder {
  std::map<std::string, std::string> by_name;
  std::map<Timestamp, std::string> by_time;
};

bool IsPng(const fs::path& path) { return LowerCase(path.extension().string()) == ".png"; }

MaskFolder ListMasks(const std::string& folder) {
  std::vector<fs::path> paths;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (IsPng(entry.path())) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());  // where a.png stands beside a.PNG it is the same one on every machine
  MaskFolder masks;
  for (const fs::path& path : paths) {
    const std::string name = path.stem().string();
    masks.by_name[name] = path.string();
    if (const auto time = ParseTimestamp(name)) masks.by_time[*time] = path.string();
  }
  return masks;
}

std::string MaskOf(const MaskFolder& masks, const Dataset& source, size_t i) {
  const fs::path picture(source.PictureName(i));
  for (const fs::path& name : {picture.filename(), picture.stem()}) {  // COLMAP puts .png behind the whole name
    const auto by_name = masks.by_name.find(name.string());
    if (by_name != masks.by_name.end()) return by_name->second;
  }
  // Names are rounded, or cut, to the decimals that their writer had.
  constexpr int64_t kRounded_ns = 1'000'000;
  const int64_t time_ns = source.TimeOf(i).ns;
  const auto after = masks.by_time.lower_bound(Timestamp{time_ns - kRounded_ns + 1});
  std::string nearest;
  int64_t least_ns = kRounded_ns;
  for (auto at = after; at != masks.by_time.end() && at->first.ns - time_ns < kRounded_ns; ++at) {
    const int64_t apart_ns = std::abs(at->first.ns - time_ns);
    if (apart_ns < least_ns) least_ns = apart_ns, nearest = at->second;
  }
  return nearest;
}

/// Not 0 where any colour of the mask is not: a palette counts by its colours, as a viewer shows it.
cv::Mat ToMask(const cv::Mat& stored) {
  cv::Mat any(stored.size(), CV_8UC1, cv::Scalar(0));
  const size_t bytes = stored.elemSize();
  // A fourth channel is transparency: it hides nothing and marks nothing.
  const size_t used = stored.channels() == 4 ? bytes / 4 * 3 : bytes;
  for (int y = 0; y < stored.rows; ++y) {
    const uint8_t* from = stored.ptr(y);
    for (int x = 0; x < stored.cols; ++x) {
      for (size_t k = 0; k < used; ++k) any.at<uint8_t>(y, x) |= from[static_cast<size_t>(x) * bytes + k];
    }
  }
  return any;
}

/// Whether a mask that is black all over differs in its transparency: who drew it meant something by that.
bool IsDrawnInTransparency(const cv::Mat& stored, const cv::Mat& mask) {
  if (stored.channels() != 4 || cv::countNonZero(mask) > 0) return false;
  cv::Mat transparency;
  cv::extractChannel(stored, transparency, 3);
  double least = 0, most = 0;
  cv::minMaxLoc(transparency, &least, &most);
  return least < most;
}

Error UnlikeSize(const std::string& file, const cv::Size& mask, const cv::Size& picture) {
  return BadInput("the mask " + file + " is " + SizeText(mask) + ", its picture is " + SizeText(picture) +
                  "; a mask has a pixel for each of its picture's");
}

/// Masks of which none can be read are no masks; the first one that can be ends the search, and speaks for the size of
/// all, before any work is done.
Status CheckFirstReadable(const std::vector<std::string>& files, const std::string& masks, const Rig& rig) {
  std::string first_fault;
  const cv::Size size(rig.camera.width, rig.camera.height);
  for (const std::string& file : files) {
    if (file.empty()) continue;
    const StoredPicture stored = ReadPictureFile(file);
    if (stored.fault.empty() && !size.empty() && stored.pixels.size() != size)
      return UnlikeSize(file, stored.pixels.size(), size);
    if (stored.fault.empty()) return Status::Ok();
    if (first_fault.empty()) first_fault = file + " " + stored.fault;
    if (file == masks) break;  // one for all frames
  }
  return BadInput("--masks: " + first_fault + (fs::is_directory(masks) ? ", and no other mask can be read" : ""));
}

/// A word where most of what is seen is masked: COLMAP's masks, and others, are the other way round.
void WarnOfNegatives(const std::vector<std::string>& files, const std::string& masks) {
  constexpr size_t kTried = 5;
  constexpr double kMost = 0.6;
  std::vector<std::string> there;
  for (const std::string& file : files) {
    if (!file.empty() && (there.empty() || file != there.back())) there.push_back(file);
  }
  std::vector<double> shares;
  for (size_t i = 0; i < std::min(there.size(), kTried); ++i) {
    const StoredPicture stored = ReadPictureFile(there[i * there.size() / std::min(there.size(), kTried)]);
    if (!stored.fault.empty()) continue;
    shares.push_back(cv::countNonZero(ToMask(stored.pixels)) / static_cast<double>(stored.pixels.total()));
  }
  if (shares.empty() || *std::min_element(shares.begin(), shares.end()) < kMost) return;
  LogWarning("masks-negative", masks + ": the masks take away " + FormatFixed(100 * shares.front(), 0) +
                                   " % of a picture: what is not black is not used; where black marks what is not, as "
                                   "in COLMAP's masks, turn them into their negatives");
}

/// Why a folder has no mask for any picture.
Error NoneNamed(const std::string& masks, const MaskFolder& folder, const Dataset& source) {
  if (folder.by_name.empty()) {
    const size_t num_others = PicturesIn(masks).size();
    return BadInput("--masks: " + masks + " holds no PNG" +
                    (num_others > 0 ? " but " + std::to_string(num_others) +
                                          " of other formats; save masks as PNG, since JPEG smears their edges"
                                    : ""));
  }
  return BadInput("--masks: none of the " + std::to_string(folder.by_name.size()) + " PNGs in " + masks +
                  " is named as a colour picture or by its time stamp" +
                  (source.size() > 0 ? ", such as " + fs::path(source.PictureName(0)).stem().string() + ".png" : ""));
}

}  // namespace

Result<std::unique_ptr<MaskedDataset>> MaskedDataset::Open(const Dataset& source, const std::string& masks) {
  std::unique_ptr<MaskedDataset> masked(new MaskedDataset(source));
  std::error_code ignored;
  if (fs::is_regular_file(masks, ignored)) {
    masked->files_.assign(source.size(), masks);
    if (const Status readable = CheckFirstReadable({masks}, masks, source.rig()); !readable) return readable.error();
    WarnOfNegatives(masked->files_, masks);
    return masked;
  }
  if (!fs::is_directory(masks, ignored)) return BadInput("--masks: there is no file or folder " + masks);
  const MaskFolder folder = ListMasks(masks);
  size_t num_without = 0;
  for (size_t i = 0; i < source.size(); ++i) {
    masked->files_.push_back(MaskOf(folder, source, i));
    num_without += masked->files_.back().empty();
  }
  if (num_without == source.size()) return NoneNamed(masks, folder, source);
  if (num_without > 0) {
    LogWarning("masks-missing", std::to_string(num_without) + " of " + std::to_string(source.size()) +
                                    " pictures have no mask in " + masks + " and are used as a whole");
  }
  if (const Status readable = CheckFirstReadable(masked->files_, masks, source.rig()); !readable)
    return readable.error();
  WarnOfNegatives(masked->files_, masks);
  return masked;
}

Result<LoadedFrame> MaskedDataset::Load(size_t i) const {
  auto frame = source_.Load(i);
  if (!frame || !frame->images || files_[i].empty()) return frame;
  const StoredPicture stored = ReadPictureFile(files_[i]);
  if (!stored.fault.empty()) {
    LogWarning("mask-skipped", "the mask " + files_[i] + " " + stored.fault + "; its frame is used as a whole");
    ++frame->num_skipped;
    return frame;
  }
  if (stored.pixels.size() != frame->images->grey.size()) {
    return UnlikeSize(files_[i], stored.pixels.size(), frame->images->grey.size());
  }
  frame->images->ignored = ToMask(stored.pixels);
  if (IsDrawnInTransparency(stored.pixels, frame->images->ignored)) {
    LogWarning("mask-transparent", "the mask " + files_[i] +
                                       " is black all over, its transparency is not looked at: nothing is masked; save "
                                       "it as grey, white where the picture is not to be used");
  }
  return frame;
}

}  // namespace yorb
