// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/loss.h"

#include <cmath>

#include "training/assign.h"

namespace yorb {
namespace {

namespace F = torch::nn::functional;

torch::Tensor AsIndex(const std::vector<int64_t>& values, const torch::Device& device) {
  return torch::tensor(values, torch::kInt64).to(device);
}

torch::Tensor AsRows(const std::vector<float>& values, int64_t columns, const torch::Device& device) {
  return torch::tensor(values, torch::kFloat32).view({-1, columns}).to(device);
}

/// `unjudged` where the network sees a class that the picture is not judged for, more than any that it is; 1 elsewhere.
torch::Tensor BackgroundWeights(const torch::Tensor& map, const torch::Tensor& judged, double unjudged) {
  const torch::NoGradGuard no_grad;
  const torch::Tensor classes = map.slice(4, 5);
  const torch::Tensor known = judged.view({judged.size(0), 1, 1, 1, -1});
  constexpr double kNever = 1e4;
  const torch::Tensor best_known = (classes - (1 - known) * kNever).amax(4);
  const torch::Tensor best_unknown = (classes - known * kNever).amax(4);
  return 1 - (1 - unjudged) * ((best_unknown > best_known) & (best_unknown > 0)).to(torch::kFloat32);
}

struct LevelLoss {
  torch::Tensor box, objectness, classes;
};

LevelLoss LossOfLevel(const torch::Tensor& map, const LevelAssignment& level, const torch::Tensor& judged,
                      const LossOptions& options) {
  const torch::Device device = map.device();
  const int64_t num_classes = map.size(4) - 5;
  torch::Tensor objectness = torch::zeros(map.sizes().slice(0, 4), map.options());
  torch::Tensor weights = BackgroundWeights(map, judged, options.unjudged);
  if (level.doubtful.size() > 0) weights.index_put_(CellIndex(level.doubtful, device), torch::zeros({}, map.options()));
  LevelLoss loss{torch::zeros({}, map.options()), {}, torch::zeros({}, map.options())};
  if (level.sure.size() > 0) {
    const auto cells = CellIndex(level.sure, device);
    const torch::Tensor logits = map.index(cells);
    const torch::Tensor boxes = DecodeAtCells(logits, AsRows(level.sure.anchors, 2, device));
    const torch::Tensor iou = CompleteIou(boxes, AsRows(level.sure.boxes, 4, device));
    loss.box = (1 - iou).mean();
    objectness.index_put_(cells, iou.detach().clamp_min(0));
    weights.index_put_(cells, torch::ones({}, map.options()));
    const torch::Tensor wanted = F::one_hot(AsIndex(level.sure.class_index, device), num_classes).to(torch::kFloat32);
    const torch::Tensor counts =
        torch::maximum(judged.index({AsIndex(level.sure.picture, device)}), wanted).clamp_min(options.unjudged);
    const torch::Tensor entropy = F::binary_cross_entropy_with_logits(
        logits.slice(1, 5), wanted, F::BinaryCrossEntropyWithLogitsFuncOptions().weight(counts).reduction(torch::kSum));
    loss.classes = entropy / static_cast<double>(level.sure.size()) / static_cast<double>(num_classes);
  }
  loss.objectness = F::binary_cross_entropy_with_logits(map.select(4, 4), objectness,
                                                        F::BinaryCrossEntropyWithLogitsFuncOptions().weight(weights));
  return loss;
}

}  // namespace

torch::Tensor ByCells(const torch::Tensor& map) {
  return map.permute({0, 2, 3, 1}).reshape({map.size(0), map.size(2), map.size(3), 3, -1}).to(torch::kFloat32);
}

std::vector<at::indexing::TensorIndex> CellIndex(const Assignment& cells, const torch::Device& device) {
  return {AsIndex(cells.picture, device), AsIndex(cells.row, device), AsIndex(cells.column, device),
          AsIndex(cells.anchor, device)};
}

torch::Tensor DecodeAtCells(const torch::Tensor& logits, const torch::Tensor& anchors) {
  const torch::Tensor part = logits.slice(1, 0, 4).sigmoid() * 2;
  return torch::cat({part.slice(1, 0, 2) - 0.5, part.slice(1, 2, 4).square() * anchors}, 1);
}

torch::Tensor WantedObjectness(const torch::Tensor& map, const Assignment& cells) {
  const torch::NoGradGuard no_grad;
  const torch::Device device = map.device();
  const torch::Tensor boxes = DecodeAtCells(map.index(CellIndex(cells, device)), AsRows(cells.anchors, 2, device));
  return CompleteIou(boxes, AsRows(cells.boxes, 4, device)).clamp_min(0);
}

torch::Tensor CompleteIou(const torch::Tensor& a, const torch::Tensor& b) {
  const double epsilon = 1e-7;
  const torch::Tensor a_center = a.slice(1, 0, 2), b_center = b.slice(1, 0, 2);
  const torch::Tensor a_size = a.slice(1, 2, 4), b_size = b.slice(1, 2, 4);
  const torch::Tensor a_low = a_center - a_size / 2, a_high = a_center + a_size / 2;
  const torch::Tensor b_low = b_center - b_size / 2, b_high = b_center + b_size / 2;
  const torch::Tensor both = (torch::minimum(a_high, b_high) - torch::maximum(a_low, b_low)).clamp_min(0).prod(1);
  const torch::Tensor either = a_size.prod(1) + b_size.prod(1) - both + epsilon;
  const torch::Tensor iou = both / either;
  const torch::Tensor hull = torch::maximum(a_high, b_high) - torch::minimum(a_low, b_low);
  const torch::Tensor diagonal = hull.square().sum(1) + epsilon;
  const torch::Tensor distance = (a_center - b_center).square().sum(1);
  const torch::Tensor angle_a = torch::atan(a_size.select(1, 0) / (a_size.select(1, 1) + epsilon));
  const torch::Tensor angle_b = torch::atan(b_size.select(1, 0) / (b_size.select(1, 1) + epsilon));
  const torch::Tensor aspect = (angle_b - angle_a).square() * (4 / (M_PI * M_PI));
  const torch::Tensor weight = (aspect / (1 - iou + aspect + epsilon)).detach();
  return iou - distance / diagonal - weight * aspect;
}

Loss DetectionLoss(const std::array<torch::Tensor, 3>& maps, const Batch& batch, const Layout& layout,
                   const LossOptions& options) {
  Loss loss;
  torch::Tensor sum;
  const double num_pictures = static_cast<double>(batch.pictures.size(0));
  for (size_t i = 0; i < maps.size(); ++i) {
    const torch::Tensor map = ByCells(maps[i]);
    const LevelAssignment level = AssignAnchors(batch.targets, layout.anchors[i], layout.strides[i],
                                                static_cast<int>(map.size(1)), static_cast<int>(map.size(2)));
    const LevelLoss part = LossOfLevel(map, level, batch.judged.to(map.device()), options);
    const double balance = options.level_objectness[i] * options.objectness;
    const torch::Tensor total = part.box * options.box + part.objectness * balance + part.classes * options.classes;
    sum = sum.defined() ? sum + total : total;
    loss.box += part.box.item<double>() * options.box;
    loss.objectness += part.objectness.item<double>() * balance;
    loss.classes += part.classes.item<double>() * options.classes;
  }
  loss.total = sum * num_pictures;
  return loss;
}

}  // namespace yorb
