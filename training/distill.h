// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "training/loss.h"
#include "training/teacher.h"

namespace yorb {

/// How far the learner's maps are from the teacher's (Mehta and Ozturk, 2018): objectness everywhere, classes and boxes
/// where the teacher sees something, weighed by how sure it is of it. Things that only the teacher knows are
/// background; where the truth stands it alone says the objectness, and where the learner sees a class that the teacher
/// does not know, the teacher is not asked. A sum over the levels, balanced as in `DetectionLoss`, times the batch
/// size.
torch::Tensor DistillationLoss(const std::array<torch::Tensor, 3>& maps, const std::array<torch::Tensor, 3>& taught,
                               const Batch& batch, const Layout& layout, const Teacher& teacher,
                               const LossOptions& options);

}  // namespace yorb
