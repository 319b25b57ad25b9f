// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/frame_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace yorb {
namespace {

/// The depth under a keypoint, in the picture as it is: that of the nearest pixel, since an average would invent depths
/// at edges. Where the pixel itself is a hole, the nearest of its eight neighbours, if those that were measured agree:
/// registered depth is criss-crossed by holes of a pixel's width.
float DepthUnder(const Keypoint& keypoint, const DepthImage& depth) {
  constexpr float kAgreement = 1.05f;
  const int x = static_cast<int>(std::lround(keypoint.x)), y = static_cast<int>(std::lround(keypoint.y));
  if (depth.empty() || x < 0 || y < 0 || x >= depth.pixels.cols || y >= depth.pixels.rows) return 0;
  if (const float here = depth.At(x, y); here > 0) return here;

  float nearest = 0, least = 0, most = 0;
  float nearest_px2 = 10;
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, depth.pixels.rows - 1); ++v) {
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, depth.pixels.cols - 1); ++u) {
      const float there = depth.At(u, v);
      if (there <= 0) continue;
      least = least > 0 ? std::min(least, there) : there;
      most = std::max(most, there);
      const float du = static_cast<float>(u) - keypoint.x, dv = static_cast<float>(v) - keypoint.y;
      if (du * du + dv * dv < nearest_px2) {
        nearest_px2 = du * du + dv * dv;
        nearest = there;
      }
    }
  }
  return most <= kAgreement * least ? nearest : 0;
}

}  // namespace

FrameBuilder::FrameBuilder(const FeatureOptions& options, const Rig& rig)
    : extractor_(options),
      wanted_(static_cast<size_t>(options.wanted)),
      trim_by_(options.trim == "spread" ? TrimBy::kSpread : TrimBy::kResponse),
      rig_(std::make_shared<const Rig>(rig)),
      scales_(std::make_shared<const ScaleTable>(options.levels, options.scale_factor)),
      bounds_(rig.Bounds()) {}

FramePtr FrameBuilder::Build(FrameId id, const ImageSet& images, Features features, Features suspects) const {
  auto frame = std::make_shared<Frame>();
  frame->id = id;
  frame->timestamp = images.timestamp;
  frame->rig = rig_;
  frame->scales = scales_;
  frame->bounds = bounds_;

  features = Trim(std::move(features), wanted_, trim_by_);
  frame->keypoints = std::move(features.keypoints);
  frame->descriptors = std::move(features.descriptors);
  frame->num_suspects = suspects.keypoints.size();
  frame->keypoints.insert(frame->keypoints.end(), suspects.keypoints.begin(), suspects.keypoints.end());
  frame->descriptors.insert(frame->descriptors.end(), suspects.descriptors.begin(), suspects.descriptors.end());

  std::vector<Eigen::Vector2f> distorted_px(frame->size());
  for (size_t i = 0; i < frame->size(); ++i) distorted_px[i] = {frame->keypoints[i].x, frame->keypoints[i].y};
  frame->points_px = rig_->camera.Undistort(distorted_px);

  frame->depth.resize(frame->size());
  frame->right_px.assign(frame->size(), std::numeric_limits<float>::quiet_NaN());
  for (size_t i = 0; i < frame->size(); ++i) {
    frame->depth[i] = DepthUnder(frame->keypoints[i], images.depth);
    if (frame->HasDepth(i)) {
      frame->right_px[i] = frame->points_px[i].x() - static_cast<float>(rig_->VirtualBaselinePx()) / frame->depth[i];
    }
  }
  frame->grid = Grid(bounds_, frame->points_px);
  return frame;
}

}  // namespace yorb
