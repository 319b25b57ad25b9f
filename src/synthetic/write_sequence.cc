// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic/write_sequence.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "camera/camera_io.h"
#include "core/files.h"
#include "core/parallel.h"
#include "core/text.h"
#include "pictures/picture_file.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMarker = "rendered.txt";  // tells a folder of ours from one with somebody's recording
constexpr const char* kFolders[] = {"rgb", "depth", "mask"};
constexpr const char* kLists[] = {"rgb.txt", "depth.txt", "groundtruth.txt", "people.txt", "camera.yaml"};

std::string Inside(const std::string& folder, const std::string& name) { return (fs::path(folder) / name).string(); }

Status WritePicture(const std::string& path, const cv::Mat& picture, int jpeg_quality) {
  const auto bytes = EncodePictureFor(path, picture, jpeg_quality);
  return bytes ? WriteFileQuickly(path, *bytes) : Status(bytes.error());
}

std::string PicturePath(const SyntheticSequence& sequence, const WriteOptions& options, const std::string& kind,
                        int frame) {
  return kind + "/" + ToString(sequence.TimeOf(frame)) + (kind == "rgb" && !options.is_lossless ? ".jpg" : ".png");
}

// people.txt's lines of one frame.
std::string BoxLines(const RenderedFrame& rendered) {
  std::string lines;
  for (const PersonBox& box : rendered.boxes) {
    lines += ToString(rendered.images.timestamp);
    for (const int number : {box.left, box.top, box.right, box.bottom, box.num_visible_px})
      lines += " " + std::to_string(number);
    lines += "\n";
  }
  return lines;
}

struct WrittenFrame {
  Status status;
  std::string box_lines;
};

WrittenFrame WriteFrame(const SyntheticSequence& sequence, const WriteOptions& options, int frame) {
  const RenderedFrame rendered = sequence.Render(frame);
  const auto write = [&](const std::string& kind, const cv::Mat& picture) {
    return WritePicture(Inside(options.folder, PicturePath(sequence, options, kind, frame)), picture,
                        options.jpeg_quality);
  };
  WrittenFrame written{write("rgb", rendered.images.colour), BoxLines(rendered)};
  if (written.status) written.status = write("depth", rendered.images.depth.pixels);
  if (written.status && sequence.num_people() > 0) written.status = write("mask", rendered.mask);
  return written;
}

std::string PictureList(const SyntheticSequence& sequence, const WriteOptions& options, const std::string& kind,
                        size_t num_frames) {
  std::string text = "# " + std::string(kind == "rgb" ? "colour" : "depth") + " pictures\n# timestamp filename\n";
  for (int frame = 0; frame < static_cast<int>(num_frames); ++frame) {
    text += ToString(sequence.TimeOf(frame)) + " " + PicturePath(sequence, options, kind, frame) + "\n";
  }
  return text;
}

Status WriteLists(const SyntheticSequence& sequence, const WriteOptions& options, size_t num_frames,
                  const std::string& boxes) {
  Trajectory truth = sequence.Truth();
  truth.resize(num_frames);
  const std::pair<const char*, std::string> files[] = {
      {"camera.yaml", CameraFileText(sequence.rig())},
      {"groundtruth.txt", "# exact camera poses, world_from_cam\n# timestamp tx ty tz qx qy qz qw\n" + TumText(truth)},
      {"people.txt", "# timestamp left top right bottom visible_px\n" + boxes},
      {"depth.txt", PictureList(sequence, options, "depth", num_frames)},
      {"rgb.txt", PictureList(sequence, options, "rgb", num_frames)},
  };
  for (const auto& [name, text] : files) {
    const Status status = WriteFileWhole(Inside(options.folder, name), text);
    if (!status) return status;
  }
  return Status::Ok();
}

// Takes away what an earlier rendering left; `folder` carries our marker.
void RemoveRendering(const std::string& folder) {
  std::error_code ignored;
  for (const char* name : kLists) fs::remove(Inside(folder, name), ignored);
  for (const char* name : kFolders) fs::remove_all(Inside(folder, name), ignored);
}

}  // namespace

Status PrepareFolder(const std::string& folder, const std::string& description) {
  if (folder.empty()) return BadInput("the name of the folder to render into is empty");
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error))
    return BadInput(folder + " is a file; name a folder to render into");
  const bool is_ours = fs::exists(Inside(folder, kMarker), error);
  if (!is_ours && fs::is_directory(folder, error) && !fs::is_empty(folder, error) && !error) {
    return BadInput(folder + " holds files that were not rendered here; name a new or an empty folder");
  }
  if (is_ours) RemoveRendering(folder);
  for (const char* name : kFolders) {
    fs::create_directories(Inside(folder, name), error);
    if (error) return BadInput(folder + " cannot be written: " + error.message() + "; name a folder that can");
  }
  const Status marked = WriteFileWhole(Inside(folder, kMarker), description + "\n");
  return marked ? marked : BadInput(marked.error().message + "; name a folder that can be written");
}

Result<size_t> WriteSequence(const SyntheticSequence& sequence, const WriteOptions& options, const WriteHooks& hooks) {
  const auto num_frames = static_cast<size_t>(sequence.num_frames());
  const size_t num_at_once = static_cast<size_t>(std::max(1, options.num_threads)) * 4;
  size_t num_done = 0;
  std::string boxes;
  while (num_done < num_frames && !hooks.should_stop()) {
    std::vector<WrittenFrame> written(std::min(num_at_once, num_frames - num_done));
    ParallelFor(written.size(), options.num_threads,
                [&](size_t i) { written[i] = WriteFrame(sequence, options, static_cast<int>(num_done + i)); });
    for (const WrittenFrame& frame : written) {
      if (!frame.status) return frame.status.error();
      boxes += frame.box_lines;
    }
    num_done += written.size();
    hooks.on_progress(num_done, num_frames);
  }
  const Status status = WriteLists(sequence, options, num_done, boxes);
  if (!status) return status.error();
  return num_done;
}

}  // namespace yorb
