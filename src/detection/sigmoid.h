// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace yorb {

/// 1 / (1 + exp(-x)) of every number, to a few units in the last place; with AVX2 or AVX-512 where the processor has
/// them. `from` and `to` may be the same.
void Sigmoids(const float* from, float* to, size_t count);

/// x * sigmoid(x), "SiLU" or "swish".
void Silus(const float* from, float* to, size_t count);

/// x * clamp(x / 6 + 1/2, 0, 1).
void HardSwishes(const float* from, float* to, size_t count);

}  // namespace yorb
