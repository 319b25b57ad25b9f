// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/people_compose.h"

#include <opencv2/imgproc.hpp>
#include <utility>

#include "detection/letterbox.h"

namespace yorb {
namespace {

const PlainScene& DrawOne(const std::vector<PlainScene>& scenes, Random& random) {
  return scenes[random.Below(static_cast<uint32_t>(scenes.size()))];
}

}  // namespace

PeopleComposer::PeopleComposer(const std::vector<LabelledFile>& masked, PlainScenes scenes,
                               std::vector<cv::Mat> cutouts, const PeopleSceneOptions& options)
    : masked_(masked), scenes_(std::move(scenes)), cutouts_(std::move(cutouts)), options_(options) {}

PeopleComposer::Kind PeopleComposer::DrawKind(Random& random) const {
  const double draw = random.Uniform();
  if (draw < options_.masked || (scenes_.peopled.empty() && scenes_.empty.empty())) return Kind::kMasked;
  const bool is_peopled = draw < options_.masked + options_.peopled;
  return scenes_.empty.empty() || (is_peopled && !scenes_.peopled.empty()) ? Kind::kPeopled : Kind::kEmpty;
}

Result<Scene> PeopleComposer::Compose(const cv::Size& size, Random& random) const {
  const Kind kind = DrawKind(random);
  const auto read = [&] {
    if (kind == Kind::kPeopled) return ReadPlainScene(DrawOne(scenes_.peopled, random));
    if (kind == Kind::kEmpty) return ReadPlainScene(DrawOne(scenes_.empty, random));
    const double set = random.Uniform();
    return ReadMaskedPicture(masked_.Draw(set, random.Uniform()));
  };
  const Result<MaskedPicture> source = read();
  if (!source) return source.error();
  PackedPicture picture;
  picture.pixels = source->pixels;
  Scene scene = ComposeSingle(picture, source->people_mask, size, options_.compose, random);
  PeopleOptions people = options_.people;
  if (kind == Kind::kPeopled) people.share = options_.pasted_among_people;
  if (kind != Kind::kMasked) PastePeople(cutouts_, 0, people, scene, random);
  VaryLight(options_.light, scene.pixels, random);
  return scene;
}

Scene LetterboxMasked(const MaskedPicture& picture, const cv::Size& size) {
  const Letterbox box = FitLetterbox(picture.pixels.size(), size);
  Scene scene{Letterboxed(picture.pixels, box), {}, {}};
  scene.people_mask = cv::Mat(size, CV_8U, cv::Scalar(kMaskUnknown));  // nobody is seen in the bars, nor missed there
  const cv::Rect within(cv::Point(box.left, box.top), box.scaled);
  cv::resize(picture.people_mask, scene.people_mask(within), box.scaled, 0, 0, cv::INTER_NEAREST);
  return scene;
}

}  // namespace yorb
