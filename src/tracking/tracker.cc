// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/tracker.h"

#include <algorithm>

#include "localize/relocalizer.h"
#include "tracking/keyframe_policy.h"
#include "tracking/leave_out.h"
#include "tracking/same_picture.h"
#include "tracking/seen_lines.h"
#include "tracking/shutter.h"

namespace yorb {
namespace {

constexpr double kSure = 1e12;  // information of the pose that a world begins with

constexpr size_t kMinInliersOfGuess = 10;  // that make a first pose worth refining on the local map

size_t CountValid(const std::vector<LandmarkId>& matches) {
  return static_cast<size_t>(std::count_if(matches.begin(), matches.end(), [](LandmarkId id) { return id.IsValid(); }));
}

int CountPointsWithDepth(const Frame& frame) {
  const auto end = frame.depth.end() - static_cast<std::ptrdiff_t>(frame.num_suspects);
  return static_cast<int>(std::count_if(frame.depth.begin(), end, [](float d) { return d > 0; }));
}

/// Whether something leads from one keyframe to the other.
bool AreOfOneSubMap(const Map& map, KeyframeId a, KeyframeId b) {
  return map.Find(map.Surviving(a))->root == map.Find(map.Surviving(b))->root;
}

/// Lets go of the suspects that are doubtful under a pose.
FramePtr WithoutDoubtful(const FramePtr& frame, Fix& fix) {
  if (frame->num_suspects == 0) return frame;
  const std::vector<bool> is_doubtful = DoubtfulSuspects(*frame, fix.matches);
  fix.matches = WithoutRows(std::move(fix.matches), is_doubtful);
  fix.by_depth = WithoutRows(fix.by_depth, is_doubtful);
  return WithoutRows(frame, is_doubtful);
}

}  // namespace

Tracked Tracker::Track(const FramePtr& frame, const Map& map, size_t backlog, Sight sight) {
  sight_ = std::move(sight);
  Tracked tracked = state_ == TrackingState::kNotInitialized ? Begin(frame, map) : TrackInMap(frame, map, backlog);
  tracked.record.id = frame->id;
  tracked.record.timestamp = frame->timestamp;
  tracked.record.state = state_;
  tracked.record.num_extracted = static_cast<int>(frame->size());
  tracked.record.num_static = static_cast<int>(frame->size() - frame->num_suspects);
  tracked.record.is_keyframe = tracked.proposal.has_value();
  if (tracked.proposal && options_.straight_edges) {
    Proposal& proposal = *tracked.proposal;
    proposal.lines = SeeLines(sight_, *proposal.frame, motion_.RateWhileReading(frame->rig->readout_s));
  }
  return tracked;
}

Tracked Tracker::Begin(const FramePtr& raw_frame, const Map& map) {
  Tracked tracked;
  const int num_points = CountPointsWithDepth(*raw_frame);
  if (num_points < options_.min_first_points) return tracked;
  Fix nothing_known;
  nothing_known.matches.resize(raw_frame->size());
  const FramePtr frame = WithoutDoubtful(raw_frame, nothing_known);
  // This frame will be the next keyframe, since no other waits, and defines the world of its sub-map.
  const KeyframeId first = map.next_keyframe();
  state_ = TrackingState::kTracking;
  motion_.Forget();
  movers_.Forget();
  surfaces_.Forget();
  last_ = {frame, {first, Rigid3::Identity()}, std::vector<LandmarkId>(frame->size()), 0, 0, raw_frame, sight_.grey};
  was_lost_ = starts_over_ = false;
  sought_since_.reset();
  tracked.record.reference = first;
  tracked.record.information = kSure * Matrix6d::Identity();
  tracked.record.num_matched = tracked.record.num_inliers = num_points;
  tracked.proposal = Proposal{frame, KeyframeId(), Rigid3::Identity(), last_.matches, {}};
  last_proposal_ = frame->timestamp;
  frames_since_proposal_ = 0;
  return tracked;
}

Tracked Tracker::TrackInMap(const FramePtr& raw_frame, const Map& map, size_t backlog) {
  const bool is_known =
      last_.frame && last_.num_blind == 0 && IsSamePicture({*raw_frame, sight_.grey}, {*last_.picture, last_.grey});
  if (is_known) return StandStill();
  if (IsAlone(*raw_frame)) state_ = TrackingState::kLost;
  FollowKeyframe(map);
  FramePtr frame = WithoutShutter(raw_frame, motion_.RateWhileReading(raw_frame->rig->readout_s));
  Sought sought = FindPose(*frame, map);
  std::optional<Located>& located = sought.located;
  Tracked tracked;
  ++frames_since_proposal_;
  if (!located) {
    NoteLoss(*frame, sought.was_refused);
    if (starts_over_) return Begin(raw_frame, map);
    tracked.starts_over = starts_over_ = IsTimeForANewMap(*frame, backlog);
    return tracked;
  }
  if (!task_.only_locates) CountSeen(*located);
  Fix& fix = located->fix;
  const Support support = SupportFor(*frame, map, fix);
  NoteMotion(*frame, map, *located);
  if (const FramePtr better = WithoutShutter(raw_frame, motion_.RateWhileReading(raw_frame->rig->readout_s));
      better != raw_frame) {
    frame = better;
    fix = Refit(*frame, map, fix, support);
  }
  frame = WithoutDoubtful(frame, fix);
  const MovingCells movers = FindMovers(frame, map, *located);
  tracked.moving = LeaveOut(movers, frame, map, fix, support);
  Remember(frame, map, *located);
  surfaces_.Add(WithoutMovers(sight_.depth, movers), frame->timestamp, last_.place);
  last_.picture = raw_frame;
  if (!task_.only_locates) CountGone(*frame, map, *located);
  tracked.record.reference = last_.place.reference;
  tracked.record.cam_from_reference = last_.place.cam_from_reference;
  tracked.record.information = fix.information;
  tracked.record.num_matched = static_cast<int>(fix.num_matched);
  tracked.record.num_inliers = static_cast<int>(fix.num_in_all());
  const KeyframeQuestion question{
      *frame, fix, map, last_.place.reference, SecondsBetween(last_proposal_, frame->timestamp), frames_since_proposal_,
      backlog};
  const bool is_sure = fix.num_in_all() >= static_cast<size_t>(options_.min_inliers);
  if (!task_.only_locates && is_sure && IsKeyframeDue(question, options_)) tracked.proposal = Propose(frame, fix);
  return tracked;
}

Tracked Tracker::StandStill() {
  // One picture, one pose. Where the camera is by now nobody knows; the motion model starts anew after the pause.
  Tracked tracked;
  state_ = TrackingState::kTracking;
  tracked.record.is_repeated = true;
  tracked.record.reference = last_.place.reference;
  tracked.record.cam_from_reference = last_.place.cam_from_reference;
  tracked.record.num_matched = tracked.record.num_inliers = static_cast<int>(CountValid(last_.matches));
  return tracked;
}

/// The mapper may have made a keyframe of the frame before: it gave it landmarks and a better pose.
void Tracker::FollowKeyframe(const Map& map) {
  const Keyframe* newest = map.Find(map.newest_keyframe());
  if (!newest || newest->frame != last_.frame) return;
  last_.matches = newest->landmarks;
  last_.place = {newest->id, Rigid3::Identity()};
}

Tracker::Sought Tracker::FindPose(const Frame& frame, const Map& map) {
  using Way = std::optional<Fix> (Tracker::*)(const Frame&, const Map&) const;
  Sought sought;
  std::optional<Located>& best = sought.located;
  const auto take = [&](const std::optional<Fix>& coarse) {
    std::optional<Located> located = coarse ? TrackLocalMap(frame, map, *coarse) : std::nullopt;
    if (located && !IsPlausible(frame, map, located->fix)) {
      sought.was_refused = true;
      return false;
    }
    if (located && (!best || Speaking(frame, map, located->fix) > Speaking(frame, map, best->fix)))
      best = std::move(located);
    return best && IsConvincing(best->fix);
  };
  if (state_ != TrackingState::kLost) {
    for (const Way way : {&Tracker::TrackFromLast, &Tracker::TrackFromLastByFlow, &Tracker::TrackFromSurfaces,
                          &Tracker::TrackFromLastByAppearance, &Tracker::TrackFromKeyframe}) {
      if (take((this->*way)(frame, map))) return sought;
    }
    if (!best) take(TrackFromPrediction(frame, map));
  }
  if (!best) take(RelocalizeInMap(frame, map));
  if (!best && state_ == TrackingState::kTracking) {
    if (auto alone = TrackBlindly(frame, map)) best = Located{std::move(*alone), {}, {}};
  }
  return sought;
}

std::optional<Fix> Tracker::TrackFromLast(const Frame& frame, const Map& map) const {
  constexpr size_t kEnoughLandmarks = 150;
  constexpr float kWider = 2, kWidest = 4;
  const Rigid3 last_pose = LastPose(map);
  const Rigid3 predicted = PredictedPose(frame, map);
  const auto radius_px = static_cast<float>(options_.search_radius_px);
  std::optional<Fix> best;
  const auto search = [&](const std::vector<KnownPoint>& points, const Rigid3& guess, float radius) {
    const std::vector<int> rows = MatchKnownPoints(frame, guess, last_pose, points, radius);
    const auto num_matches = std::count_if(rows.begin(), rows.end(), [](int row) { return row >= 0; });
    if (num_matches < static_cast<std::ptrdiff_t>(kFewMatches)) return false;
    Fix fix = FixFromPoints(frame, guess, points, rows);
    if (fix.num_in_all() < kFewMatches) return false;
    const Support support = SupportFor(frame, map, fix);
    if (!support.empty()) fix = FixFromPoints(frame, fix.cam_from_world, points, rows, support);
    if (!best || Speaking(frame, map, fix) > Speaking(frame, map, *best)) best = std::move(fix);
    return IsConvincing(*best);
  };

  std::vector<KnownPoint> points = LandmarksOfLast(map);
  if (last_.num_found >= kEnoughLandmarks && search(points, predicted, radius_px)) return best;
  AddDepthPointsOfLast(map, points);
  if (search(points, predicted, radius_px) || search(points, predicted, kWider * radius_px)) return best;
  if (search(points, predicted, kWidest * radius_px)) return best;
  search(points, last_pose, kWidest * radius_px);
  return best;
}

std::optional<Fix> Tracker::TrackFromLastByAppearance(const Frame& frame, const Map& map) const {
  std::vector<KnownPoint> points = LandmarksOfLast(map);
  AddDepthPointsOfLast(map, points);
  auto fix = FixByAppearance(frame, points, Random(static_cast<uint64_t>(seed_), frame.id.value()));
  if (fix && fix->num_in_all() < kFewMatches) return std::nullopt;
  return fix;
}

/// The prediction alone says where the landmarks of the place must be: what drew other ways elsewhere is left out.
std::optional<Fix> Tracker::TrackFromPrediction(const Frame& frame, const Map& map) const {
  constexpr float kWidening = 2;
  if (!motion_.rate()) return std::nullopt;
  const LocalMap local = CollectLocalMap(map, last_.matches, static_cast<size_t>(options_.max_local_keyframes));
  Fix fix;
  fix.cam_from_world = PredictedPose(frame, map);
  fix.matches.resize(frame.size());
  const auto expected = ExpectLocalLandmarks(map, local, frame, fix.cam_from_world, fix.matches, kWidening);
  fix = FixWithExpected(frame, map, fix, expected);
  if (fix.num_inliers < kMinInliersOfGuess) return std::nullopt;
  return fix;
}

std::optional<Fix> Tracker::TrackFromKeyframe(const Frame& frame, const Map& map) const {
  const Keyframe* reference = map.Find(map.Surviving(last_.place.reference));
  if (!reference) return std::nullopt;
  Random random(static_cast<uint64_t>(seed_), frame.id.value());
  return RelocalizeAgainst(frame, map, *reference, {kMinInliersOfGuess, options_.relocalize_radius_px}, random);
}

std::optional<Fix> Tracker::RelocalizeInMap(const Frame& frame, const Map& map) {
  constexpr size_t kCandidates = 8;
  constexpr double kMinShare = 0.12, kMinSpread = 0.5;
  const RecognitionTerms terms{static_cast<size_t>(options_.min_inliers_after_loss), options_.relocalize_radius_px,
                               kMinShare, kMinSpread};
  const Random random(static_cast<uint64_t>(seed_), frame.id.value());
  if (!memory_.CanRecall()) return Relocalize(frame, map, NewestAndSomeOlder(map, frame.id), terms, random);
  memory_.Follow(map);
  const auto all = [](KeyframeId) { return true; };
  return Relocalize(frame, map, memory_.Recall(map, memory_.Describe(frame), kCandidates, all), terms, random);
}

std::optional<Tracker::Located> Tracker::TrackLocalMap(const Frame& frame, const Map& map, const Fix& coarse) const {
  Located located;
  LocalMap& local = located.local;
  local = CollectLocalMap(map, coarse.matches, static_cast<size_t>(options_.max_local_keyframes));
  if (local.keyframes.empty()) {
    // No landmark was matched, but the frame before is in view: its keyframe and, where it lies in the same sub-map,
    // the newest one, which may have been made of that very frame, stand for the place.
    const Keyframe* near = map.Find(map.Surviving(last_.place.reference));
    const Keyframe* newest = map.Find(map.newest_keyframe());
    if (near && newest && newest->root == near->root) local.keyframes.push_back(newest->id);
    if (near && near != newest) local.keyframes.push_back(near->id);
    if (near) local.reference = local.keyframes.front();
  }
  const auto widening = static_cast<float>(options_.local_widening);
  const std::vector<ExpectedLandmark> expected =
      ExpectLocalLandmarks(map, local, frame, coarse.cam_from_world, coarse.matches, widening);
  located.fix = FixWithExpected(frame, map, coarse, expected, SupportFor(frame, map, coarse));
  located.visible = coarse.matches;
  for (const ExpectedLandmark& e : expected) located.visible.push_back(e.id);
  constexpr size_t kFarMore = 3;
  const bool is_of_the_map = kFarMore * located.fix.num_inliers >= coarse.num_at_keypoints();
  if (is_of_the_map && IsConfirmed(frame, map, located.fix)) return located;
  // Too little of the map is in view; the frame before, with its own depth, may carry on alone.
  located.fix = coarse;
  if (IsConfirmed(frame, map, coarse)) return located;
  return std::nullopt;
}

/// Whether the frame before says nothing about this one: single pictures in no order are located one by one.
bool Tracker::IsAlone(const Frame& frame) const {
  return task_.only_locates && last_.frame &&
         SecondsBetween(last_.frame->timestamp, frame.timestamp) > options_.lost_after_s;
}

void Tracker::CountSeen(const Located& located) {
  for (const LandmarkId id : located.visible) {
    if (id.IsValid()) ++counts_[id].visible;
  }
  for (const LandmarkId id : located.fix.matches) {
    if (id.IsValid()) ++counts_[id].found;
  }
}

void Tracker::NoteMotion(const Frame& frame, const Map& map, const Located& located) {
  const Fix& fix = located.fix;
  if (last_.frame && !AreOfOneSubMap(map, last_.place.reference, PlaceOf(located, map).reference)) {
    motion_.Forget();
    movers_.Forget();
    surfaces_.Forget();
    state_ = TrackingState::kLost;
  }
  if (state_ == TrackingState::kTracking || motion_.rate()) {
    motion_.Observe(last_.frame->timestamp, frame.timestamp, fix.cam_from_world * LastPose(map).Inverse());
  } else {
    motion_.Forget();
    was_lost_ = true;
    lost_since_ = frame.timestamp;
  }
  state_ = TrackingState::kTracking;
  starts_over_ = false;
  sought_since_.reset();
}

CameraPlace Tracker::PlaceOf(const Located& located, const Map& map) const {
  const KeyframeId reference =
      located.local.reference.IsValid() ? located.local.reference : map.Surviving(last_.place.reference);
  return {reference, located.fix.cam_from_world * map.Find(reference)->cam_from_world.Inverse()};
}

void Tracker::Remember(const FramePtr& frame, const Map& map, const Located& located) {
  const Fix& fix = located.fix;
  last_ = {frame,
           PlaceOf(located, map),
           fix.matches,
           CountValid(fix.matches),
           fix.num_in_all() == 0 ? last_.num_blind + 1 : 0,
           frame,
           sight_.grey};
}

void Tracker::NoteLoss(const Frame& frame, bool was_refused) {
  if (!was_refused) motion_.Forget();  // otherwise the motion goes on unseen
  if (last_.frame) {                   // otherwise it was lost from the beginning
    const double seconds = SecondsBetween(last_.frame->timestamp, frame.timestamp);
    state_ = seconds < options_.lost_after_s ? TrackingState::kRecentlyLost : TrackingState::kLost;
    if (state_ == TrackingState::kLost) {
      movers_.Forget();
      surfaces_.Forget();
    }
  }
  const bool shows_something = CountPointsWithDepth(frame) >= options_.min_first_points;
  if (shows_something && !sought_since_) sought_since_ = frame.timestamp;
}

bool Tracker::IsTimeForANewMap(const Frame& frame, size_t backlog) const {
  return !task_.only_locates && state_ == TrackingState::kLost && backlog == 0 && sought_since_ &&
         SecondsBetween(*sought_since_, frame.timestamp) >= options_.new_map_after_s;
}

Proposal Tracker::Propose(const FramePtr& frame, const Fix& fix) {
  Proposal proposal{frame, last_.place.reference, last_.place.cam_from_reference, fix.matches, {}, {}};
  proposal.information = BesideLandmarks(*frame, fix);
  proposal.counts.reserve(counts_.size());
  for (const auto& [id, count] : counts_) proposal.counts.push_back({id, count.visible, count.found, count.gone});
  counts_.clear();
  last_proposal_ = frame->timestamp;
  frames_since_proposal_ = 0;
  return proposal;
}

std::vector<KnownPoint> Tracker::LandmarksOfLast(const Map& map) const {
  const Frame& frame = *last_.frame;
  std::vector<KnownPoint> points;
  for (size_t i = 0; i < frame.size(); ++i) {
    const LandmarkId id = map.Resolve(last_.matches[i]);
    const Landmark* landmark = id.IsValid() ? map.Find(id) : nullptr;
    if (!landmark) continue;
    const Keypoint& keypoint = frame.keypoints[i];
    points.push_back({landmark->position, landmark->descriptor, keypoint.octave, keypoint.angle_rad, id,
                      TrustIn(*landmark, map), landmark->IsGrownUp()});
  }
  return points;
}

Rigid3 Tracker::PredictedPose(const Frame& frame, const Map& map) const {
  return motion_.Predict(last_.frame->timestamp, frame.timestamp) * LastPose(map);
}

Rigid3 Tracker::LastPose(const Map& map) const {
  const auto reference = map.CamFromWorld(last_.place.reference);
  YORB_CHECK(reference.has_value(), "the reference of a confirmed frame stays answerable");
  return last_.place.cam_from_reference * *reference;
}

}  // namespace yorb
