// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/features_pictures.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/files.h"
#include "core/log.h"
#include "datasets/open_dataset.h"
#include "datasets/tum.h"
#include "evaluation/trajectory_io.h"
#include "pictures/picture_file.h"
#include "pictures/picture_folder.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

constexpr double kLongestHole_s = 0.1;

Result<PictureSet> OpenLoosePictures(PictureSet set, const std::string& place) {
  std::error_code error;
  if (!fs::is_directory(place, error)) {
    set.paths.push_back(place);
    return set;
  }
  fs::directory_iterator(place, error);  // may it be looked into?
  if (error) return BadInput("folder " + place + " cannot be read: " + error.message());
  set.paths = PicturesIn(place);
  if (set.paths.empty()) return BadInput("folder " + place + " holds no pictures and no sequence");
  return set;
}

}  // namespace

Result<PictureSet> OpenPictureSet(const std::string& place, const std::string& camera) {
  PictureSet set;
  set.name = OwnName(place);
  std::error_code error;
  if (!fs::exists(place, error)) return BadInput(place + " does not exist");
  if (!HasTumLayout(place)) return OpenLoosePictures(std::move(set), place);
  auto dataset = OpenDataset(place, camera);
  if (!dataset) return dataset.error();
  set.dataset = *std::move(dataset);
  const fs::path truth = fs::path(place) / "groundtruth.txt";
  if (fs::exists(truth, error)) {
    auto read = ReadTrajectoryFile(truth.string());
    if (!read) return read.error();
    set.truth = std::move(read->poses);
  }
  return set;
}

Result<ImageSet> LoadPicture(const PictureSet& set, size_t i) {
  if (set.dataset) {
    auto loaded = set.dataset->Load(i);
    if (!loaded) return loaded.error();
    return loaded->images ? *std::move(loaded->images) : ImageSet();
  }
  ImageSet images;
  const StoredPicture stored = ReadPictureFile(set.paths[i]);
  if (!stored.fault.empty()) {
    LogWarning("picture-skipped", set.paths[i] + " " + stored.fault + "; it is left out");
    return images;
  }
  auto usable = ToColourAndGrey(stored.pixels, set.paths[i]);
  if (!usable) return usable.error();
  images.grey = std::move(usable->grey);
  images.colour = std::move(usable->colour);
  return images;
}

std::optional<Rigid3> TruePose(const Trajectory& truth, Timestamp time) {
  const auto after = std::lower_bound(truth.begin(), truth.end(), time,
                                      [](const StampedPose& pose, Timestamp t) { return pose.timestamp < t; });
  if (after == truth.end()) return std::nullopt;
  if (after->timestamp == time) return after->world_from_cam;
  if (after == truth.begin()) return std::nullopt;
  const auto before = after - 1;
  const double step = SecondsBetween(before->timestamp, after->timestamp);
  if (step > kLongestHole_s) return std::nullopt;
  const double share = SecondsBetween(before->timestamp, time) / step;
  const Rigid3 &from = before->world_from_cam, &to = after->world_from_cam;
  return Rigid3(from.rotation.slerp(share, to.rotation), (1 - share) * from.translation + share * to.translation);
}

std::vector<size_t> Spread(size_t size, size_t count) {
  const size_t taken = count == 0 ? size : std::min(size, count);
  std::vector<size_t> indices;
  for (size_t k = 0; k < taken; ++k) indices.push_back(k * size / taken);
  return indices;
}

}  // namespace yorb
