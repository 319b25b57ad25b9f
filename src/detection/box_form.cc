// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/box_form.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace yorb {
namespace {

using Numbers = std::array<float, 4>;

/// How far from its cell's middle a box would lie, in shares of the picture.
double Distance(const Numbers& box, BoxForm form, const HeadCell& cell, const HeadFacts& facts) {
  float x = box[0], y = box[1];
  if (form == BoxForm::kCorners) x = (box[0] + box[2]) / 2, y = (box[1] + box[3]) / 2;
  if (form == BoxForm::kRelative) x = (box[0] + cell.column) * cell.stride, y = (box[1] + cell.row) * cell.stride;
  return std::abs(x - (cell.column + .5f) * cell.stride) / static_cast<float>(facts.width) +
         std::abs(y - (cell.row + .5f) * cell.stride) / static_cast<float>(facts.height);
}

bool IsOfForm(const Numbers& box, BoxForm form) {
  if (form == BoxForm::kRelative) return true;
  const bool are_sizes = box[2] >= 0 && box[3] >= 0, are_corners = box[2] >= box[0] && box[3] >= box[1];
  return form == BoxForm::kCorners ? are_corners : are_sizes;
}

/// The boxes that say something: rows that nothing fills are 0.
std::vector<std::pair<Numbers, HeadCell>> BoxesIn(const TensorView& output, const std::vector<HeadCell>& cells,
                                                  bool are_columns) {
  std::vector<std::pair<Numbers, HeadCell>> boxes;
  for (size_t i = 0; i < cells.size(); ++i) {
    Numbers box;
    for (size_t k = 0; k < 4; ++k) {
      const auto row = static_cast<int64_t>(i), value = static_cast<int64_t>(k);
      box[k] = are_columns ? output.At(0, value, row) : output.At(0, row, value);
    }
    const bool is_filled = std::any_of(box.begin(), box.end(), [](float number) { return number != 0; });
    const bool is_sound = std::all_of(box.begin(), box.end(), [](float number) { return std::isfinite(number); });
    if (is_filled && is_sound) boxes.emplace_back(box, cells[i]);
  }
  return boxes;
}

bool AreColumns(const TensorView& output, LayoutKind kind) {
  return kind == LayoutKind::kCentreColumns ||
         (kind == LayoutKind::kBoxesApart && output.dims[1] == 4 && output.dims[2] != 4);
}

/// All of them: in pixels no picture has its boxes in its first corner alone.
bool AreFractions(const std::vector<std::pair<Numbers, HeadCell>>& boxes) {
  constexpr float kMost = 1.5f;  // boxes go a little beyond the edges
  return std::all_of(boxes.begin(), boxes.end(), [](const auto& box) {
    return std::all_of(box.first.begin(), box.first.end(), [](float number) { return std::abs(number) <= kMost; });
  });
}

}  // namespace

std::optional<SeenForm> BoxFormOf(const std::vector<TensorView>& outputs, const HeadLayout& layout,
                                  const HeadFacts& facts) {
  constexpr double kNear = .1, kClearly = 2;  // shares of the picture; how much nearer than by the next form
  constexpr size_t kLeastShare = 4;           // a quarter of the cells have boxes
  const TensorView& output = outputs[layout.output];
  const bool are_columns = AreColumns(output, layout.kind);
  const std::vector<HeadCell> cells = CellsOfRows(output.dims[are_columns ? 2 : 1], facts);
  auto boxes = BoxesIn(output, cells, are_columns);
  if (kLeastShare * boxes.size() < cells.size()) return std::nullopt;
  // Offsets from cells, YOLOX's, are small, too.
  const bool are_fractions = layout.kind != LayoutKind::kCellRows && AreFractions(boxes);
  for (auto& [box, cell] : boxes) {
    for (size_t k = 0; k < 4 && are_fractions; ++k)
      box[k] *= static_cast<float>(k % 2 == 0 ? facts.width : facts.height);
  }
  std::vector<std::pair<double, BoxForm>> forms;
  for (const BoxForm form : {BoxForm::kCentre, BoxForm::kCorners, BoxForm::kRelative}) {
    if (form == BoxForm::kRelative && layout.kind != LayoutKind::kCellRows) continue;
    double sum = 0;
    size_t num_sound = 0;
    for (const auto& [box, cell] : boxes)
      sum += Distance(box, form, cell, facts), num_sound += IsOfForm(box, form) ? 1 : 0;
    if (10 * num_sound >= 9 * boxes.size()) forms.emplace_back(sum / static_cast<double>(boxes.size()), form);
  }
  std::sort(forms.begin(), forms.end());
  if (boxes.empty() || forms.empty() || forms[0].first > kNear) return std::nullopt;
  const bool is_clear = forms.size() == 1 || forms[1].first > kClearly * forms[0].first;
  return is_clear ? std::optional(SeenForm{forms[0].second, are_fractions}) : std::nullopt;
}

bool IsObjectnessOne(const TensorView& rows) {
  constexpr int64_t kObjectness = 4;
  for (int64_t i = 0; i < rows.dims[1]; ++i) {
    const bool is_filled = rows.At(0, i, 2) != 0 || rows.At(0, i, 3) != 0;
    if (is_filled && rows.At(0, i, kObjectness) != 1) return false;
  }
  return true;
}

}  // namespace yorb
