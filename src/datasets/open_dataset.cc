// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/open_dataset.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <regex>
#include <utility>
#include <vector>

#include "camera/builtin_cameras.h"
#include "camera/camera_io.h"
#include "core/log.h"
#include "core/stats.h"
#include "core/text.h"
#include "datasets/tum.h"
#include "pictures/picture_file.h"
#include "pictures/picture_folder.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCameraFiles[] = {"camera.yaml", "camera.yml"};
constexpr double kSameFocalLength = 0.01;  // calibrations of one camera differ by less

/// By which of its files a recording of another kind is known.
constexpr std::pair<const char*, const char*> kOtherKinds[] = {
    {"mav0", "a EuRoC"},
    {"cam0/data.csv", "a EuRoC"},  // mav0 itself
    {"image_0", "a KITTI"},
    {"image_2", "a KITTI"},
    {"results/depth000000.png", "a Replica"},
    {"frame-000000.depth.png", "a 7-Scenes"},
    {"seq-01/frame-000000.depth.png", "a 7-Scenes"},
    {"intrinsic/intrinsic_depth.txt", "a ScanNet"},
};

/// What a folder without lists of ours may be, for a helpful complaint.
std::string HintAt(const std::string& folder) {
  std::error_code ignored;
  const auto has = [&](const char* name) { return fs::exists(fs::path(folder) / name, ignored); };
  if (has("color.txt") && has("aligned_depth.txt"))
    return "; it looks like an OpenLORIS recording: call color.txt rgb.txt, and aligned_depth.txt depth.txt";
  for (const auto& [name, kind] : kOtherKinds) {
    if (has(name)) return "; it looks like " + std::string(kind) + " recording, which is not read yet";
  }
  std::string inner;
  for (fs::directory_iterator at(folder, ignored), end; !ignored && at != end; at.increment(ignored)) {
    if (at->is_directory(ignored) && HasTumLayout(at->path().string())) inner = at->path().string();
  }
  return inner.empty() ? "" : "; did you mean " + inner + "?";
}

/// The first depth pictures must be depth; later ones are looked at as they come.
Status CheckFirstDepth(const TumLists& lists, const Rig& rig) {
  constexpr size_t kTried = 5;
  size_t num_tried = 0;
  for (const ListedPicture& listed : lists.depth.pictures) {
    if (++num_tried > kTried) break;
    const StoredPicture stored = ReadPictureFile(listed.path);
    if (!stored.fault.empty()) continue;
    const Status kind = CheckDepth(stored.pixels, {rig.camera.width, rig.camera.height}, listed.path);
    if (!kind) return kind;
    if (stored.pixels.depth() == CV_16U && rig.depth_factor <= 0) return UnknownDepthFactor(rig, listed.path);
    break;
  }
  return Status::Ok();
}

}  // namespace

std::string CameraOfFolderName(const std::string& folder) {
  static const std::regex tum("(rgbd_dataset_)?freiburg([123])(_.*)?");
  std::error_code ignored;
  const fs::path given = fs::absolute(folder, ignored).lexically_normal();
  for (const fs::path& path : {given, fs::weakly_canonical(given, ignored)}) {
    const std::string name = (path.has_filename() ? path : path.parent_path()).filename().string();
    std::smatch match;
    if (std::regex_match(name, match, tum)) return "tum_fr" + match[2].str();
  }
  return "";
}

std::string UnlikeFolderName(const std::string& folder, const Rig& rig) {
  const std::string named = CameraOfFolderName(folder);
  if (named.empty()) return "";
  const auto expected = ReadCamera(named);
  if (!expected || std::abs(rig.camera.fx / expected->camera.fx - 1) < kSameFocalLength) return "";
  return "the folder's name stands for camera " + named + ", but camera " + rig.name +
         " with another focal length is used";
}

Status CheckLayout(const std::string& folder, Layout layout) {
  if (folder.empty()) return BadInput("the name of the folder is empty; give the folder of the recording");
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (status.type() == fs::file_type::not_found) return BadInput("folder " + folder + " does not exist");
  if (status.type() != fs::file_type::directory && !error) {
    return BadInput(folder + " is a file; give the folder of the recording (unpack archives first)");
  }
  if (!error && HasTumLayout(folder)) return Status::Ok();
  if (!error) fs::directory_iterator(folder, error);  // may it be looked into?
  if (error) return BadInput("folder " + folder + " cannot be read: " + error.message());
  const bool wants_any = layout == Layout::kAnyPictures;
  if (wants_any && !PicturesIn(folder).empty()) return Status::Ok();
  return BadInput(folder + " holds neither rgb.txt (with depth.txt) nor associations.txt" +
                  (wants_any ? ", nor pictures" : "") + HintAt(folder));
}

