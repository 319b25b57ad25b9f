// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/mover_finder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace yorb {
namespace {

constexpr int kLeastViews = 2;  // that saw through a thing before it came
constexpr int kLeastCells = 6;  // of a thing that moves
constexpr int kLeastInnerCells = 2;
constexpr double kFollowedS = 0.5;  // for so long, what moved counts as moving where it was seen last
constexpr int kReachCells = 20;     // that a thing goes on around what was seen to move of it
constexpr double kNever = std::numeric_limits<double>::infinity();

/// A grid of cells with a border around it, so that every cell has four neighbours.
std::array<int, 4> NeighboursOf(int cell, int columns) { return {cell - 1, cell + 1, cell - columns, cell + columns}; }

bool IsAtBorder(const DepthGrid& grid, int cell) {
  const int column = cell % grid.columns;
  return column == 0 || column + 1 == grid.columns || cell < grid.columns || cell >= grid.size() - grid.columns;
}

/// Cells where earlier views saw through to something behind.
std::vector<int> CellsThatCame(const DepthGrid& grid, const std::vector<CellPast>& past) {
  std::vector<int> came;
  for (int cell = 0; cell < grid.size(); ++cell) {
    if (past[static_cast<size_t>(cell)].num_seen_through >= kLeastViews && !IsAtBorder(grid, cell))
      came.push_back(cell);
  }
  return came;
}

/// The connected part of `open` (a row a cell) that a cell belongs to; it is taken out of `open`.
std::vector<int> TakeConnected(int start, int columns, std::vector<uint8_t>& open) {
  std::vector<int> part = {start};
  open[static_cast<size_t>(start)] = 0;
  for (size_t next = 0; next < part.size(); ++next) {
    for (const int neighbour : NeighboursOf(part[next], columns)) {
      if (open[static_cast<size_t>(neighbour)] == 0) continue;
      open[static_cast<size_t>(neighbour)] = 0;
      part.push_back(neighbour);
    }
  }
  return part;
}

/// Of the cells that came, those of things: large, and with an inside. Outlines that depth pictures put now here, now
/// there, have none.
std::vector<int> CellsOfThings(const DepthGrid& grid, const std::vector<int>& came) {
  std::vector<uint8_t> is_in(static_cast<size_t>(grid.size()), 0);
  for (const int cell : came) is_in[static_cast<size_t>(cell)] = 1;
  const std::vector<uint8_t> all = is_in;
  const auto is_inner = [&](int cell) {
    const auto around = NeighboursOf(cell, grid.columns);
    return std::all_of(around.begin(), around.end(), [&](int n) { return all[static_cast<size_t>(n)] != 0; });
  };
  std::vector<int> kept;
  for (const int cell : came) {
    if (is_in[static_cast<size_t>(cell)] == 0) continue;
    const std::vector<int> thing = TakeConnected(cell, grid.columns, is_in);
    const auto num_inner = std::count_if(thing.begin(), thing.end(), is_inner);
    if (static_cast<int>(thing.size()) < kLeastCells || num_inner < kLeastInnerCells) continue;
    kept.insert(kept.end(), thing.begin(), thing.end());
  }
  return kept;
}

/// Whether two neighbouring cells belong to one surface.
bool IsContinuous(float metres, float neighbour_metres) {
  constexpr float kBase = 0.02f, kSlope = 0.03f;
  return std::abs(metres - neighbour_metres) < kBase + kSlope * metres;
}

/// A cell that views of before know as it is now is not taken for what moves, whatever it touches.
bool StandsStill(const CellPast& past) {
  constexpr uint8_t kEnough = 3, kEnoughOfAll = 2;
  if (past.has_been_farther || past.num_seen_through > 0) return false;
  return past.num_agreed >= kEnough || (past.num_agreed >= kEnoughOfAll && past.num_agreed == past.num_compared);
}

/// Spreads from the cells of things over the surface that they are part of: what moved only a little covers itself.
void Spread(const DepthGrid& grid, const std::vector<CellPast>& past, std::vector<int> front,
            std::vector<double>& age_s) {
  for (const int cell : front) age_s[static_cast<size_t>(cell)] = 0;
  for (int step = 0; step < kReachCells && !front.empty(); ++step) {
    std::vector<int> next;
    for (const int cell : front) {
      if (IsAtBorder(grid, cell)) continue;
      for (const int neighbour : NeighboursOf(cell, grid.columns)) {
        const auto n = static_cast<size_t>(neighbour);
        const float metres = grid.surface[n];
        if (metres <= 0 || age_s[n] == 0 || past[n].num_compared == 0 || StandsStill(past[n])) continue;
        if (!IsContinuous(metres, grid.surface[static_cast<size_t>(cell)])) continue;
        age_s[n] = 0;
        next.push_back(neighbour);
      }
    }
    front = std::move(next);
  }
}

}  // namespace

MovingCells::MovingCells(const DepthGrid& grid, const Rig& rig, std::vector<uint8_t> cells)
    : cells_(std::move(cells)), farthest_(cells_.size(), 0.f) {
  shape_.columns = grid.columns;
  shape_.rows = grid.rows;
  for (int cell = 0; cell < grid.size(); ++cell) {
    const auto c = static_cast<size_t>(cell);
    if (cells_[c] == 0) continue;
    ++num_cells_;
    const float farthest = grid.surface[c] + DepthMargin(rig, grid.surface[c]);
    farthest_[c] = std::max(farthest_[c], farthest);
    if (IsAtBorder(grid, cell)) continue;
    // The outline runs through cells that have no one surface.
    for (const int neighbour : NeighboursOf(cell, grid.columns)) {
      const auto n = static_cast<size_t>(neighbour);
      if (grid.surface[n] <= 0) farthest_[n] = std::max(farthest_[n], farthest);
    }
  }
}

