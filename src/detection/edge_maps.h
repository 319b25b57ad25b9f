// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "detection/engine.h"
#include "detection/head_layout.h"

namespace yorb {

/// Each edge of a box is a distance from the middle of its cell, given by how likely 0 to 15 cells are.
constexpr int kEdgeBins = 16;

/// The layout where the outputs are YOLOv8's own maps: for each stride 64 numbers of the four edges and the classes',
/// in one output or in two. Of one output the number of names must say where the classes begin.
std::optional<HeadLayout> EdgeMapsOf(const HeadFacts& facts);

/// How far the four edges of a cell's box lie from its middle, in cells: left, top, right, bottom.
std::array<float, 4> EdgesAt(const TensorView& edges, int x, int y);

/// Whether the sigmoid of the classes' scores is still to come.
bool AreEdgeMapsLogits(const std::vector<TensorView>& outputs, const HeadLayout& layout);

}  // namespace yorb