bool ShowsItsCamera(const std::string& folder) {
  std::error_code ignored;
  const auto is_there = [&](const char* name) { return fs::exists(fs::path(folder) / name, ignored); };
  return std::any_of(std::begin(kCameraFiles), std::end(kCameraFiles), is_there) || !CameraOfFolderName(folder).empty();
}

Result<ChosenCamera> ChooseCamera(const std::string& folder, const std::string& camera) {
  ChosenCamera chosen;
  std::string source = camera;
  std::error_code ignored;
  if (!source.empty()) {
    chosen.how = "as given";
    chosen.is_given = true;
  }
  for (const char* name : kCameraFiles) {
    const fs::path file = fs::path(folder) / name;
    if (!source.empty() || !fs::exists(file, ignored)) continue;
    source = file.string();
    chosen.how = std::string("the folder's ") + name;
    chosen.is_given = true;
  }
  if (source.empty()) {
    source = CameraOfFolderName(folder);
    chosen.how = "by the folder's name";
  }
  if (source.empty()) {
    std::string known;
    for (const std::string& name : BuiltinCameraNames()) known += (known.empty() ? "" : ", ") + name;
    return BadInput("which camera took " + folder + " does not show in it: give --camera FILE or NAME (known names: " +
                    known + "), or put a camera.yaml into the folder");
  }
  auto rig = ReadCamera(source);
  if (!rig) return rig.error();
  chosen.rig = std::move(*rig);
  return chosen;
}

Result<Rig> FitChosenCamera(const ChosenCamera& chosen, int width, int height) {
  auto fitted = FitToPictures(chosen.rig, width, height);
  if (!fitted) return fitted.error();
  if (!fitted->was_scaled) return fitted->rig;
  const Pinhole& camera = chosen.rig.camera;
  const std::string sizes = SizeText({camera.width, camera.height}) + ", the pictures are " + SizeText({width, height});
  if (!chosen.is_given) {
    return BadInput("camera " + chosen.rig.name + " (" + chosen.how + ") is for pictures of " + sizes +
                    ": give --camera for the pictures as they are");
  }
  LogWarning("camera-scaled", "camera " + chosen.rig.name + " is for pictures of " + sizes +
                                  "; it is scaled to them, which is right if they were resized and not cropped");
  return fitted->rig;
}

Result<std::unique_ptr<Dataset>> OpenDataset(const std::string& folder, const std::string& camera, Layout layout) {
  if (const Status there = CheckLayout(folder, layout); !there) return there.error();
  const auto chosen = ChooseCamera(folder, camera);
  if (!chosen) return chosen.error();
  return OpenDataset(folder, *chosen, layout);
}

Result<std::unique_ptr<Dataset>> OpenDataset(const std::string& folder, const ChosenCamera& chosen, Layout layout) {
  if (const Status there = CheckLayout(folder, layout); !there) return there.error();
  auto lists = layout == Layout::kRecording ? ReadTumLists(folder) : ReadAnyPictures(folder);
  if (!lists) return lists.error();
  if (const Status files = LookForFiles(*lists); !files) return files.error();
  const auto first = ReadFirstPicture(lists->colour.pictures);
  if (!first) return first.error();
  if (const Status no_depth = CheckIsNoDepth(*lists, first->index, first->pixels); !no_depth) return no_depth.error();
  const auto usable = ToColourAndGrey(first->pixels, lists->colour.pictures[first->index].path);
  if (!usable) return usable.error();
  auto rig = FitChosenCamera(chosen, first->pixels.cols, first->pixels.rows);
  if (!rig) return rig.error();
  const double step = MedianStep(lists->colour.Times());
  if (rig->fps <= 0) rig->fps = step > 0 ? 1 / step : 30;
  if (const Status depth = CheckFirstDepth(*lists, *rig); !depth) return depth.error();
  if (const std::string unlike = UnlikeFolderName(folder, chosen.rig); !unlike.empty()) LogWarning("camera", unlike);
  if (const std::string odd = rig->Oddity(); !odd.empty()) {
    LogWarning("camera-odd", "camera " + rig->name + ": " + odd + "; check its file");
  }
  LogInfo(folder + ": " + std::to_string(lists->depth_of.size()) + " colour pictures of " +
          SizeText(first->pixels.size()) + (step > 0 ? " at " + FormatFixed(1 / step, 1) + " Hz" : "") + ", " +
          std::to_string(lists->NumWithDepth()) + " with depth; camera " + rig->name + " (" + chosen.how + ")");
  const int colour_bits = first->pixels.depth() == CV_16U ? UsedBits(lists->colour) : 16;
  if (colour_bits < 16) {
    LogInfo(folder + ": of the 16 bits of a pixel the colour pictures use " + std::to_string(colour_bits) +
            ", which are scaled to 8");
  }
  return MakeTumDataset(std::move(*lists), std::move(*rig), colour_bits);
}

}  // namespace yorb
