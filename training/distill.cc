// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/distill.h"

#include "training/assign.h"

namespace yorb {
namespace {

namespace F = torch::nn::functional;
using Entropy = F::BinaryCrossEntropyWithLogitsFuncOptions;

constexpr double kLeastObjectness = 0.03;  // of the teacher, for its classes and boxes to count

/// The classes that both know, in the same order on both sides.
struct CommonClasses {
  torch::Tensor of_teacher, of_learner;
};

/// The teacher's objectness of things that the learner can name.
torch::Tensor TaughtObjectness(const torch::Tensor& taught, const CommonClasses& common) {
  const torch::Tensor classes = taught.slice(4, 5);
  const torch::Tensor best = classes.amax(4).sigmoid();
  const torch::Tensor best_common = classes.index_select(4, common.of_teacher).amax(4).sigmoid();
  return taught.select(4, 4).sigmoid() * best_common / (best + 1e-9);
}

/// The objectness to learn: the teacher's, and where the truth stands what the truth wants. Leaving the truth out here
/// would give the background, which is everywhere else, more weight than it has without a teacher.
torch::Tensor ObjectnessToLearn(const torch::Tensor& map, const Assignment& truth, const torch::Tensor& taught) {
  if (truth.size() == 0) return taught;
  torch::Tensor objectness = taught.clone();
  objectness.index_put_(CellIndex(truth, map.device()), WantedObjectness(map, truth));
  return objectness;
}

/// 0 where the learner sees a class that the teacher does not know, but for the cells of the truth; 1 elsewhere.
torch::Tensor AskedWeights(const torch::Tensor& map, const Assignment& truth, const CommonClasses& common) {
  const torch::NoGradGuard no_grad;
  torch::Tensor unknown = torch::ones({map.size(4) - 5}, map.options());
  unknown.index_fill_(0, common.of_learner, 0);
  constexpr double kNever = 1e4;
  const torch::Tensor classes = map.slice(4, 5);
  const torch::Tensor best_unknown = (classes - (1 - unknown) * kNever).amax(4);
  const torch::Tensor best_known = (classes - unknown * kNever).amax(4);
  torch::Tensor weights = 1 - ((best_unknown > best_known) & (best_unknown > 0)).to(torch::kFloat32);
  if (truth.size() > 0) weights.index_put_(CellIndex(truth, map.device()), torch::ones({}, map.options()));
  return weights;
}

/// The anchor of each cell at which `cells` (B, rows, columns, 3) is true, in cells: (n, 2).
torch::Tensor AnchorsAt(const torch::Tensor& cells, const std::array<Anchor, 3>& anchors, int stride) {
  std::vector<float> sizes;
  for (const Anchor& anchor : anchors) sizes.insert(sizes.end(), {anchor.width_px, anchor.height_px});
  const torch::Tensor in_cells = (torch::tensor(sizes).view({3, 2}) / stride).to(cells.device());
  return in_cells.index_select(0, cells.nonzero().select(1, 3));
}

}  // namespace

torch::Tensor DistillationLoss(const std::array<torch::Tensor, 3>& maps, const std::array<torch::Tensor, 3>& taught,
                               const Batch& batch, const Layout& layout, const Teacher& teacher,
                               const LossOptions& options) {
  const torch::Device device = maps[0].device();
  const CommonClasses common{torch::tensor(teacher.own_class).to(device),
                             torch::tensor(teacher.learner_class).to(device)};
  torch::Tensor sum = torch::zeros({}, torch::TensorOptions(torch::kFloat32).device(device));
  for (size_t i = 0; i < maps.size(); ++i) {
    const torch::Tensor map = ByCells(maps[i]), other = ByCells(taught[i]);
    const LevelAssignment truth = AssignAnchors(batch.targets, layout.anchors[i], layout.strides[i],
                                                static_cast<int>(map.size(1)), static_cast<int>(map.size(2)));
    const torch::Tensor objectness = TaughtObjectness(other, common);
    const torch::Tensor asked = AskedWeights(map, truth.sure, common);
    sum = sum + options.objectness * options.level_objectness[i] *
                    F::binary_cross_entropy_with_logits(
                        map.select(4, 4), ObjectnessToLearn(map, truth.sure, objectness), Entropy().weight(asked));
    const torch::Tensor cells = objectness > kLeastObjectness;
    const torch::Tensor weight = objectness.masked_select(cells);
    if (weight.numel() == 0) continue;
    const torch::Tensor own = map.index({cells}), wanted = other.index({cells});
    const torch::Tensor anchors = AnchorsAt(cells, layout.anchors[i], layout.strides[i]);
    const torch::Tensor iou = CompleteIou(DecodeAtCells(own, anchors), DecodeAtCells(wanted, anchors));
    sum = sum + options.box * ((1 - iou) * weight).sum() / weight.sum();
    const torch::Tensor entropy =
        F::binary_cross_entropy_with_logits(own.slice(1, 5).index_select(1, common.of_learner),
                                            wanted.slice(1, 5).index_select(1, common.of_teacher).sigmoid(),
                                            Entropy().weight(weight.unsqueeze(1)).reduction(torch::kSum));
    sum = sum + options.classes * entropy / weight.sum() / static_cast<double>(map.size(4) - 5);
  }
  return sum * static_cast<double>(batch.pictures.size(0));
}

}  // namespace yorb