bool MovingCells::Has(float x_px, float y_px, float metres) const {
  const int cell = shape_.CellAt(x_px, y_px);
  return cell >= 0 && num_cells_ > 0 && metres < farthest_[static_cast<size_t>(cell)];
}

DepthGrid WithoutMovers(DepthGrid grid, const MovingCells& moving) {
  for (size_t cell = 0; cell < moving.cells().size(); ++cell) {
    if (moving.cells()[cell] != 0) grid.surface[cell] = grid.free[cell] = 0;
  }
  return grid;
}

void MoverFinder::Forget() {
  past_.Forget();
  frames_.clear();
  moved_.clear();
}

/// What moved in the picture before moves still, where it is seen again and not known to stand still.
void MoverFinder::AddFollowed(const DepthGrid& grid, const Rig& rig, const Rigid3& cam_from_last, double step_s,
                              std::vector<double>& age_s) const {
  constexpr float kBase = 0.05f, kSlope = 0.05f;
  for (const Moved& moved : moved_) {
    const Eigen::Vector3d x_in_cam = cam_from_last * moved.x_in_cam.cast<double>();
    if (!(x_in_cam.z() > 0)) continue;
    const Eigen::Vector2f px = rig.camera.Project(x_in_cam).cast<float>();
    const int cell = grid.CellAt(px.x(), px.y());
    if (cell < 0 || moved.age_s + step_s > kFollowedS) continue;
    const auto c = static_cast<size_t>(cell);
    const auto metres = static_cast<float>(x_in_cam.z());
    if (grid.surface[c] <= 0 || std::abs(grid.surface[c] - metres) > kBase + kSlope * metres) continue;
    age_s[c] = std::min(age_s[c], moved.age_s + step_s);
  }
}

/// Cells with points that were elsewhere a fraction of a second ago.
std::vector<int> MoverFinder::CellsThatWent(const PosedFrame& now, const DepthGrid& grid,
                                            const std::vector<CellPast>& past, const Map& map) const {
  std::vector<int> went;
  constexpr double kLongestS = 0.6;
  if (frames_.empty()) return went;
  if (SecondsBetween(frames_.front().frame->timestamp, now.frame->timestamp) > kLongestS) return went;
  const auto then_from_world = frames_.front().place.CamFromWorld(map);
  if (!then_from_world) return went;
  const Rigid3 now_from_then = *now.place.CamFromWorld(map) * then_from_world->Inverse();
  for (const uint32_t index : FindMovedPoints(frames_.front(), now, now_from_then)) {
    const Eigen::Vector2f& px = now.frame->points_px[index];
    const int cell = grid.CellAt(px.x(), px.y());
    if (cell < 0 || grid.surface[static_cast<size_t>(cell)] <= 0 || StandsStill(past[static_cast<size_t>(cell)]))
      continue;
    went.push_back(cell);
  }
  return went;
}

void MoverFinder::Remember(PosedFrame now) {
  constexpr double kSpanS = 0.3;  // long enough to tell a walk from noise
  const Timestamp at = now.frame->timestamp;
  frames_.push_back(std::move(now));
  while (SecondsBetween(frames_.front().frame->timestamp, at) > kSpanS) frames_.pop_front();
}

MovingCells MoverFinder::Find(PosedFrame now, const DepthGrid& grid, const Map& map) {
  const Rig& rig = *now.frame->rig;
  const Timestamp at = now.frame->timestamp;
  const auto cam_from_world = now.place.CamFromWorld(map);
  if (grid.empty() || !cam_from_world) return {};
  const std::vector<CellPast> past = past_.Compare(grid, rig, *cam_from_world, map);
  past_.Add(grid, at, now.place);

  std::vector<double> age_s(past.size(), kNever);
  if (!moved_.empty()) {
    const PosedFrame& last = frames_.back();
    const auto last_from_world = last.place.CamFromWorld(map);
    const double step_s = SecondsBetween(last.frame->timestamp, at);
    if (last_from_world) AddFollowed(grid, rig, *cam_from_world * last_from_world->Inverse(), step_s, age_s);
  }
  for (size_t cell = 0; cell < past.size(); ++cell) {
    if (StandsStill(past[cell])) age_s[cell] = kNever;
  }
  std::vector<int> things = CellsOfThings(grid, CellsThatCame(grid, past));
  const std::vector<int> went = CellsThatWent(now, grid, past, map);
  things.insert(things.end(), went.begin(), went.end());
  Spread(grid, past, std::move(things), age_s);
  Remember(std::move(now));

  moved_.clear();
  std::vector<uint8_t> cells(past.size(), 0);
  const float half = 0.5f * (kGridCellPx - 1);
  for (int cell = 0; cell < grid.size(); ++cell) {
    const auto c = static_cast<size_t>(cell);
    if (age_s[c] == kNever) continue;
    cells[c] = 1;
    const double x_px = cell % grid.columns * kGridCellPx + half, y_px = cell / grid.columns * kGridCellPx + half;
    moved_.push_back({rig.camera.Unproject(x_px, y_px, grid.surface[c]).cast<float>(), age_s[c]});
  }
  return {grid, rig, std::move(cells)};
}

}  // namespace yorb
