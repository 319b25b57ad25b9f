// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "camera/rig.h"
#include "core/id.h"
#include "core/time.h"
#include "features/grid.h"
#include "features/keypoint.h"

namespace yorb {

struct Frame;
using FrameId = Id<Frame>;

/// The scales of the pyramid, the same for all frames of a run.
struct ScaleTable {
  double factor = 1.2;
  std::vector<float> scale;             ///< factor^level
  std::vector<float> inverse_variance;  ///< scale^-2: how sure a keypoint of that level is, in 1/px^2

  ScaleTable() = default;
  ScaleTable(int levels, double scale_factor);
  int levels() const { return static_cast<int>(scale.size()); }
};

/// One picture as points: what every stage after extraction sees of it. Const once built; shared, never copied.
/// The rows of all vectors belong together.
struct Frame {
  FrameId id;
  Timestamp timestamp;
  std::shared_ptr<const Rig> rig;
  std::shared_ptr<const ScaleTable> scales;
  PixelBounds bounds;

  std::vector<Keypoint> keypoints;         ///< in the picture as it is
  std::vector<Eigen::Vector2f> points_px;  ///< the same, undistorted
  std::vector<float> depth;                ///< metres along z; 0 where not measured
  std::vector<float> right_px;             ///< x in the virtual right picture; NaN where no depth
  std::vector<Descriptor> descriptors;
  Grid grid;  ///< over points_px
  /// So many of the last rows lie on what is presumed to move. Only what the map knows well may be found among them.
  size_t num_suspects = 0;

  size_t size() const { return keypoints.size(); }
  bool IsSuspect(size_t index) const { return index + num_suspects >= size(); }
  bool HasDepth(size_t index) const { return depth[index] > 0; }

  /// Of the points with depth; 0 where there are none.
  float MedianDepth() const;

  /// The point in the camera frame; only where HasDepth.
  Eigen::Vector3d PointInCam(size_t index) const {
    return rig->camera.Unproject(points_px[index].x(), points_px[index].y(), depth[index]);
  }
  float InverseVariance(size_t index) const {
    return scales->inverse_variance[static_cast<size_t>(keypoints[index].octave)];
  }
};

using FramePtr = std::shared_ptr<const Frame>;

/// The rows that are not marked, in their order.
template <typename Row>
std::vector<Row> WithoutRows(std::vector<Row> rows, const std::vector<bool>& is_marked) {
  size_t kept = 0;
  for (size_t i = 0; i < rows.size(); ++i) {
    if (!is_marked[i]) rows[kept++] = rows[i];
  }
  rows.resize(kept);
  return rows;
}

/// The frame without the marked points. None of the others is a suspect any longer.
FramePtr WithoutRows(const FramePtr& frame, const std::vector<bool>& is_marked);

}  // namespace yorb
