// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/batch.h"

#include <opencv2/imgproc.hpp>

#include "core/check.h"

namespace yorb {

Batch MakeBatch(const std::vector<Scene>& scenes, int num_classes, bool is_pinned) {
  YORB_CHECK(!scenes.empty(), "a batch has pictures");
  const int64_t count = static_cast<int64_t>(scenes.size());
  const cv::Size size = scenes.front().pixels.size();
  Batch batch;
  batch.pictures =
      torch::empty({count, size.height, size.width, 3}, torch::TensorOptions(torch::kUInt8).pinned_memory(is_pinned));
  batch.judged = torch::zeros({count, num_classes});
  auto judged = batch.judged.accessor<float, 2>();
  for (int64_t i = 0; i < count; ++i) {
    const Scene& scene = scenes[static_cast<size_t>(i)];
    YORB_CHECK(scene.pixels.size() == size, "the pictures of a batch are of one size");
    cv::Mat target(size, CV_8UC3, batch.pictures[i].data_ptr<uint8_t>());
    cv::cvtColor(scene.pixels, target, cv::COLOR_BGR2RGB);
    for (const SceneBox& box : scene.boxes) batch.targets.push_back({static_cast<int>(i), box});
    for (int c = 0; c < num_classes; ++c) judged[i][c] = scene.judged[static_cast<size_t>(c)] ? 1.0f : 0.0f;
  }
  return batch;
}

torch::Tensor ToInput(const torch::Tensor& pictures, const torch::Device& device) {
  // Permuting (B, H, W, 3) gives a tensor that is channels-last in memory already.
  return pictures.to(device, /*non_blocking=*/true).permute({0, 3, 1, 2}).to(torch::kFloat32).div(255.0);
}

}  // namespace yorb
