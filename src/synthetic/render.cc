// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic/render.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/check.h"
#include "synthetic/seen_patch.h"

namespace yorb {
namespace {

using Tile = Renderer::Tile;
constexpr int kTileSide = Renderer::kTileSide, kNumSamples = Renderer::kNumSamples;
constexpr int kTilePixels = Renderer::kTilePixels, kTileSamples = Renderer::kTileSamples;
constexpr int kNobody = -1;

// Sample 0 is the centre, for depth; the others stand on a turned grid, for colour.
constexpr std::array<std::array<float, 2>, kNumSamples> kSampleOffsets{
    {{0, 0}, {-0.125f, -0.375f}, {0.375f, -0.125f}, {-0.375f, 0.125f}, {0.125f, 0.375f}}};

// Sampled edges let a hair's breadth overlap, so that neighbours leave no crack between them.
constexpr float kOverlap = 1e-4f;

struct TileBuffer {
  float inverse_depth[kTileSamples];
  int seen[kTileSamples];  // index of the nearest SeenPatch
};

bool MeetsTile(const SeenPatch& patch, const Tile& tile) {
  const auto max = [&](const RayFunction& f) { return f.Max(tile.min_x, tile.max_x, tile.min_y, tile.max_y); };
  const auto minus = [](const RayFunction& a, const RayFunction& b) {
    return RayFunction{a.x - b.x, a.y - b.y, a.one - b.one};
  };
  if (patch.min_x > tile.max_x || patch.max_x < tile.min_x || patch.min_y > tile.max_y || patch.max_y < tile.min_y)
    return false;
  const float slack = kOverlap * patch.max_inverse_depth;
  if (max(patch.s) < -slack || max(patch.t) < -slack || max(patch.inverse_depth) <= 0) return false;
  if (!patch.patch->is_triangle) {
    return max(minus(patch.inverse_depth, patch.s)) >= -slack && max(minus(patch.inverse_depth, patch.t)) >= -slack;
  }
  return max(minus(minus(patch.inverse_depth, patch.s), patch.t)) >= -slack;
}

// Draws one patch into the samples that it is the nearest for. Without branches, so that the compiler makes vectors.
template <bool kIsTriangle>
void Draw(const SeenPatch& patch, int index, const Tile& tile, TileBuffer& buffer) {
  const float nearest = static_cast<float>(1.0 / kNearDepth);
  const RayFunction s = patch.s, t = patch.t, inverse_depth = patch.inverse_depth;
  for (int i = 0; i < kTileSamples; ++i) {
    const float x = tile.x[i], y = tile.y[i];
    const float w = inverse_depth(x, y), a = s(x, y), b = t(x, y);
    const float low = -kOverlap * w, high = (1 + kOverlap) * w;
    const bool inside =
        kIsTriangle ? (a >= low) & (b >= low) & (a + b <= high) : (a >= low) & (b >= low) & (a <= high) & (b <= high);
    const bool wins = inside & (w > buffer.inverse_depth[i]) & (w < nearest);
    buffer.inverse_depth[i] = wins ? w : buffer.inverse_depth[i];
    buffer.seen[i] = wins ? index : buffer.seen[i];
  }
}

void FillTile(const std::vector<SeenPatch>& patches, const std::vector<int>& nearest_first, const Tile& tile,
              TileBuffer& buffer) {
  std::fill(std::begin(buffer.inverse_depth), std::end(buffer.inverse_depth), 0.f);
  std::fill(std::begin(buffer.seen), std::end(buffer.seen), kNobody);
  int num_drawn = 0;
  float farthest = 0;  // smallest inverse depth in the tile
  for (const int index : nearest_first) {
    const SeenPatch& patch = patches[index];
    if (patch.max_inverse_depth < farthest) break;  // and so are all that follow
    if (!MeetsTile(patch, tile)) continue;
    if (patch.inverse_depth.Max(tile.min_x, tile.max_x, tile.min_y, tile.max_y) < farthest) continue;
    patch.patch->is_triangle ? Draw<true>(patch, index, tile, buffer) : Draw<false>(patch, index, tile, buffer);
    if (++num_drawn % 2 == 0)
      farthest = *std::min_element(std::begin(buffer.inverse_depth), std::end(buffer.inverse_depth));
  }
}

float ShadowAt(const std::vector<FloorShadow>& shadows, const Eigen::Vector3f& x_in_world) {
  float light = 1;
  for (const FloorShadow& shadow : shadows) {
    const float distance2 = (x_in_world.head<2>() - shadow.centre).squaredNorm() / (shadow.radius * shadow.radius);
    if (distance2 < 6) light *= 1 - shadow.strength * std::exp(-distance2);
  }
  return light;
}

// The colour of a patch along a ray; `step_x` and `step_y` are a pixel's size on the plane z = 1.
Eigen::Array3f Shade(const Scene& scene, const MovingThings& moving, const SeenPatch& seen, float x, float y,
                     const Eigen::Vector2f& step) {
  const Patch& patch = *seen.patch;
  const float z = 1 / seen.inverse_depth(x, y);
  const float s = seen.s(x, y) * z, t = seen.t(x, y) * z;
  const Eigen::Vector2f uv = patch.uv + s * patch.uv_s + t * patch.uv_t;
  // d(s)/dx = d(a/w)/dx = (da/dx - s dw/dx) / w.
  const auto moved = [&](float s_slope, float t_slope, float w_slope, float size) -> Eigen::Vector2f {
    return ((s_slope - s * w_slope) * z * size) * patch.uv_s + ((t_slope - t * w_slope) * z * size) * patch.uv_t;
  };
  const Eigen::Vector2f right = moved(seen.s.x, seen.t.x, seen.inverse_depth.x, step.x());
  const Eigen::Vector2f down = moved(seen.s.y, seen.t.y, seen.inverse_depth.y, step.y());
  float light = patch.light_map >= 0 ? scene.light_maps[patch.light_map].At(s, t)
                                     : patch.light + s * patch.light_s + t * patch.light_t;
  if (patch.is_floor) light *= ShadowAt(moving.shadows, patch.At(s, t));
  return scene.textures[patch.texture].Sample(uv, right, down) * light;
}

// One pixel's colour: each patch that its four samples see is shaded once, amid these samples.
class PixelShader {
 public:
  PixelShader(const Scene& scene, const MovingThings& moving, const std::vector<SeenPatch>& seen, const Pinhole& camera)
      : scene_(scene),
        moving_(moving),
        seen_(seen),
        step_(static_cast<float>(1 / camera.fx), static_cast<float>(1 / camera.fy)) {}

