// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Which pixels Resize and Upsample take: ONNX has several ways to place a pixel of the large picture in the small one,
// and four to round that place.
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "detection/engine.h"
#include "detection/net_program.h"

namespace yorb {
namespace {

/// One axis of a picture before and after, in pixels.
struct ResizedAxis {
  int64_t from = 0, to = 0;
  double scale = 1;

  bool IsAtWholeFactor() const { return scale >= 1 && scale == std::floor(scale); }
};
using ResizedAxes = std::array<ResizedAxis, 2>;  // y, x

/// How the nearest pixel is chosen, in the words of the file.
struct NearestWay {
  std::string place, rounding;
};

/// Four numbers that are known beforehand; nothing for anything else.
std::vector<float> FourOf(const NetNode& node, size_t input) {
  if (!node.Has(input) || !node.inputs[input].is_constant || node.inputs[input].size() != 4) return {};
  return NumbersOf(node.inputs[input]);
}

/// The axes of the picture; nothing where others change, too, or the new size is not known beforehand.
std::optional<ResizedAxes> AxesOf(const NetNode& node) {
  constexpr double kLargest = 1 << 16;  // px
  const std::vector<int64_t>& from = node.inputs[0].dims;
  std::vector<float> scales, sizes = FourOf(node, 3);
  if (const OnnxAttribute* found = node.node.Find("scales")) scales = found->floats;
  for (const size_t input : {size_t{1}, size_t{2}}) {  // newer files have a region of interest before it
    if (const auto found = FourOf(node, input); !found.empty()) scales = found;
  }
  if (scales.size() != 4 && sizes.empty()) return std::nullopt;
  std::array<ResizedAxis, 4> axes;
  for (size_t i = 0; i < 4; ++i) {
    const auto before = static_cast<double>(from[i]);
    const double scale = sizes.empty() ? scales[i] : sizes[i] / before;
    const double after = sizes.empty() ? std::floor(before * scale + 1e-6) : sizes[i];
    if (!(before >= 1 && after >= 1 && after <= kLargest)) return std::nullopt;
    axes[i] = {from[i], static_cast<int64_t>(after), scale};
  }
  if (axes[0].scale != 1 || axes[1].scale != 1) return std::nullopt;
  return ResizedAxes{axes[2], axes[3]};
}

/// Nothing where it is not the nearest pixel, or chosen in a way that is not known.
std::optional<NearestWay> WayOf(const NetNode& node) {
  if (node.node.Text("mode", "nearest") != "nearest") return std::nullopt;
  if (node.node.op == "Upsample" || node.opset < 11) return NearestWay{"asymmetric", "floor"};
  NearestWay way{node.node.Text("coordinate_transformation_mode", "half_pixel"),
                 node.node.Text("nearest_mode", "round_prefer_floor")};
  const auto is_one_of = [](const std::string& word, std::initializer_list<const char*> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  const bool is_known = is_one_of(way.place, {"half_pixel", "half_pixel_symmetric", "pytorch_half_pixel", "asymmetric",
                                              "align_corners", "tf_half_pixel_for_nn"}) &&
                        is_one_of(way.rounding, {"floor", "ceil", "round_prefer_floor", "round_prefer_ceil"});
  return is_known ? std::optional(way) : std::nullopt;
}

/// Where a pixel of the large picture lies in the small one, as ONNX defines it.
double PlaceOf(int64_t x, const ResizedAxis& axis, const std::string& place) {
  const auto at = static_cast<double>(x), from = static_cast<double>(axis.from), to = static_cast<double>(axis.to);
  if (place == "asymmetric") return at / axis.scale;
  if (place == "align_corners") return axis.to > 1 ? at * (from - 1) / (to - 1) : 0;
  if (place == "tf_half_pixel_for_nn") return (at + .5) / axis.scale;
  if (place == "pytorch_half_pixel" && axis.to == 1) return 0;
  const double shift = place == "half_pixel_symmetric" ? from / 2 * (1 - to / (axis.scale * from)) : 0;
  return shift + (at + .5) / axis.scale - .5;
}

int64_t NearestPixel(int64_t x, const ResizedAxis& axis, const NearestWay& way) {
  const double place = PlaceOf(x, axis, way.place);
  const double pixel = way.rounding == "floor"               ? std::floor(place)
                       : way.rounding == "ceil"              ? std::ceil(place)
                       : way.rounding == "round_prefer_ceil" ? std::floor(place + .5)
                                                             : std::ceil(place - .5);
  return std::clamp(static_cast<int64_t>(pixel), int64_t{0}, axis.from - 1);
}

/// OpenCV 4.6 knows two ways, whatever the file says.
int64_t PixelOfOpenCv(int64_t x, const ResizedAxis& axis, const NearestWay& way) {
  const auto from = static_cast<double>(axis.from), to = static_cast<double>(axis.to), at = static_cast<double>(x);
  const double pixel =
      way.place == "align_corners" ? std::round(PlaceOf(x, axis, way.place)) : std::floor(at * (1 / (to / from)));
  return std::min(static_cast<int64_t>(pixel), axis.from - 1);
}

/// Between pixels OpenCV goes by the ratio of the sizes, ONNX by the scale: another one where a part of a pixel is
/// over.
bool IsLinearOfParts(const NetNode& node, const ResizedAxes& axes) {
  if (node.node.Text("mode", "nearest") != "linear") return false;
  if (node.node.Text("coordinate_transformation_mode", "half_pixel") == "align_corners") return false;
  return std::any_of(axes.begin(), axes.end(), [](const ResizedAxis& axis) {
    return std::abs(static_cast<double>(axis.from) * axis.scale - static_cast<double>(axis.to)) > 1e-3;
  });
}

/// Whether pixel(x, axis) is the nearest everywhere.
template <typename F>
bool AreNearest(const ResizedAxes& axes, const NearestWay& way, const F& pixel) {
  for (const ResizedAxis& axis : axes) {
    for (int64_t x = 0; x < axis.to; ++x) {
      if (NearestPixel(x, axis, way) != pixel(x, axis)) return false;
    }
  }
  return true;
}

}  // namespace

Result<std::pair<int64_t, int64_t>> EnlargementOf(const NetNode& node) {
  if (!node.Has(0) || node.inputs[0].rank() != 4) return BadInput(": only pictures are read");
  const auto axes = AxesOf(node);
  const auto way = WayOf(node);
  const Error unread = BadInput(": only the nearest pixel at a whole factor is read");
  if (axes && IsLinearOfParts(node, *axes)) {
    return BadInput(std::string(": linear scales with a part of a pixel left over are not read") + kNorByOpenCv +
                    "; export it with sizes in place of scales");
  }
  if (!axes || !way) return unread;
  const auto factor = [](const ResizedAxis& axis) { return static_cast<int64_t>(axis.scale); };
  const auto in_block = [&](int64_t x, const ResizedAxis& axis) { return x / factor(axis); };
  const auto of_opencv = [&](int64_t x, const ResizedAxis& axis) { return PixelOfOpenCv(x, axis, *way); };
  const auto& [y, x] = *axes;
  if (y.IsAtWholeFactor() && x.IsAtWholeFactor() && AreNearest(*axes, *way, in_block))
    return std::pair(factor(y), factor(x));
  if (AreNearest(*axes, *way, of_opencv)) return unread;
  return BadInput(": the pixels that it takes for the nearest (" + way->place + ", " + way->rounding +
                  ") are not read" + kNorByOpenCv + "; export it with asymmetric and floor");
}

}  // namespace yorb
