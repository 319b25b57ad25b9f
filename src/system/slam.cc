// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "system/slam.h"

#include "core/text.h"
#include "map/map.h"
#include "system/config_io.h"
#include "system/pipeline.h"

namespace yorb {
namespace {

bool IsDepthFor(const DepthImage& depth, const cv::Mat& grey) {
  const int type = depth.pixels.type();
  return depth.empty() || ((type == CV_16UC1 || type == CV_32FC1) && depth.pixels.size() == grey.size());
}

std::string ProjectionText(const Rig& rig) {
  const Pinhole& c = rig.camera;
  std::string text = rig.name + " (";
  for (const double value : {c.fx, c.fy, c.cx, c.cy, rig.baseline_px}) text += FormatShortest(value) + " ";
  text.back() = ')';
  return text;
}

}  // namespace

// One bundle, one camera: keyframes of two cameras are never adjusted together.
Status Slam::CheckMap(const Config& config, const Map& map, const Rig& rig) {
  std::string other;
  map.VisitKeyframes([&](const Keyframe& keyframe) {
    if (!keyframe.frame->rig->ProjectsLike(rig)) other = ProjectionText(*keyframe.frame->rig);
  });
  if (other.empty() || config.localize_only) return Status::Ok();
  const std::string name = config.load_map.empty() ? "" : " " + config.load_map;
  return BadInput("the map" + name + " was made with the camera " + other + ", and these pictures are of " +
                  ProjectionText(rig) +
                  "; give the map's camera to go on with it, or --localize-only to use it as it is");
}

Result<std::unique_ptr<Slam>> Slam::Create(const Config& config, const Rig& rig, SlamParts parts) {
  if (const Status valid = ValidateConfig(config); !valid) return valid.error();
  if (rig.camera.width <= 0 || rig.camera.height <= 0) {
    return BadInput("the camera " + rig.name + " states no picture size; give it width and height");
  }
  if (!(rig.camera.fx > 0) || !(rig.camera.fy > 0))
    return BadInput("the camera " + rig.name + " needs fx and fy above 0");
  if (!(rig.baseline_px > 0)) return BadInput("the camera " + rig.name + " needs a baseline above 0");
  if (config.localize_only && (!parts.map || parts.map->num_keyframes() == 0)) {
    return BadInput("--localize-only needs a map with keyframes; name its file with --load-map");
  }
  if (parts.map) {
    const Status fits = CheckMap(config, *parts.map, rig);
    if (!fits) return fits.error();
  }
  return std::unique_ptr<Slam>(new Slam(config, rig, std::move(parts)));
}

Slam::Slam(const Config& config, const Rig& rig, SlamParts parts)
    : pipeline_(std::make_unique<Pipeline>(config, rig, std::move(parts))),
      width_(rig.camera.width),
      height_(rig.camera.height) {}

Slam::~Slam() = default;

Result<bool> Slam::Push(ImageSet images) {
  if (images.grey.cols != width_ || images.grey.rows != height_) {
    return BadInput("the picture at " + ToString(images.timestamp) + " s is " +
                    SizeText(images.grey.cols, images.grey.rows) + ", the camera's are " + SizeText(width_, height_));
  }
  if (images.grey.type() != CV_8UC1) {
    return BadInput("the picture at " + ToString(images.timestamp) + " s is not 8-bit grey");
  }
  if (!IsDepthFor(images.depth, images.grey)) {
    return BadInput("the depth at " + ToString(images.timestamp) +
                    " s is neither 16-bit nor float, or not of the picture's size");
  }
  if (newest_ && images.timestamp <= *newest_) {
    return BadInput("the picture at " + ToString(images.timestamp) + " s is not later than the one before, at " +
                    ToString(*newest_) + " s");
  }
  if (!images.ignored.empty() && (images.ignored.type() != CV_8UC1 || images.ignored.size() != images.grey.size())) {
    return BadInput("the mask at " + ToString(images.timestamp) + " s is not 8-bit grey, or not of the picture's size");
  }
  newest_ = images.timestamp;
  const bool is_pushed = pipeline_->Push(std::move(images));
  if (const Status fault = Fault(); !fault) return fault.error();
  return is_pushed;
}

void Slam::Finish() { pipeline_->Finish(); }

Status Slam::Fault() const { return pipeline_->Fault(); }

MapSnapshot Slam::Snapshot() const { return pipeline_->Snapshot(); }

SlamReport Slam::Report() const { return pipeline_->Report(); }

size_t Slam::NumFramesDone() const { return pipeline_->num_frames_done(); }

}  // namespace yorb