  Eigen::Array3f operator()(const Tile& tile, const TileBuffer& buffer, int pixel) const {
    const int first = buffer.seen[kTilePixels + pixel];
    bool same = true;
    for (int k = 2; k < kNumSamples; ++k) same &= buffer.seen[k * kTilePixels + pixel] == first;
    if (same) return first == kNobody ? Eigen::Array3f::Zero() : Colour(first, tile.x[pixel], tile.y[pixel]);
    Eigen::Array3f sum = Eigen::Array3f::Zero();
    for (int k = 1; k < kNumSamples; ++k) {
      const int here = buffer.seen[k * kTilePixels + pixel];
      float x = 0, y = 0, count = 0;
      bool is_new = here != kNobody;
      for (int j = 1; j < kNumSamples; ++j) {
        const int i = j * kTilePixels + pixel;
        if (buffer.seen[i] != here) continue;
        is_new &= j >= k;
        x += tile.x[i], y += tile.y[i], count += 1;
      }
      if (is_new) sum += count * Colour(here, x / count, y / count);
    }
    return sum / (kNumSamples - 1.f);
  }

 private:
  Eigen::Array3f Colour(int index, float x, float y) const { return Shade(scene_, moving_, seen_[index], x, y, step_); }

  const Scene& scene_;
  const MovingThings& moving_;
  const std::vector<SeenPatch>& seen_;
  const Eigen::Vector2f step_;
};

std::vector<SeenPatch> SeeAll(const Scene& scene, const MovingThings& moving, const Rigid3& cam_from_world) {
  std::vector<SeenPatch> seen;
  for (const auto* patches : {&scene.patches, &moving.patches}) {
    for (const Patch& patch : *patches) {
      if (const auto visible = SeePatch(patch, cam_from_world)) seen.push_back(*visible);
    }
  }
  std::stable_sort(seen.begin(), seen.end(),
                   [](const SeenPatch& a, const SeenPatch& b) { return a.max_inverse_depth > b.max_inverse_depth; });
  return seen;
}

Tile MakeTile(const Pinhole& camera, int left, int top) {
  std::vector<Eigen::Vector2f> pixels;
  for (const auto& offset : kSampleOffsets) {
    for (int i = 0; i < kTilePixels; ++i) {
      // What sticks out of the picture repeats its border: a lens need not be good beyond it.
      const int x = std::min(left + i % kTileSide, camera.width - 1),
                y = std::min(top + i / kTileSide, camera.height - 1);
      pixels.emplace_back(static_cast<float>(x) + offset[0], static_cast<float>(y) + offset[1]);
    }
  }
  if (camera.HasDistortion()) pixels = camera.Undistort(pixels);
  Tile tile;
  for (int i = 0; i < kTileSamples; ++i) {
    tile.x[i] = static_cast<float>((pixels[i].x() - camera.cx) / camera.fx);
    tile.y[i] = static_cast<float>((pixels[i].y() - camera.cy) / camera.fy);
  }
  const auto [left_most, right_most] = std::minmax_element(std::begin(tile.x), std::end(tile.x));
  const auto [top_most, bottom_most] = std::minmax_element(std::begin(tile.y), std::end(tile.y));
  tile.min_x = *left_most;
  tile.max_x = *right_most;
  tile.min_y = *top_most;
  tile.max_y = *bottom_most;
  return tile;
}

// Which patches may meet a row of tiles; their order stays, nearest first.
std::vector<int> FindInRow(const std::vector<SeenPatch>& seen, const Tile* row, int num_tiles) {
  float min_y = row->min_y, max_y = row->max_y;
  for (int i = 1; i < num_tiles; ++i) {
    min_y = std::min(min_y, row[i].min_y);
    max_y = std::max(max_y, row[i].max_y);
  }
  std::vector<int> in_row;
  for (size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].min_y <= max_y && seen[i].max_y >= min_y) in_row.push_back(static_cast<int>(i));
  }
  return in_row;
}

