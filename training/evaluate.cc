// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/evaluate.h"

#include <algorithm>

#include "training/batch.h"

namespace yorb {

Evaluation Evaluate(Network network, const Composer& pictures, const cv::Size& size, const torch::Device& device) {
  constexpr size_t kBatch = 16;
  const torch::NoGradGuard no_grad;
  network->eval();
  std::vector<JudgedPicture> judged;
  for (size_t first = 0; first < pictures.size(); first += kBatch) {
    std::vector<Scene> scenes;
    for (size_t i = first; i < std::min(pictures.size(), first + kBatch); ++i)
      scenes.push_back(pictures.Letterbox(i, size));
    const Batch batch = MakeBatch(scenes, network->layout.num_classes);
    auto found = DecodeBoxes(network(ToInput(batch.pictures, device)), network->layout, {});
    for (size_t i = 0; i < scenes.size(); ++i) judged.push_back({scenes[i].boxes, std::move(found[i])});
  }
  Evaluation evaluation{.classes = ScoreClasses(judged, network->layout.num_classes)};
  for (const ClassScore& score : evaluation.classes) {
    evaluation.map50 += score.ap50 / static_cast<double>(evaluation.classes.size());
    evaluation.map += score.ap / static_cast<double>(evaluation.classes.size());
  }
  return evaluation;
}

}  // namespace yorb
