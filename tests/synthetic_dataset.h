// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "camera/camera_io.h"
#include "core/files.h"
#include "datasets/dataset.h"
#include "pictures/png.h"
#include "synthetic/sequence.h"

namespace yorb {

/// A short recording of a rendered room, kept in memory: small pictures, so that tests are fast.
class SyntheticDataset : public Dataset {
 public:
  explicit SyntheticDataset(int num_frames, PathKind path = PathKind::kXyz) {
    SequenceOptions options;
    options.path = path;
    options.num_frames = num_frames;
    options.rig = SyntheticRig(320, 240);
    const SyntheticSequence sequence(options);
    rig_ = sequence.rig();
    truth_ = sequence.Truth();
    for (int i = 0; i < num_frames; ++i) frames_.push_back(sequence.Render(i).images);
  }

  size_t size() const override { return frames_.size(); }
  Timestamp TimeOf(size_t i) const override { return frames_[i].timestamp; }
  std::string PictureName(size_t i) const override { return "rgb/" + std::to_string(i) + ".png"; }
  const Rig& rig() const override { return rig_; }
  Result<LoadedFrame> Load(size_t i) const override {
    LoadedFrame frame;
    frame.images = frames_[i];
    frame.depth = {true, false, 1, 2};
    return frame;
  }
  const Trajectory& truth() const { return truth_; }

  /// Writes it in TUM's layout, `repeats` times over with stamps that go on: a long recording for little work.
  void WriteTo(const std::string& folder, int repeats = 1) const {
    std::string rgb, depth;
    for (size_t i = 0; i < frames_.size(); ++i) {
      const std::string name = std::to_string(i) + ".png";
      const cv::Mat& picture = frames_[i].colour.empty() ? frames_[i].grey : frames_[i].colour;
      WritePicture(folder + "/rgb/" + name, picture);
      WritePicture(folder + "/depth/" + name, frames_[i].depth.pixels);
    }
    for (size_t k = 0; k < frames_.size() * static_cast<size_t>(repeats); ++k) {
      // There and back again, so that the camera does not jump.
      const size_t period = frames_.size() == 1 ? 1 : 2 * (frames_.size() - 1);
      const size_t step = k % period, i = step < frames_.size() ? step : period - step;
      const std::string stamp = ToString(Timestamp{frames_[0].timestamp.ns + static_cast<int64_t>(k) * 33333000});
      rgb += stamp + " rgb/" + std::to_string(i) + ".png\n";
      depth += stamp + " depth/" + std::to_string(i) + ".png\n";
    }
    WriteText(folder + "/rgb.txt", rgb);
    WriteText(folder + "/depth.txt", depth);
    WriteText(folder + "/camera.yaml", CameraFileText(rig_));
  }

 private:
  static void WriteText(const std::string& path, const std::string& text) {
    const Status status = WriteFileWhole(path, text);
    YORB_CHECK(status.ok(), path.c_str());
  }
  static void WritePicture(const std::string& path, const cv::Mat& picture) {
    const auto bytes = EncodePng(picture);
    YORB_CHECK(bytes.ok(), path.c_str());
    WriteText(path, *bytes);
  }

  Rig rig_;
  std::vector<ImageSet> frames_;
  Trajectory truth_;
};

}  // namespace yorb
