// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "dynamics/cell_plane.h"

namespace yorb {

/// What the cells of a depth picture belong to: 0, or one of the following.
using CellMask = std::vector<uint8_t>;
constexpr uint8_t kBody = 1;   ///< something that moves
constexpr uint8_t kLying = 2;  ///< a desk or a floor

constexpr int kInexactCells = 2;  ///< by which a box may be too small, in cells on each side

constexpr double kSurroundings = 0.25;  ///< how wide what surrounds a box is, of the box's sides
constexpr float kLeastMeasured = 24;    ///< cells, to say anything of a box or of what surrounds it

/// What speaks for a body in a box.
struct BodySign {
  float metres = 0;     ///< its densest depth
  float num_cells = 0;  ///< how many more cells of the box than of its surroundings, by share, lie near it
};

/// Where the body in a box is: a plane. Who stands upright before a camera that looks down is nearer at the head than
/// at the feet.
struct BodyPlane {
  CellPlane plane;
  float metres = 0;  ///< depth in the middle of the box

  /// Whether a measured depth belongs to the body: arms reach forward more than backs reach back.
  bool Holds(int column, int row, float depth_m) const {
    constexpr float kFrontM = 0.25f, kBackM = 0.15f, kNoise = 0.01f;  // noise grows with the square of depth
    const float noise = kNoise * depth_m * depth_m;
    const float inverse = plane.InverseDepthAt(column, row);
    return depth_m > 0 && (depth_m + kFrontM + noise) * inverse > 1 && (depth_m - kBackM - noise) * inverse < 1;
  }
};

/// Which cells have their middles in any of some boxes: 1, else 0.
CellMask CellsInBoxes(const DepthCells& depth, const std::vector<Box>& boxes);

/// What surrounds the search for the body in a box.
struct BodySearch {
  const DepthCells& depth;
  const CellMask& taken;     ///< cells that are known already; they count for nothing
  const CellMask& in_boxes;  ///< cells in boxes in which bodies are seen: there are no surroundings

  /// Whether the middle of a cell lies in any of these boxes.
  bool IsInABox(int column, int row) const { return in_boxes[depth.IndexOf(column, row)] != 0; }
};

/// Where a body was found: which cells of a range were its own, and its plane.
struct BodyMemory {
  CellRange range;
  CellMask cells;  ///< of the range, row by row
  BodyPlane body;
};

/// Remembers what a body added to a mask, about its box.
BodyMemory RememberBody(const DepthCells& depth, const Box& box, const BodyPlane& body, const CellMask& before,
                        const CellMask& after);

/// Whether most of a body that was found before is there in the same shape at the same depth, moved along with its box.
/// It need not stand out from its surroundings: a body that fills the picture has none.
bool IsThereAgain(const BodySearch& search, const Box& box, const BodyMemory& memory);

/// How much more of a box than of its surroundings is at a body, as shares, -1 to 1. Where little surrounds the box,
/// since the picture ends there or others stand there, that little says little.
struct Contrast {
  float all_round = 0;
  float but_one_side = 0;  ///< without the side on which most goes on: boxes cut people, mostly at their feet
};
Contrast ContrastOf(const BodySearch& search, const Box& box, const BodyPlane& body);

/// The plane through a body, starting with one that faces the camera at `metres`: each turn takes in what lies near the
/// plane of the turn before, so that it follows the body up and down. Sideways it turns by so much only: a plane that
/// is steeper, and deeper than one body, goes from one to the next.
BodyPlane FitBody(const BodySearch& search, const Box& box, float metres);

/// Marks in `mask` (a value for each cell) the body at `body`: what lies near its plane in the box, and what hangs
/// together with that in the box grown by a tenth, since boxes are not exact. Cells of the box where nothing was
/// measured count as body unless all that surrounds them is not.
CellMask WithBody(CellMask mask, const DepthCells& depth, const Box& box, const BodyPlane& body);

}  // namespace yorb
