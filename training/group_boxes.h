// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "training/labels.h"

namespace yorb {

/// Makes doubtful what is a box around a group rather than around one thing: it holds at least two much smaller boxes
/// of its own class. Public sets have such boxes around crowds, beside those of single people, and call both a person.
void DoubtGroups(std::vector<LabelBox>& boxes);

}  // namespace yorb
