// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/dense_cloud.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "dynamics/remover.h"
#include "runs/voxel_grid.h"

namespace yorb {
namespace {

constexpr int kStepPx = 2;           // pixels between two that are projected: at arm's length a few millimetres
constexpr float kEdgeShare = 0.02f;  // two neighbours whose depths differ by more are not on one surface
constexpr int kMarginOctave = 5;     // a corner of that level keeps some ten pixels' distance from bodies
constexpr double kOctaveScale = 1.2;
constexpr int64_t kSameMomentNs = 1000000;
constexpr size_t kFewestComparable = 20;  // depths without which nothing is said of a picture
constexpr float kSameDepthShare = 0.1f;   // pictures that were written anew differ a little

/// A keyframe whose picture is in the recording.
struct Seen {
  size_t frame = 0;  ///< of the recording
  const Keyframe* keyframe = nullptr;
  size_t root = 0;  ///< position among the roots
};

/// The frame of the recording at that moment.
std::optional<size_t> FrameAt(const Dataset& dataset, Timestamp time) {
  size_t low = 0, high = dataset.size();
  while (low < high) {
    const size_t middle = (low + high) / 2;
    if (dataset.TimeOf(middle).ns + kSameMomentNs < time.ns) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  if (low == dataset.size() || std::abs(dataset.TimeOf(low).ns - time.ns) > kSameMomentNs) return std::nullopt;
  return low;
}

/// By rising frame, as whoever follows people needs it.
std::vector<Seen> FindPictures(const Map& map, const std::vector<KeyframeId>& roots, const Dataset& dataset) {
  std::vector<Seen> seen;
  map.VisitKeyframes([&](const Keyframe& keyframe) {
    const auto root = std::find(roots.begin(), roots.end(), keyframe.root);
    const auto frame = FrameAt(dataset, keyframe.frame->timestamp);
    if (root != roots.end() && frame) seen.push_back({*frame, &keyframe, static_cast<size_t>(root - roots.begin())});
  });
  std::stable_sort(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) { return a.frame < b.frame; });
  return seen;
}

/// The directions of the pixels that are projected, for one camera.
class Rays {
 public:
  explicit Rays(const Rig& rig) {
    const Pinhole& camera = rig.camera;
    std::vector<Eigen::Vector2f> pixels;
    for (int y = 1; y + 1 < camera.height; y += kStepPx) {
      for (int x = 1; x + 1 < camera.width; x += kStepPx) {
        pixels_.push_back({x, y});
        pixels.emplace_back(static_cast<float>(x), static_cast<float>(y));
      }
    }
    for (const Eigen::Vector2f& px : camera.Undistort(pixels)) rays_.push_back(camera.Unproject(px.x(), px.y(), 1));
  }

  template <typename Visitor>
  void Visit(Visitor&& visit) const {
    for (size_t i = 0; i < pixels_.size(); ++i) visit(pixels_[i], rays_[i]);
  }

