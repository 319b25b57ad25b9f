// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Room: tracking. Finds where the camera is, one frame at a time.
// Takes: Frame, Map (a snapshot). Gives: FrameRecord, Proposal. Owns: the last confirmed frame, motion, state.
// Runs on: whichever thread calls Track. May not: change the map, start threads, read files.
#pragma once

#include <optional>
#include <unordered_map>

#include "localize/fix.h"
#include "localize/local_map.h"
#include "localize/place_memory.h"
#include "map/map.h"
#include "matching/by_flow.h"
#include "motion/mover_finder.h"
#include "motion/surfaces.h"
#include "tracking/motion_model.h"
#include "tracking/sight.h"
#include "tracking/tracking_options.h"

namespace yorb {

/// What became of a frame, and what it asks of the map.
struct Tracked {
  FrameRecord record;
  std::optional<Proposal> proposal;
  std::vector<Keypoint> moving;  ///< points that were left out since geometry says that they move
  /// The camera was lost for too long: the next frame that is not found in the map, which may be an earlier one, begins
  /// a sub-map.
  bool starts_over = false;
};

/// What a tracker is to do with the map.
struct TrackerTask {
  bool has_map = false;       ///< there is one already, in which the camera is sought; otherwise one is begun
  bool finds_movers = false;  ///< by geometry, where depth pictures are given
  bool only_locates = false;  ///< nothing is proposed, and only landmarks of the map confirm a pose
};

class Tracker {
 public:
  /// Without a vocabulary (null), a lost camera is sought among the newest keyframes and, in turn, some older ones.
  Tracker(const TrackingOptions& options, int64_t seed, const TrackerTask& task = {},
          VocabularyPtr vocabulary = nullptr)
      : options_(options),
        seed_(seed),
        task_(task),
        memory_(std::move(vocabulary)),
        state_(task.has_map ? TrackingState::kLost : TrackingState::kNotInitialized) {}

  /// `map` is the newest snapshot; `backlog` counts the proposals that the mapper has not worked off.
  Tracked Track(const FramePtr& frame, const Map& map, size_t backlog, Sight sight = {});

 private:
  static constexpr size_t kFewMatches = 20;  // with the frame before
  static constexpr double kEase = 0.25;      // of what a camera can do, where it goes on as it did

  /// Whether enough of what was matched agrees on the pose. Otherwise another way to it may be the better one: a few
  /// dozen matches of repeated texture agree on a wrong pose, too.
  static bool IsConvincing(const Fix& fix);

  /// The newest frame whose pose was confirmed.
  struct Confirmed {
    FramePtr frame;  ///< null: there was none yet
    CameraPlace place;
    std::vector<LandmarkId> matches;
    size_t num_found = 0;  ///< of `matches`, before a keyframe that was made of the frame brought more
    int num_blind = 0;     ///< frames in a row up to it in which no point speaks for the pose
    FramePtr picture;      ///< the frame as it came, with all of its points
    cv::Mat grey;          ///< its pixels, if they were given
  };

  /// A pose that the map confirms.
  struct Located {
    Fix fix;
    LocalMap local;
    std::vector<LandmarkId> visible;  ///< landmarks that should be seen from there
  };

  /// Known points on their way into the next picture; the rows belong together.
  struct Followed {
    std::vector<FlowGuess> guesses;
    std::vector<PoseObservation> points;
  };

  /// What came of looking for a pose.
  struct Sought {
    std::optional<Located> located;
    bool was_refused = false;  ///< there was a pose where no camera gets so fast
  };

  Tracked Begin(const FramePtr& raw_frame, const Map& map);
  Tracked TrackInMap(const FramePtr& frame, const Map& map, size_t backlog);
  Tracked StandStill();
  void FollowKeyframe(const Map& map);
  Sought FindPose(const Frame& frame, const Map& map);
  std::optional<Fix> TrackFromLast(const Frame& frame, const Map& map) const;
  std::optional<Fix> TrackFromLastByFlow(const Frame& frame, const Map& map) const;
  std::optional<Fix> TrackFromLastByAppearance(const Frame& frame, const Map& map) const;
  std::optional<Fix> TrackFromPrediction(const Frame& frame, const Map& map) const;
  std::optional<Rigid3> PoseOnSurfaces(const Frame& frame, const Map& map) const;
  std::optional<Fix> TrackFromSurfaces(const Frame& frame, const Map& map) const;
  std::optional<Fix> TrackBlindly(const Frame& frame, const Map& map) const;
  std::optional<Fix> TrackFromKeyframe(const Frame& frame, const Map& map) const;
  std::optional<Fix> RelocalizeInMap(const Frame& frame, const Map& map);
  std::optional<Located> TrackLocalMap(const Frame& frame, const Map& map, const Fix& coarse) const;
  bool IsConfirmed(const Frame& frame, const Map& map, const Fix& fix) const;
  bool GoesOn(const Frame& frame, const Map& map, const Fix& fix) const;
  bool IsPlausible(const Frame& frame, const Map& map, const Fix& fix) const;
  size_t Speaking(const Frame& frame, const Map& map, const Fix& fix) const;
  bool IsAlone(const Frame& frame) const;
  void CountSeen(const Located& located);
  void CountGone(const Frame& frame, const Map& map, const Located& located);
  MovingCells FindMovers(const FramePtr& frame, const Map& map, const Located& located);
  std::vector<Keypoint> LeaveOut(const MovingCells& movers, FramePtr& frame, const Map& map, Fix& fix,
                                 const Support& support);
  Support SupportFor(const Frame& frame, const Map& map, const Fix& fix) const;
  void NoteMotion(const Frame& frame, const Map& map, const Located& located);
  CameraPlace PlaceOf(const Located& located, const Map& map) const;
  void Remember(const FramePtr& frame, const Map& map, const Located& located);
  void NoteLoss(const Frame& frame, bool was_refused);
  bool IsTimeForANewMap(const Frame& frame, size_t backlog) const;
  Proposal Propose(const FramePtr& frame, const Fix& fix);
  std::vector<KnownPoint> LandmarksOfLast(const Map& map) const;
  Followed PointsToFollow(const Frame& frame, const Map& map) const;
  std::vector<PoseObservation> FollowPointsOfLast(const Frame& frame, const Map& map) const;
  void AddDepthPointsOfLast(const Map& map, std::vector<KnownPoint>& points) const;
  Rigid3 LastPose(const Map& map) const;
  Rigid3 PredictedPose(const Frame& frame, const Map& map) const;

  TrackingOptions options_;
  int64_t seed_;
  TrackerTask task_;
  PlaceMemory memory_;
  TrackingState state_;
  Confirmed last_;
  MotionModel motion_;
  MoverFinder movers_;
  Surfaces surfaces_;
  Sight sight_;  ///< of the newest frame
  std::unordered_map<LandmarkId, LandmarkCount> counts_;
  Timestamp last_proposal_, lost_since_;
  std::optional<Timestamp> sought_since_;  ///< the first frame since the last confirmed one that showed something
  int frames_since_proposal_ = 0;
  bool was_lost_ = false;
  bool starts_over_ = false;  ///< lost for too long: the next one that shows enough begins a sub-map
};

}  // namespace yorb
