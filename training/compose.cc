// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/compose.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace yorb {
namespace {

const cv::Scalar kGrey(114, 114, 114);  // what surrounds a letterboxed picture, in training as in use

/// Where a picture lands: x_in_scene = scale * x_in_picture + shift, for each axis; a negative scale mirrors.
struct Placing {
  double scale_x = 1, scale_y = 1, shift_x = 0, shift_y = 0;
};

/// The scale at which a picture just fits.
double FitScale(const cv::Mat& pixels, const cv::Size& size) {
  return std::min(static_cast<double>(size.width) / pixels.cols, static_cast<double>(size.height) / pixels.rows);
}

/// A position from 0 to 1 of a picture of length `scaled` in a gap of length `room`: within it where it is smaller, so
/// that it fills the gap where it is larger.
double Shift(double room, double scaled, double position) { return (room - scaled) * position; }

void Mirror(Placing& placing, double scaled_width) {
  placing.shift_x += scaled_width;
  placing.scale_x = -placing.scale_x;
}

/// How a picture is cut.
struct Cut {
  cv::Rect tile;  // of the scene, to be filled
  double zoom = 1;
  bool is_close_up = false;
};

/// The position (see Shift) that brings the middle `center` of a thing, in pixels of the scaled picture, to a place
/// well within a gap of length `room`.
double PositionOf(double center, double room, double scaled, Random& random) {
  const double shift = room * random.Uniform(0.15, 0.85) - center;
  return std::abs(room - scaled) < 1 ? 0.5 : std::clamp(shift / (room - scaled), 0.0, 1.0);
}

Placing DrawPlacing(const PackedPicture& picture, const Cut& cut, const ComposeOptions& options, Random& random) {
  const cv::Rect& tile = cut.tile;
  const double range = picture.is_squashed ? options.squashed_aspect : options.log_aspect;
  const double aspect = std::exp(random.Uniform(-range, range));
  const double scale = FitScale(picture.pixels, tile.size()) * cut.zoom;
  Placing placing{.scale_x = scale * std::sqrt(aspect), .scale_y = scale / std::sqrt(aspect)};
  const double width = picture.pixels.cols * placing.scale_x, height = picture.pixels.rows * placing.scale_y;
  double x = random.Uniform(), y = random.Uniform();
  if (cut.is_close_up && !picture.boxes.empty()) {
    const LabelBox& thing = picture.boxes[random.Below(static_cast<uint32_t>(picture.boxes.size()))];
    x = PositionOf(thing.cx * width, tile.width, width, random);
    y = PositionOf(thing.cy * height, tile.height, height, random);
  }
  placing.shift_x = tile.x + Shift(tile.width, width, x);
  placing.shift_y = tile.y + Shift(tile.height, height, y);
  if (random.Uniform() < options.flip) Mirror(placing, width);
  return placing;
}

/// Draws the picture into the tile.
void DrawPicture(const cv::Mat& pixels, const Placing& placing, const cv::Rect& tile, cv::Mat canvas) {
  // Strong reduction by interpolation alone would alias; areas are averaged first.
  cv::Mat source = pixels;
  Placing rest = placing;
  const double least = std::min(std::abs(placing.scale_x), std::abs(placing.scale_y));
  if (least < 0.7) {
    const double k = std::max(least, 0.05);
    cv::resize(pixels, source, cv::Size(), k, k, cv::INTER_AREA);
    rest.scale_x *= static_cast<double>(pixels.cols) / source.cols;
    rest.scale_y *= static_cast<double>(pixels.rows) / source.rows;
  }
  // Positions are of pixel edges; those of warpAffine are of pixel centres, half a pixel further.
  const double dx = rest.shift_x - tile.x + 0.5 * rest.scale_x - 0.5;
  const double dy = rest.shift_y - tile.y + 0.5 * rest.scale_y - 0.5;
  const cv::Matx23d tile_from_source(rest.scale_x, 0, dx, 0, rest.scale_y, dy);
  cv::Mat target = canvas(tile);
  cv::warpAffine(source, target, tile_from_source, tile.size(), cv::INTER_LINEAR, cv::BORDER_CONSTANT, kGrey);
}

/// Draws the picture's mask of people as `DrawPicture` does the picture; nobody is around it.
cv::Mat DrawMask(const cv::Mat& mask, const Placing& placing, const cv::Size& size) {
  const cv::Matx23d scene_from_mask(placing.scale_x, 0, placing.shift_x + 0.5 * placing.scale_x - 0.5, 0,
                                    placing.scale_y, placing.shift_y + 0.5 * placing.scale_y - 0.5);
  cv::Mat drawn;
  cv::warpAffine(mask, drawn, scene_from_mask, size, cv::INTER_NEAREST, cv::BORDER_CONSTANT, kMaskNobody);
  return drawn;
}

/// The boxes as they stand in the scene, cut to the tile.
void AddBoxes(const PackedPicture& picture, const Placing& placing, const cv::Rect& tile, const ComposeOptions& options,
              std::vector<SceneBox>& boxes) {
  const double width = picture.pixels.cols * placing.scale_x, height = picture.pixels.rows * placing.scale_y;
  for (const LabelBox& label : picture.boxes) {
    const double cx = label.cx * width + placing.shift_x, cy = label.cy * height + placing.shift_y;
    const double half_width = label.width * std::abs(width) / 2, half_height = label.height * height / 2;
    const auto cut = [](double value, int from, int length) {
      return static_cast<float>(std::clamp(value, 1.0 * from, 1.0 * from + length));
    };
    SceneBox box{.left = cut(cx - half_width, tile.x, tile.width),
                 .top = cut(cy - half_height, tile.y, tile.height),
                 .right = cut(cx + half_width, tile.x, tile.width),
                 .bottom = cut(cy + half_height, tile.y, tile.height),
                 .class_index = label.class_index};
    const double seen = box.width() * box.height(), whole = 4 * half_width * half_height;
    if (seen <= 0.02 * whole || box.width() < 1 || box.height() < 1) continue;
    box.is_doubtful = label.is_doubtful != 0 || seen < options.kept_part * whole;
    boxes.push_back(box);
  }
}

double DrawZoom(const ComposeOptions& options, Random& random) {
  return std::exp(random.Uniform(-options.log_scale, options.log_scale));
}

/// How a picture fills a whole scene.
Cut DrawWholeCut(const cv::Size& size, const ComposeOptions& options, Random& random) {
  Cut cut{cv::Rect(cv::Point(), size), options.zoom * DrawZoom(options, random), random.Uniform() < options.close_up};
  if (cut.is_close_up) cut.zoom = std::exp(random.Uniform(std::log(1.3), std::log(options.most_close_up)));
  return cut;
}

/// The four tiles of a mosaic around a point near the middle.
std::array<cv::Rect, 4> DrawTiles(const cv::Size& size, Random& random) {
  const int x = static_cast<int>(size.width * random.Uniform(0.3, 0.7));
  const int y = static_cast<int>(size.height * random.Uniform(0.3, 0.7));
  const int w = size.width - x, h = size.height - y;
  return {cv::Rect(0, 0, x, y), cv::Rect(x, 0, w, y), cv::Rect(0, y, x, h), cv::Rect(x, y, w, h)};
}

}  // namespace

