// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/remover.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "dynamics/body_signs.h"
#include "dynamics/lying_cells.h"
#include "dynamics/outline.h"
#include "dynamics/seen_people.h"
#include "dynamics/wall.h"
#include "features/frame.h"

namespace yorb {
namespace {

constexpr float kCarriedReachM = 0.5f;   // from a body to what it carries or sits on
constexpr float kLeastContrast = 0.15f;  // of a body that stands out from its surroundings
constexpr float kLeastContrastBridged = 0.25f;
constexpr float kKnownIsWorth = 0.25f;  // of contrast, where a body was in the picture before
constexpr float kOneBodyM = 0.1f;       // of depth: what is nearer to each other is one
constexpr float kSamePlaceM = 0.25f;    // of depth, from picture to picture
constexpr double kMostTaken = 0.5;      // of a box by bodies of other boxes, so that it may have one of its own
constexpr float kBridgedM = 0.2f;       // how far a body that is only expected may be from where it was
constexpr double kFreshS = 0.5;         // since the detector was sure: who was in view is still there
constexpr double kStillTrueS = 0.1;     // that a map of people may be old: nothing moves it on
constexpr double kEdgePx = 2;           // how far depth and colour may disagree on an outline
constexpr double kRingPx = 3;           // of FAST: a corner so near to an outline is made by it

/// Marks all of a box but what lies.
CellMask WithAllOf(CellMask mask, const DepthCells& depth, const Box& box) {
  const CellRange range = depth.RangeOf(box);
  for (int row = range.top; row < range.bottom; ++row) {
    for (int column = range.left; column < range.right; ++column) {
      uint8_t& cell = mask[depth.IndexOf(column, row)];
      if (cell == 0) cell = kBody;
    }
  }
  return mask;
}

/// Whether the detector sees it in this very picture, and is sure of it.
bool IsSure(const BoxTrack& track, Timestamp now) { return !track.IsBridged(now) && !track.is_faint; }

/// Whether somebody is there beyond doubt: the detector is sure, or sees what it was sure of a moment ago.
bool IsFresh(const BoxTrack& track, Timestamp now) {
  return !track.IsBridged(now) && SecondsBetween(track.last_sure, now) <= kFreshS;
}

/// The depth at which a body was last found.
std::optional<float> LastDepth(const BoxTrack& track) {
  return track.body ? std::optional<float>(track.body->body.metres) : std::nullopt;
}

/// A body in a box.
struct FoundBody {
  BodyPlane plane;
  float contrast = 0;  ///< all round; 0 where it is only found again, whether it stands out or not
};

/// Whether a body stands out; one that the detector did not surely see just now must be where it was.
bool IsBelievable(const BoxTrack& track, const FoundBody& found, Timestamp now) {
  if (IsSure(track, now)) return found.contrast >= kLeastContrast;
  const bool is_there = track.body && std::abs(found.plane.metres - track.body->body.metres) < kBridgedM;
  return is_there && found.contrast >= kLeastContrastBridged;
}

/// The likeliest of the bodies that these signs, and the memory of the track, lead to: what stands out most. A body
/// does not jump: another place than that of the picture before must stand out clearly more.
FoundBody Likeliest(const BoxTrack& track, const BodySearch& search, const std::vector<BodySign>& signs) {
  FoundBody best;
  float best_value = std::numeric_limits<float>::lowest();
  std::vector<float> tried_m;  // depths of the bodies so far
  const auto is_tried = [&](float metres) {
    return std::any_of(tried_m.begin(), tried_m.end(), [&](float m) { return std::abs(m - metres) < kOneBodyM; });
  };
  const auto attempt = [&](float metres) {
    if (is_tried(metres)) return;
    const BodyPlane plane = FitBody(search, track.at.box, metres);
    if (is_tried(plane.metres)) return;
    tried_m.push_back(plane.metres);
    const Contrast contrast = ContrastOf(search, track.at.box, plane);
    const bool is_known = track.body && std::abs(plane.metres - track.body->body.metres) < kSamePlaceM;
    const float value = contrast.but_one_side + (is_known ? kKnownIsWorth : 0);
    if (value > best_value) best_value = value, best = {plane, contrast.all_round};
  };
  for (const BodySign& sign : signs) attempt(sign.metres);
  const bool is_worth_looking = track.body && !is_tried(track.body->body.metres);
  if (is_worth_looking && IsThereAgain(search, track.at.box, *track.body)) attempt(track.body->body.metres);
  return best;
}

/// The body of a track, by what stands out in its box (`signs`), or else where it was found before. Where somebody is
/// not there beyond doubt, a wall must not be taken for a body.
std::optional<FoundBody> FindBodyOf(const BoxTrack& track, const BodySearch& search, const std::vector<BodySign>& signs,
                                    Timestamp now) {
  const bool is_fresh = IsFresh(track, now);
  if (!is_fresh && !HasSurroundings(search, track.at.box)) return std::nullopt;
  const auto is_apart = [&](const BodyPlane& body) { return is_fresh || !GoesOnBeyond(search, track.at.box, body); };
  if (!signs.empty()) {
    const FoundBody found = Likeliest(track, search, signs);
    if (is_apart(found.plane) && IsBelievable(track, found, now)) return found;
  }
  if (!track.body || (!is_fresh && GoesOnAround(search, track.at.box, track.body->body))) return std::nullopt;
  if (!IsThereAgain(search, track.at.box, *track.body)) return std::nullopt;
  const BodyPlane plane = FitBody(search, track.at.box, track.body->body.metres);
  if (!is_apart(plane)) return std::nullopt;
  return FoundBody{plane};
}

/// How much of a box is known as the body of others.
double ShareTaken(const CellMask& mask, const CellRange& range, const DepthCells& depth) {
  int taken = 0;
  for (int row = range.top; row < range.bottom; ++row) {
    for (int column = range.left; column < range.right; ++column) taken += mask[depth.IndexOf(column, row)] == kBody;
  }
  return range.size() > 0 ? static_cast<double>(taken) / range.size() : 1;
}

/// A track whose body is still to be found, and what speaks for one as long as no cell of its box is newly taken.
struct OpenTrack {
  BoxTrack* track;
  std::optional<std::vector<BodySign>> signs;
};

/// Takes the body that explains most, of those that the detector saw if there is one, out of what is open.
OpenTrack TakeNext(std::vector<OpenTrack>& open, const BodySearch& search, Timestamp now) {
  size_t best = 0;
  const std::vector<BodySign>* best_signs = nullptr;
  bool is_best_bridged = true;
  for (size_t i = 0; i < open.size(); ++i) {
    const BoxTrack& track = *open[i].track;
    if (!open[i].signs) open[i].signs = FindBodies(search, track.at.box, LastDepth(track));
    const std::vector<BodySign>& found = *open[i].signs;
    const bool is_bridged = track.IsBridged(now);
    if (found.empty() || (best_signs != nullptr && is_bridged && !is_best_bridged)) continue;
    const bool is_alike = best_signs != nullptr && is_bridged == is_best_bridged;
    if (is_alike && found[0].num_cells <= (*best_signs)[0].num_cells) continue;
    best = i, best_signs = &found, is_best_bridged = is_bridged;
  }
  std::swap(open[best], open.back());
  OpenTrack next = std::move(open.back());
  open.pop_back();
  return next;
}

/// The smallest range with all cells in which two masks differ.
CellRange ChangedCells(const CellMask& before, const CellMask& after, const DepthCells& depth) {
  CellRange changed{depth.columns(), depth.rows(), 0, 0};
  for (int row = 0; row < depth.rows(); ++row) {
    for (int column = 0; column < depth.columns(); ++column) {
      const size_t cell = depth.IndexOf(column, row);
      if (before[cell] == after[cell]) continue;
      changed = {std::min(changed.left, column), std::min(changed.top, row), std::max(changed.right, column + 1),
                 std::max(changed.bottom, row + 1)};
    }
  }
  return changed;
}

/// Forgets the signs in boxes of which cells were taken since.
void ForgetSigns(std::vector<OpenTrack>& open, const CellRange& changed, const DepthCells& depth) {
  for (OpenTrack& one : open) {
    const CellRange range = depth.RangeOf(one.track->at.box);
    const bool is_apart = changed.right <= range.left || changed.left >= range.right || changed.bottom <= range.top ||
                          changed.top >= range.bottom;
    if (!is_apart) one.signs.reset();
  }
}

/// What moves by itself. Where boxes overlap, the body that explains most is found first, and leaves the rest to the
/// others; boxes that are only expected come last. The tracks remember how far away their bodies are. `mask`: desks and
/// floors, which are none.
CellMask MaskOfBodies(std::vector<BoxTrack>& tracks, const DepthCells& depth, CellMask mask, Timestamp now) {
  std::vector<Box> seen;
  std::vector<OpenTrack> open;
  for (BoxTrack& track : tracks) {
    if (track.at.motion != Motion::kHigh) continue;
    if (!track.IsBridged(now)) seen.push_back(track.at.box);
    open.push_back({&track, std::nullopt});
  }
  const CellMask in_boxes = CellsInBoxes(depth, seen);
  while (!open.empty()) {
    const BodySearch search{depth, mask, in_boxes};
    const OpenTrack next = TakeNext(open, search, now);
    BoxTrack& track = *next.track;
    // A poster, however sure the detector is; but who stood free before has only come near the wall.
    if (!track.body && LiesInAWall(search, track.at.box)) continue;
    const auto found = FindBodyOf(track, search, *next.signs, now);
    const CellMask before = mask;
    if (found) {
      mask = WithBody(std::move(mask), depth, track.at.box, found->plane);
      // Only what the detector sees is remembered: a memory of memories would wander off into the background.
      const bool is_new = !track.IsBridged(now) && found->contrast > 0;
      if (is_new) track.body = RememberBody(depth, track.at.box, found->plane, before, mask);
      track.body_seen = now;
    } else if (IsSure(track, now) && ShareTaken(mask, depth.RangeOf(track.at.box), depth) < kMostTaken) {
      // Where depth cannot tell the body from what is around it, the box counts as a whole, as in the paper.
      mask = WithAllOf(std::move(mask), depth, track.at.box);
    }
    ForgetSigns(open, ChangedCells(before, mask, depth), depth);
  }
  return mask;
}

/// Things that do not move by themselves, near a body that their box touches: carried, or sat upon.
CellMask WithCarried(CellMask mask, const std::vector<BoxTrack>& tracks, const DepthCells& depth) {
  for (const BoxTrack& carried : tracks) {
    if (carried.at.motion != Motion::kLow) continue;
    for (const BoxTrack& body : tracks) {
      if (body.at.motion != Motion::kHigh || !body.body || !Touch(body.at.box, carried.at.box)) continue;
      const CellRange range = depth.RangeOf(carried.at.box);
      for (int row = range.top; row < range.bottom; ++row) {
        for (int column = range.left; column < range.right; ++column) {
          const float metres = depth.At(column, row);
          if (metres > 0 && std::abs(metres - body.body->body.metres) < kCarriedReachM)
            mask[depth.IndexOf(column, row)] = kBody;
        }
      }
    }
  }
  return mask;
}

/// Whether a corner with its ring, `reach_px` around it, touches a body.
bool Touches(const cv::Mat& bodies, const Keypoint& point, double reach_px) {
  const auto is_marked = [&](double x, double y) {
    const int column = std::clamp(static_cast<int>(x / kDepthCellPx), 0, bodies.cols - 1);
    const int row = std::clamp(static_cast<int>(y / kDepthCellPx), 0, bodies.rows - 1);
    return bodies.at<uint8_t>(row, column) != 0;
  };
  const double x = static_cast<double>(point.x), y = static_cast<double>(point.y), slant = reach_px * M_SQRT1_2;
  return is_marked(x, y) || is_marked(x - reach_px, y) || is_marked(x + reach_px, y) || is_marked(x, y - reach_px) ||
         is_marked(x, y + reach_px) || is_marked(x - slant, y - slant) || is_marked(x + slant, y - slant) ||
         is_marked(x - slant, y + slant) || is_marked(x + slant, y + slant);
}

}  // namespace

Verdict MovingAreas::Judge(const Keypoint& point) const {
  if (Ignores(point)) return Verdict::kDynamic;
  const Verdict by_boxes = rules_.Judge(point);
  if (bodies_.empty()) return by_boxes;
  if (Touches(bodies_, point, kEdgePx + kRingPx * std::pow(scale_factor_, point.octave))) return Verdict::kDynamic;
  return by_boxes == Verdict::kDynamic ? Verdict::kGivenBack : Verdict::kStatic;
}

std::vector<Verdict> MovingAreas::Judge(const std::vector<Keypoint>& points) const {
  std::vector<Verdict> verdicts;
  verdicts.reserve(points.size());
  for (const Keypoint& point : points) verdicts.push_back(Judge(point));
  return verdicts;
}

cv::Mat MovingAreas::Covered(const cv::Size& size) const {
  const bool has_boxes = bodies_.empty() && !boxes_.empty();
  if (!has_boxes && ignored_.empty()) return bodies_;
  const cv::Size cells(std::max(1, size.width / kDepthCellPx), std::max(1, size.height / kDepthCellPx));
  cv::Mat covered = bodies_.size() == cells ? bodies_.clone() : cv::Mat::zeros(cells, CV_8UC1);
  if (has_boxes) rules_.Mark(covered);
  if (!ignored_.empty()) {
    cv::Mat ignored;
    cv::resize(ignored_ != 0, ignored, cells, 0, 0, cv::INTER_AREA);
    covered.setTo(1, ignored);
  }
  return covered;
}

bool MovingAreas::Ignores(const Keypoint& point) const {
  if (ignored_.empty()) return false;
  const int x = std::clamp(static_cast<int>(std::lround(point.x)), 0, ignored_.cols - 1);
  const int y = std::clamp(static_cast<int>(std::lround(point.y)), 0, ignored_.rows - 1);
  return ignored_.at<uint8_t>(y, x) != 0;
}

Features Kept(Features features, const std::function<bool(size_t)>& is_kept) {
  std::vector<bool> is_marked(features.keypoints.size());
  for (size_t i = 0; i < is_marked.size(); ++i) is_marked[i] = !is_kept(i);
  features.keypoints = WithoutRows(std::move(features.keypoints), is_marked);
  features.descriptors = WithoutRows(std::move(features.descriptors), is_marked);
  return features;
}

Remover::Remover(Dynamics dynamics, MotionTable table, double scale_factor, double sure_confidence)
    : dynamics_(dynamics), table_(std::move(table)), scale_factor_(scale_factor), tracks_(sure_confidence) {}

void Remover::Prepare(const ImageSet& images) {
  if (dynamics_ != Dynamics::kFull || images.depth.empty()) return;
  DepthCells depth(images.depth);
  CellMask lying = MarkLying(depth);
  ground_ = Ground{images.timestamp, std::move(depth), std::move(lying)};
}

MovingAreas Remover::Look(const ImageSet& images, const SeenAt& looked) {
  MovingAreas areas;
  areas.ignored_ = images.ignored;
  areas.scale_factor_ = scale_factor_;
  if (dynamics_ == Dynamics::kPaper) {
    const std::vector<SortedBox> sorted = SortByMotion(looked.seen.boxes, table_);
    areas.rules_ = BoxRules(sorted);
    for (const SortedBox& box : sorted) {
      if (box.motion == Motion::kHigh) areas.boxes_.push_back(box.box);
    }
  } else if (dynamics_ == Dynamics::kFull) {
    FollowBodies(images, looked, areas);
  }
  return areas;
}

void Remover::FollowBodies(const ImageSet& images, const SeenAt& looked, MovingAreas& areas) {
  tracks_.Update(images.timestamp, looked, table_, images.grey.cols, images.grey.rows);
  std::vector<BoxTrack>& tracks = tracks_.tracks();
  std::vector<SortedBox> boxes;
  for (const BoxTrack& track : tracks) {
    boxes.push_back(track.at);
    if (track.at.motion != Motion::kHigh) continue;
    areas.boxes_.push_back(track.at.box);
    areas.num_bridged_ += track.IsBridged(images.timestamp);
  }
  areas.rules_ = BoxRules(boxes);
  const bool shows_somebody =
      SecondsBetween(looked.at, images.timestamp) <= kStillTrueS && ShowsSomebody(looked.seen.people);
  if ((areas.boxes_.empty() && !shows_somebody) || images.depth.empty()) return;
  if (!ground_ || ground_->at != images.timestamp) Prepare(images);
  Ground ground = *std::exchange(ground_, std::nullopt);
  const DepthCells& depth = ground.depth;
  CellMask mask = WithCarried(MaskOfBodies(tracks, depth, std::move(ground.lying), images.timestamp), tracks, depth);
  if (shows_somebody) mask = WithSeenPeople(std::move(mask), depth, looked.seen.people);
  areas.bodies_ = cv::Mat(depth.rows(), depth.columns(), CV_8UC1);
  std::transform(mask.begin(), mask.end(), areas.bodies_.begin<uint8_t>(),
                 [](uint8_t cell) { return cell == kBody ? kBody : uint8_t{0}; });
}

}  // namespace yorb
