// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/loader.h"

#include <numeric>

namespace yorb {
namespace {

constexpr uint64_t kOrderStream = 1ull << 62;  // apart from those of the pictures

}  // namespace

Loader::Loader(std::shared_ptr<const Composer> composer, std::vector<cv::Mat> cutouts, const ClassTable& table,
               const LoaderOptions& options, std::function<cv::Size(int64_t)> size_at)
    : composer_(std::move(composer)),
      cutouts_(std::move(cutouts)),
      person_class_(table.Find("person").value_or(-1)),
      num_classes_(table.size()),
      options_(options),
      size_at_(std::move(size_at)) {
  if (person_class_ < 0) cutouts_.clear();
}

size_t Loader::PictureAt(int64_t position) {
  const auto count = static_cast<int64_t>(composer_->size());
  if (position / count != epoch_) {
    epoch_ = position / count;
    order_.resize(composer_->size());
    std::iota(order_.begin(), order_.end(), size_t{0});
    Random random(options_.seed, kOrderStream + static_cast<uint64_t>(epoch_));
    for (size_t i = order_.size(); i > 1; --i) std::swap(order_[i - 1], order_[random.Below(static_cast<uint32_t>(i))]);
  }
  return order_[static_cast<size_t>(position % count)];
}

Batch Loader::Make(int64_t step) {
  const cv::Size size = size_at_(step);
  std::vector<Scene> scenes;
  for (int i = 0; i < options_.batch_size; ++i) {
    const int64_t position = step * options_.batch_size + i;
    const size_t picture = PictureAt(position);
    if (!options_.is_augmented) {
      scenes.push_back(composer_->Letterbox(picture, size));
      continue;
    }
    Random random(options_.seed, static_cast<uint64_t>(position));
    Scene scene = composer_->Compose(picture, size, options_.compose, random);
    PastePeople(cutouts_, person_class_, options_.people, scene, random);
    VaryLight(options_.light, scene.pixels, random);
    scenes.push_back(std::move(scene));
  }
  return MakeBatch(scenes, num_classes_, options_.is_pinned);
}

}  // namespace yorb
