// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/people.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "pictures/picture_file.h"
#include "training/picture_set.h"

namespace yorb {
namespace {

/// Hides part of a person: what is below a line, or on one side of one.
void HidePart(cv::Mat cutout, Random& random) {
  const double kept = random.Uniform(0.35, 0.9);
  const int rows = cutout.rows, cols = cutout.cols;
  switch (random.Below(4)) {
    case 0:
      cutout.colRange(static_cast<int>(cols * kept), cols).setTo(cv::Scalar::all(0));
      break;
    case 1:
      cutout.colRange(0, static_cast<int>(cols * (1 - kept))).setTo(cv::Scalar::all(0));
      break;
    default:
      cutout.rowRange(static_cast<int>(rows * kept), rows).setTo(cv::Scalar::all(0));
      break;
  }
}

/// Other clothes and another light: gains of the colours, contrast and brightness.
void ShiftColours(cv::Mat cutout, Random& random) {
  const double gain = std::exp(random.Uniform(-0.5, 0.4)), offset = random.Uniform(-25, 25);
  cv::Scalar gains(gain, gain, gain, 1);
  for (int channel = 0; channel < 3; ++channel) gains[channel] *= std::exp(random.Uniform(-0.15, 0.15));
  cv::multiply(cutout, gains, cutout);
  cv::add(cutout, cv::Scalar(offset, offset, offset, 0), cutout);
  if (random.Uniform() < 0.25) {  // a turn of the hues, by permuting the colours
    std::vector<cv::Mat> planes;
    cv::split(cutout, planes);
    std::swap(planes[random.Below(3)], planes[random.Below(3)]);
    cv::merge(planes, cutout);
  }
}

cv::Mat DrawPerson(const cv::Mat& cutout, const cv::Size& scene, const PeopleOptions& options, Random& random) {
  const double log_size = random.Uniform(std::log(options.least_size), std::log(options.largest_size));
  const double height = std::exp(log_size) * scene.height;
  const double aspect = std::exp(random.Uniform(-0.15, 0.15));
  const cv::Size size(std::max(4, static_cast<int>(height * cutout.cols / cutout.rows * aspect)),
                      std::max(8, static_cast<int>(height)));
  cv::Mat person;
  cv::resize(cutout, person, size, 0, 0, size.height < cutout.rows ? cv::INTER_AREA : cv::INTER_LINEAR);
  if (random.Uniform() < 0.5) cv::flip(person, person, 1);
  if (random.Uniform() < options.cut_share) HidePart(person, random);
  ShiftColours(person, random);
  return person;
}

/// Blends the person into the scene, its corner at `at`, and gives what it covers: CV_8U, the size of the scene.
cv::Mat Blend(const cv::Mat& person, const cv::Point& at, cv::Mat pixels) {
  cv::Mat covered = cv::Mat::zeros(pixels.size(), CV_8U);
  const cv::Rect in_scene = cv::Rect(at, person.size()) & cv::Rect(cv::Point(), pixels.size());
  if (in_scene.empty()) return covered;
  const cv::Mat part = person(in_scene - at);
  for (int y = 0; y < part.rows; ++y) {
    const auto* from = part.ptr<cv::Vec4b>(y);
    auto* to = pixels.ptr<cv::Vec3b>(in_scene.y + y) + in_scene.x;
    auto* mask = covered.ptr<uint8_t>(in_scene.y + y) + in_scene.x;
    for (int x = 0; x < part.cols; ++x) {
      const int alpha = from[x][3];
      for (int c = 0; c < 3; ++c)
        to[x][c] = static_cast<uint8_t>((from[x][c] * alpha + to[x][c] * (255 - alpha)) / 255);
      mask[x] = alpha > 127 ? 1 : 0;
    }
  }
  return covered;
}

/// Whether less than a quarter of a box is left when `covered` stands before it.
bool IsHidden(const SceneBox& box, const cv::Mat& covered) {
  const cv::Rect all(cv::Point(), covered.size());
  const cv::Rect area = cv::Rect(cv::Point(static_cast<int>(box.left), static_cast<int>(box.top)),
                                 cv::Point(static_cast<int>(box.right), static_cast<int>(box.bottom))) &
                        all;
  return !area.empty() && cv::countNonZero(covered(area)) > 0.75 * area.area();
}

/// Puts a piece of the scene as it was before, or a dark plate as of a screen, in front of the person; what it covers
/// is taken out of `covered`.
void Occlude(const Scene& before, cv::Mat covered, Scene& scene, Random& random) {
  const cv::Rect person = cv::boundingRect(covered), all(cv::Point(), covered.size());
  const cv::Size size(std::max(2, static_cast<int>(person.width * random.Uniform(0.3, 1.0))),
                      std::max(2, static_cast<int>(person.height * random.Uniform(0.2, 0.6))));
  const cv::Point at(person.x + static_cast<int>(person.width * random.Uniform(-0.3, 0.8)),
                     person.y + static_cast<int>(person.height * random.Uniform(0.3, 0.9)));
  const cv::Rect plate = cv::Rect(at, size) & all;
  if (plate.empty()) return;
  const cv::Point from(static_cast<int>(random.Below(static_cast<uint32_t>(covered.cols - plate.width + 1))),
                       static_cast<int>(random.Below(static_cast<uint32_t>(covered.rows - plate.height + 1))));
  const cv::Rect piece(from, plate.size());
  const bool is_piece = random.Uniform() < 0.5, has_mask = !scene.people_mask.empty();
  if (is_piece)
    before.pixels(piece).copyTo(scene.pixels(plate));
  else
    scene.pixels(plate).setTo(cv::Scalar::all(random.Uniform(5, 60)));
  if (has_mask && is_piece) before.people_mask(piece).copyTo(scene.people_mask(plate));
  if (has_mask && !is_piece) scene.people_mask(plate).setTo(kMaskNobody);
  covered(plate).setTo(0);
}

void PasteOne(const cv::Mat& person, const PeopleOptions& options, int person_class, Scene& scene, Random& random) {
  // The middle may lie nearly anywhere, so that head, legs or a side are out of the picture.
  const int x = static_cast<int>(random.Uniform(-0.1, 1.1) * scene.pixels.cols - person.cols / 2.0);
  const int y = static_cast<int>(random.Uniform(-0.1, 1.0) * scene.pixels.rows - person.rows / 2.0);
  const Scene before{scene.pixels.clone(), {}, {}, scene.people_mask.clone()};
  cv::Mat covered = Blend(person, cv::Point(x, y), scene.pixels);
  std::erase_if(scene.boxes, [&](const SceneBox& box) { return IsHidden(box, covered); });
  if (!scene.people_mask.empty()) scene.people_mask.setTo(kMaskPerson, covered);
  if (cv::countNonZero(covered) > 0 && random.Uniform() < options.occluded_share)
    Occlude(before, covered, scene, random);
  const cv::Rect seen = cv::boundingRect(covered);
  if (seen.width < 4 || seen.height < 4) return;
  // A sleeve at the border may or may not be called a person.
  const int num_seen = cv::countNonZero(covered), num_whole = std::max(1, person.rows * person.cols / 3);
  scene.boxes.push_back({.left = static_cast<float>(seen.x),
                         .top = static_cast<float>(seen.y),
                         .right = static_cast<float>(seen.br().x),
                         .bottom = static_cast<float>(seen.br().y),
                         .class_index = person_class,
                         .is_doubtful = num_seen < 0.08 * num_whole || num_seen < 0.2 * seen.area()});
}

}  // namespace

Result<std::vector<cv::Mat>> ReadCutouts(const std::string& folder) {
  const auto files = FindLabelledFiles(folder);
  if (!files) return files.error();
  std::vector<cv::Mat> cutouts;
  for (const LabelledFile& file : *files) {
    const cv::Mat cutout = ReadPictureFile(file.picture).pixels;
    if (cutout.type() != CV_8UC4)
      return BadInput(file.picture + ": is no picture with transparency (RGBA, 8 bits), as cut-outs of people are");
    cutouts.push_back(cutout);
  }
  return cutouts;
}

void PastePeople(const std::vector<cv::Mat>& cutouts, int person_class, const PeopleOptions& options, Scene& scene,
                 Random& random) {
  if (cutouts.empty() || random.Uniform() >= options.share) return;
  const uint32_t count = 1 + random.Below(static_cast<uint32_t>(options.most));
  for (uint32_t i = 0; i < count; ++i) {
    const cv::Mat& cutout = cutouts[random.Below(static_cast<uint32_t>(cutouts.size()))];
    PasteOne(DrawPerson(cutout, scene.pixels.size(), options, random), options, person_class, scene, random);
  }
}

}  // namespace yorb
