// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/frame_builder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "features/test_pictures.h"

namespace yorb {
namespace {

Rig FreiburgRig() {
  Rig rig;
  rig.camera.fx = 517.3, rig.camera.fy = 516.5, rig.camera.cx = 318.6, rig.camera.cy = 255.3;
  rig.camera.width = 640, rig.camera.height = 480;
  rig.camera.distortion = {0.2624, -0.9531, -0.0054, 0.0026, 1.1633, 0, 0, 0};
  return rig;
}

/// Depth in metres: 1 + x / 1000, with a hole in the middle.
ImageSet Pictures(bool has_depth) {
  ImageSet images;
  images.timestamp = Timestamp{123456789};
  images.grey = RectanglesPicture(640, 480, 1);
  if (!has_depth) return images;
  images.depth.pixels = cv::Mat(480, 640, CV_16UC1);
  images.depth.metres_per_unit = 1.0 / 5000;
  for (int x = 0; x < 640; ++x) images.depth.pixels.col(x).setTo(5000 + 5 * x);
  images.depth.pixels(cv::Rect(200, 150, 240, 180)).setTo(0);
  return images;
}

TEST(FrameBuilder, RowsBelongTogether) {
  FrameBuilder builder(FeatureOptions(), FreiburgRig());
  const FramePtr frame = builder.Build(FrameId(7), Pictures(true));
  EXPECT_EQ(frame->id, FrameId(7));
  EXPECT_EQ(frame->timestamp, Timestamp{123456789});
  ASSERT_GT(frame->size(), 900u);
  EXPECT_EQ(frame->points_px.size(), frame->size());
  EXPECT_EQ(frame->depth.size(), frame->size());
  EXPECT_EQ(frame->right_px.size(), frame->size());
  EXPECT_EQ(frame->descriptors.size(), frame->size());
  size_t visited = 0;
  frame->grid.VisitNear(320, 240, 5000, [&](uint32_t) { ++visited; });
  EXPECT_EQ(visited, frame->size());
}

TEST(FrameBuilder, PointsAreUndistortedAndStayWithinBounds) {
  const Rig rig = FreiburgRig();
  FrameBuilder builder(FeatureOptions(), rig);
  const FramePtr frame = builder.Build(FrameId(0), Pictures(true));
  for (size_t i = 0; i < frame->size(); ++i) {
    const Eigen::Vector2d real = rig.camera.Distort(frame->points_px[i].cast<double>());
    EXPECT_NEAR(real.x(), frame->keypoints[i].x, 0.05);
    EXPECT_NEAR(real.y(), frame->keypoints[i].y, 0.05);
    EXPECT_TRUE(frame->bounds.Contains(frame->points_px[i].x(), frame->points_px[i].y()));
  }
}

TEST(FrameBuilder, DepthIsReadUnderTheRealPixel) {
  const Rig rig = FreiburgRig();
  FrameBuilder builder(FeatureOptions(), rig);
  const ImageSet pictures = Pictures(true);
  const FramePtr frame = builder.Build(FrameId(0), pictures);
  size_t holes = 0;
  for (size_t i = 0; i < frame->size(); ++i) {
    if (!frame->HasDepth(i)) {
      ++holes;
      EXPECT_EQ(frame->depth[i], 0);
      EXPECT_TRUE(std::isnan(frame->right_px[i]));
      continue;
    }
    const Keypoint& at = frame->keypoints[i];
    const bool is_own = pictures.depth.At(static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y))) > 0;
    EXPECT_NEAR(frame->depth[i], 1 + at.x / 1000, is_own ? 0.0006 : 0.0016) << "beside a hole: a neighbour's";
    const double disparity = frame->points_px[i].x() - frame->right_px[i];
    EXPECT_NEAR(disparity * frame->depth[i], rig.VirtualBaselinePx(), 0.01);
  }
  EXPECT_GT(holes, 50u);
  EXPECT_LT(holes, frame->size() / 2);
}

TEST(FrameBuilder, NoDepthPictureIsNoDepth) {
  FrameBuilder builder(FeatureOptions(), FreiburgRig());
  const FramePtr frame = builder.Build(FrameId(0), Pictures(false));
  ASSERT_GT(frame->size(), 900u);
  for (size_t i = 0; i < frame->size(); ++i) EXPECT_FALSE(frame->HasDepth(i));
}

TEST(ScaleTable, GrowsByTheFactor) {
  const ScaleTable table(8, 1.2);
  ASSERT_EQ(table.levels(), 8);
  for (size_t level = 0; level < 8; ++level) {
    EXPECT_FLOAT_EQ(table.scale[level], static_cast<float>(std::pow(1.2, level)));
    EXPECT_FLOAT_EQ(table.inverse_variance[level], 1 / (table.scale[level] * table.scale[level]));
  }
}

TEST(FrameBuilder, SuspectsComeLastAndMayGo) {
  FrameBuilder builder(FeatureOptions(), FreiburgRig());
  const ImageSet images = Pictures(true);
  const FramePtr whole = builder.Build(FrameId(0), images);
  const size_t half = whole->size() / 2;
  const auto part = [&](size_t first, size_t last) {
    const auto at = [](const auto& rows, size_t i) { return rows.begin() + static_cast<std::ptrdiff_t>(i); };
    return Features{{at(whole->keypoints, first), at(whole->keypoints, last)},
                    {at(whole->descriptors, first), at(whole->descriptors, last)}};
  };
  const FramePtr frame = builder.Build(FrameId(0), images, part(0, half), part(half, whole->size()));
  ASSERT_EQ(frame->size(), whole->size());
  EXPECT_EQ(frame->num_suspects, whole->size() - half);
  EXPECT_FALSE(frame->IsSuspect(half - 1));
  EXPECT_TRUE(frame->IsSuspect(half));
  EXPECT_EQ(frame->depth, whole->depth);

  std::vector<bool> is_marked(frame->size(), false);
  for (size_t i = half; i < frame->size(); ++i) is_marked[i] = i != half + 3;
  const FramePtr rest = WithoutRows(frame, is_marked);
  ASSERT_EQ(rest->size(), half + 1);
  EXPECT_EQ(rest->num_suspects, 0u);
  EXPECT_EQ(rest->descriptors[half], whole->descriptors[half + 3]);
  EXPECT_EQ(rest->depth[half], whole->depth[half + 3]);
  size_t visited = 0;
  rest->grid.VisitNear(320, 240, 5000, [&](uint32_t) { ++visited; });
  EXPECT_EQ(visited, rest->size());
}

}  // namespace
}  // namespace yorb