 private:
  std::vector<cv::Point> pixels_;
  std::vector<Eigen::Vector3d> rays_;
};

/// The depth at a pixel inside of the border that lies on a surface; 0 elsewhere.
float SurfaceDepth(const DepthImage& depth, const cv::Point& px, double farthest_m) {
  const float here = depth.At(px.x, px.y);
  if (here <= 0 || here > farthest_m) return 0;
  const float others[] = {depth.At(px.x - 1, px.y), depth.At(px.x + 1, px.y), depth.At(px.x, px.y - 1),
                          depth.At(px.x, px.y + 1)};
  const bool is_smooth = std::all_of(std::begin(others), std::end(others), [&](float other) {
    return other > 0 && std::abs(other - here) <= kEdgeShare * here;
  });
  return is_smooth ? here : 0;
}

std::array<uint8_t, 3> ColourAt(const ImageSet& images, const cv::Point& px) {
  if (images.colour.empty()) {
    const uint8_t grey = images.grey.at<uint8_t>(px);
    return {grey, grey, grey};
  }
  const auto& bgr = images.colour.at<cv::Vec3b>(px);
  return {bgr[2], bgr[1], bgr[0]};
}

void AddPicture(const ImageSet& images, const MovingAreas& areas, const Keyframe& keyframe, const Rays& rays,
                VoxelGrid& grid) {
  const Rigid3 world_from_cam = keyframe.cam_from_world.Inverse();
  const double farthest_m = keyframe.frame->rig->CloseDepth();
  rays.Visit([&](const cv::Point& px, const Eigen::Vector3d& ray) {
    const float metres = SurfaceDepth(images.depth, px, farthest_m);
    if (metres <= 0 || !ray.allFinite()) return;
    const Keypoint point{static_cast<float>(px.x), static_cast<float>(px.y), 0, 0, kMarginOctave};
    if (areas.Judge(point) != Verdict::kDynamic) grid.Add(world_from_cam * (metres * ray), ColourAt(images, px));
  });
}

/// Whether the depths of a keyframe's points are others than those of the picture. Both are looked at in the picture as
/// it is, not undistorted. Holes say nothing, and of few points neither is said.
bool IsOfOtherPicture(const Frame& frame, const DepthImage& depth) {
  size_t num_comparable = 0, num_same = 0;
  for (size_t i = 0; i < frame.size(); ++i) {
    const cv::Point px(static_cast<int>(std::lround(frame.keypoints[i].x)),
                       static_cast<int>(std::lround(frame.keypoints[i].y)));
    if (!frame.HasDepth(i) || !cv::Rect({0, 0}, depth.pixels.size()).contains(px)) continue;
    const float here = depth.At(px.x, px.y);
    if (here <= 0) continue;
    ++num_comparable;
    num_same += std::abs(here - frame.depth[i]) <= kSameDepthShare * frame.depth[i];
  }
  return num_comparable >= kFewestComparable && 2 * num_same < num_comparable;
}

/// Loads pictures one by one, and says what moves in them.
class Watcher {
 public:
  Watcher(const Dataset& dataset, const RunParts& parts)
      : dataset_(dataset),
        detector_(parts.slam.detector.get()),
        remover_(detector_ ? Dynamics::kFull : Dynamics::kOff, parts.slam.motions, kOctaveScale,
                 parts.sure_confidence) {}

  struct Look {
    ImageSet images;
    MovingAreas areas;
  };

  /// Nothing where the picture cannot be decoded, or has no depth.
  Result<std::optional<Look>> At(size_t frame) {
    auto loaded = dataset_.Load(frame);
    if (!loaded) return loaded.error();
    if (!loaded->images || loaded->images->depth.empty()) return std::optional<Look>();
    SeenAt seen{{false, {}}, loaded->images->timestamp};
    if (detector_) {
      auto detections = detector_->Detect(*loaded->images);
      if (!detections) return detections.error();
      seen.seen = *std::move(detections);
    }
    MovingAreas areas = remover_.Look(*loaded->images, seen);
    return std::optional<Look>(Look{*std::move(loaded->images), std::move(areas)});
  }

 private:
  const Dataset& dataset_;
  Detector* detector_;
  Remover remover_;
};

}  // namespace

Result<DenseClouds> MakeDenseClouds(const Map& map, const std::vector<KeyframeId>& roots, const Dataset& dataset,
                                    const RunParts& parts, const DenseOptions& options) {
  const std::vector<Seen> seen = FindPictures(map, roots, dataset);
  const Rays rays(dataset.rig());
  Watcher watcher(dataset, parts);
  std::vector<VoxelGrid> grids(roots.size(), VoxelGrid(options.cube_m));
  DenseClouds made;
  for (size_t i = 0; i < seen.size();) {
    made.was_stopped = options.should_stop && options.should_stop();
    if (made.was_stopped) return made;
    const size_t frame = seen[i].frame;
    auto look = watcher.At(frame);
    if (!look) return look.error();
    const size_t num_before = made.num_keyframes;
    for (; i < seen.size() && seen[i].frame == frame; ++i) {
      if (!*look) continue;
      if (IsOfOtherPicture(*seen[i].keyframe->frame, (*look)->images.depth)) {
        ++made.num_of_others;
        continue;
      }
      AddPicture((*look)->images, (*look)->areas, *seen[i].keyframe, rays, grids[seen[i].root]);
      ++made.num_keyframes;
    }
    if (made.num_keyframes > num_before) made.num_with_people += !(*look)->areas.boxes().empty();
  }
  if (seen.empty() || (made.num_keyframes == 0 && made.num_of_others > 0)) {
    return BadInput("no keyframe of the map has its picture in the recording; name one that the map was made of");
  }
  for (const VoxelGrid& grid : grids) made.clouds.push_back(grid.Cloud());
  return made;
}

}  // namespace yorb
