// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/picture_source.h"

#include <filesystem>
#include <utility>
#include <vector>

#include "core/log.h"
#include "datasets/picture_list.h"
#include "datasets/tum.h"
#include "pictures/endings.h"
#include "pictures/picture_folder.h"
#include "pictures/still_picture.h"
#include "pictures/video.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

/// Picture files, with time stamps or without.
class FileSource : public PictureSource {
 public:
  void Add(std::string image, std::string name, std::optional<Timestamp> time) {
    entries_.push_back({std::move(image), std::move(name), time, {}});
  }

  bool HasNext() override { return next_ < entries_.size(); }
  size_t NumLeft() const override { return entries_.size() - next_; }

  Result<SourcePicture> Next() override {
    SourcePicture entry = entries_[next_++];
    auto pixels = ReadUprightPicture(entry.image);
    if (!pixels) return pixels.error();
    entry.pixels = *std::move(pixels);
    return entry;
  }

 private:
  std::vector<SourcePicture> entries_;
  size_t next_ = 0;
};

class VideoSource : public PictureSource {
 public:
  VideoSource(std::string path, Video video) : path_(std::move(path)), video_(std::move(video)) {
    frame_ = video_.Next();
  }

  bool HasNext() override { return frame_.has_value(); }

  Result<SourcePicture> Next() override {
    std::string number = std::to_string(num_given_++);
    number.insert(0, number.size() < 6 ? 6 - number.size() : 0, '0');
    SourcePicture picture{path_, fs::path(path_).stem().string() + "_" + number + ".png", frame_->time, frame_->bgr};
    frame_ = video_.Next();
    if (const std::string cut = frame_ ? "" : video_.Shortfall(); !cut.empty())
      LogWarning("video-cut", path_ + " " + cut);
    return picture;
  }

 private:
  std::string path_;
  Video video_;
  std::optional<VideoFrame> frame_;
  size_t num_given_ = 0;
};

Result<std::unique_ptr<PictureSource>> OpenSequence(const std::string& folder) {
  const auto list = ReadColourList(folder);
  if (!list) return list.error();
  auto source = std::make_unique<FileSource>();
  for (const ListedPicture& picture : list->pictures) {
    const fs::path name = fs::path(picture.path).lexically_relative(folder);
    source->Add(picture.path, name.empty() || *name.begin() == ".." ? name.filename().string() : name.string(),
                picture.time);
  }
  return std::unique_ptr<PictureSource>(std::move(source));
}

Result<std::unique_ptr<PictureSource>> OpenFolder(const std::string& folder) {
  const std::vector<std::string> pictures = PicturesUnder(folder), videos = VideosUnder(folder);
  const std::string hint = videos.empty() ? "" : "; videos, such as " + videos[0] + ", are read where they are named";
  if (pictures.empty()) return BadInput(folder + " holds no pictures" + hint);
  if (!videos.empty()) LogWarning("videos-passed-over", folder + ": only its pictures are looked at" + hint);
  auto source = std::make_unique<FileSource>();
  for (const std::string& picture : pictures)
    source->Add(picture, fs::path(picture).lexically_relative(folder).string(), std::nullopt);
  return std::unique_ptr<PictureSource>(std::move(source));
}

}  // namespace

Result<std::unique_ptr<PictureSource>> OpenPictureSource(const std::string& path) {
  std::error_code ignored;
  if (path.empty()) return BadInput("a picture has an empty name (\"\"); name a picture, folder, video or sequence");
  if (fs::is_directory(path, ignored)) return HasTumLayout(path) ? OpenSequence(path) : OpenFolder(path);
  if (HasVideoEnding(path)) {
    auto video = Video::Open(path);
    if (!video) return video.error();
    auto source = std::make_unique<VideoSource>(path, *std::move(video));
    if (!source->HasNext()) return BadInput(path + " holds no picture that can be decoded");
    return std::unique_ptr<PictureSource>(std::move(source));
  }
  auto source = std::make_unique<FileSource>();
  source->Add(path, fs::path(path).filename().string(), std::nullopt);
  return std::unique_ptr<PictureSource>(std::move(source));
}

}  // namespace yorb