Scene ComposeSingle(const PackedPicture& picture, const cv::Mat& people_mask, const cv::Size& size,
                    const ComposeOptions& options, Random& random) {
  const Cut cut = DrawWholeCut(size, options, random);
  const Placing placing = DrawPlacing(picture, cut, options, random);
  Scene scene{cv::Mat(size, CV_8UC3), {}, {}};
  DrawPicture(picture.pixels, placing, cut.tile, scene.pixels);
  AddBoxes(picture, placing, cut.tile, options, scene.boxes);
  if (!people_mask.empty()) scene.people_mask = DrawMask(people_mask, placing, size);
  return scene;
}

Composer::Composer(std::vector<std::shared_ptr<const Pack>> packs, const ClassTable& table) : packs_(std::move(packs)) {
  for (size_t p = 0; p < packs_.size(); ++p) {
    std::vector<int> numbers;
    for (const std::string& name : packs_[p]->class_names()) numbers.push_back(table.Find(name).value_or(-1));
    class_of_.push_back(numbers);
    for (size_t i = 0; i < packs_[p]->size(); ++i) places_.push_back({static_cast<int>(p), i});
  }
}

Composer::Source Composer::GetSource(size_t index) const {
  const Place& place = places_.at(index);
  const std::vector<int>& numbers = class_of_[static_cast<size_t>(place.pack)];
  Source source{packs_[static_cast<size_t>(place.pack)]->Get(place.index), {}};
  std::vector<LabelBox> boxes;
  for (LabelBox box : source.picture.boxes) {
    box.class_index = static_cast<int16_t>(numbers.at(static_cast<size_t>(box.class_index)));
    if (box.class_index >= 0) boxes.push_back(box);
  }
  source.picture.boxes = boxes;
  for (size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] >= 0) source.judged[static_cast<size_t>(numbers[i])] = source.picture.judged[i];
  }
  return source;
}

Scene Composer::Compose(size_t index, const cv::Size& size, const ComposeOptions& options, Random& random) const {
  Scene scene{cv::Mat(size, CV_8UC3), {}, {}};
  const auto add = [&](size_t picture, const Cut& cut) {
    const Source source = GetSource(picture);
    const Placing placing = DrawPlacing(source.picture, cut, options, random);
    DrawPicture(source.picture.pixels, placing, cut.tile, scene.pixels);
    AddBoxes(source.picture, placing, cut.tile, options, scene.boxes);
    return source.judged;
  };
  if (random.Uniform() >= options.mosaic) {
    scene.judged = add(index, DrawWholeCut(size, options, random));
    return scene;
  }
  scene.judged.set();
  for (const cv::Rect& tile : DrawTiles(size, random)) {
    scene.judged &= add(index, {tile, 1.4 * DrawZoom(options, random)});
    index = random.Below(static_cast<uint32_t>(places_.size()));
  }
  return scene;
}

Scene Composer::Letterbox(size_t index, const cv::Size& size) const {
  const Source source = GetSource(index);
  const cv::Mat& pixels = source.picture.pixels;
  const double scale = FitScale(pixels, size);
  const cv::Rect whole(cv::Point(), size);
  const Placing placing{scale, scale, Shift(size.width, pixels.cols * scale, 0.5),
                        Shift(size.height, pixels.rows * scale, 0.5)};
  Scene scene{cv::Mat(size, CV_8UC3), {}, source.judged};
  DrawPicture(pixels, placing, whole, scene.pixels);
  ComposeOptions all;
  all.kept_part = 0;
  AddBoxes(source.picture, placing, whole, all, scene.boxes);
  return scene;
}

}  // namespace yorb