void WriteTile(const std::vector<SeenPatch>& seen, const PixelShader& shade, const Tile& tile, const TileBuffer& buffer,
               RenderedView corner) {
  for (int y = 0; y < corner.colour.rows; ++y) {
    for (int x = 0; x < corner.colour.cols; ++x) {
      const int i = y * kTileSide + x;
      const Eigen::Array3f colour = shade(tile, buffer, i);
      for (int c = 0; c < 3; ++c) corner.colour.at<cv::Vec3b>(y, x)[c] = cv::saturate_cast<uchar>(colour[c]);
      if (buffer.seen[i] == kNobody) continue;
      corner.depth.at<float>(y, x) = 1 / buffer.inverse_depth[i];
      corner.mask.at<uchar>(y, x) = static_cast<uchar>(seen[buffer.seen[i]].patch->person);
    }
  }
}

}  // namespace

Renderer::Renderer(const Pinhole& camera) : camera_(camera) {
  YORB_CHECK(camera.width > 0 && camera.height > 0 && camera.fx > 0 && camera.fy > 0,
             "a renderer needs a picture size");
  tile_columns_ = (camera.width + kTileSide - 1) / kTileSide;
  tile_rows_ = (camera.height + kTileSide - 1) / kTileSide;
  for (int row = 0; row < tile_rows_; ++row) {
    for (int column = 0; column < tile_columns_; ++column) {
      tiles_.push_back(MakeTile(camera, column * kTileSide, row * kTileSide));
    }
  }
}

RenderedView Renderer::Render(const Scene& scene, const MovingThings& moving, const Rigid3& world_from_cam) const {
  RenderedView view{cv::Mat(camera_.height, camera_.width, CV_8UC3, cv::Scalar::all(0)),
                    cv::Mat(camera_.height, camera_.width, CV_32FC1, cv::Scalar::all(0)),
                    cv::Mat(camera_.height, camera_.width, CV_8UC1, cv::Scalar::all(0))};
  const cv::Rect picture(0, 0, camera_.width, camera_.height);
  const std::vector<SeenPatch> seen = SeeAll(scene, moving, world_from_cam.Inverse());
  const PixelShader shade(scene, moving, seen, camera_);
  TileBuffer buffer;
  for (int row = 0; row < tile_rows_; ++row) {
    const Tile* tiles = tiles_.data() + static_cast<size_t>(row) * tile_columns_;
    const std::vector<int> in_row = FindInRow(seen, tiles, tile_columns_);
    for (int column = 0; column < tile_columns_; ++column) {
      FillTile(seen, in_row, tiles[column], buffer);
      const cv::Rect here = cv::Rect(column * kTileSide, row * kTileSide, kTileSide, kTileSide) & picture;
      WriteTile(seen, shade, tiles[column], buffer, {view.colour(here), view.depth(here), view.mask(here)});
    }
  }
  return view;
}

}  // namespace yorb
