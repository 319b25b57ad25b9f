// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Room: map. The one store of what the world looks like: a value with one writer.
// Takes: frames, poses, points from the mapper. Gives: snapshots that never change. Owns: keyframes and landmarks.
// Runs on: writing methods on the mapper's thread alone; a snapshot on any. May not: match, optimise, start threads.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "map/keyframe.h"
#include "map/landmark.h"
#include "map/paged_table.h"

namespace yorb {

class Map;
using MapSnapshot = std::shared_ptr<const Map>;

/// Keyframes, landmarks, who sees whom, and the spanning tree. Ids are never used again: "is bad" becomes "is not
/// there". Each writing method keeps both ends of a link.
///
/// A map consists of sub-maps, each with a tree and a world of its own: one begins where nothing was known any more. No
/// landmark is seen from two of them. They become one when it turns out how they lie to each other.
class Map {
 public:
  // ---- reading, on any thread -------------------------------------------------------------------------------------
  /// The row, or null where it is not (any more).
  const Keyframe* Find(KeyframeId id) const { return keyframes_.Find(id); }
  const Landmark* Find(LandmarkId id) const { return landmarks_.Find(id); }

  /// The landmark that this one was merged into, or itself. Merges are remembered for as long as somebody may hold the
  /// old id: for some keyframes, kMergesRemembered.
  LandmarkId Resolve(LandmarkId id) const;

  /// The pose of a keyframe that is there or was removed; nothing for ids that never were.
  std::optional<Rigid3> CamFromWorld(KeyframeId id) const;

  /// All landmarks that these keyframes see, each once, by ascending id.
  std::vector<LandmarkId> SeenBy(const std::vector<KeyframeId>& keyframes) const;

  /// The keyframe itself, or, where it was removed, the nearest ancestor that is there.
  KeyframeId Surviving(KeyframeId id) const;

  template <typename Visitor>
  void VisitKeyframes(Visitor&& visit) const {
    keyframes_.Visit(visit);
  }
  template <typename Visitor>
  void VisitLandmarks(Visitor&& visit) const {
    landmarks_.Visit(visit);
  }
  size_t num_keyframes() const { return keyframes_.size(); }
  size_t num_landmarks() const { return landmarks_.size(); }
  KeyframeId newest_keyframe() const { return newest_keyframe_; }

  /// The ids that the next ones will have.
  KeyframeId next_keyframe() const { return keyframes_.next_id(); }
  LandmarkId next_landmark() const { return landmarks_.next_id(); }

  size_t num_loops() const { return num_loops_; }  ///< that were closed

  /// The first broken invariant in words, empty when all hold. Slow: for tests.
  std::string Check() const;

  /// A map of one's own to go on from a snapshot, which never changes.
  static Map Continuing(const Map& snapshot);

  // ---- writing, by the mapper -------------------------------------------------------------------------------------
  /// What others read from now on; this map goes on.
  MapSnapshot Snapshot();

  /// Without a parent, a new sub-map begins with it.
  KeyframeId AddKeyframe(FramePtr frame, const Rigid3& cam_from_world, KeyframeId parent);

  /// A new landmark, seen first at `index` of `keyframe`.
  LandmarkId AddLandmark(const Eigen::Vector3d& x_in_world, KeyframeId keyframe, uint32_t index);

  /// Adds a view, unless the keyframe sees the landmark already or its keypoint sees another one: then false.
  bool Observe(LandmarkId landmark, KeyframeId keyframe, uint32_t index);

  /// Takes a view away; a landmark without views goes with its last one.
  void Unobserve(LandmarkId landmark, KeyframeId keyframe);

  /// `from` becomes `into`: its views where `into` has none, its counts, its name.
  void Merge(LandmarkId from, LandmarkId into);

  void Remove(LandmarkId id);
  /// Its views go, its children find a new parent, its pose stays answerable. Not for a root.
  void Remove(KeyframeId id);

  void SetPose(KeyframeId id, const Rigid3& cam_from_world) { keyframes_.Writable(id).cam_from_world = cam_from_world; }
  void SetTie(KeyframeId id, const Tie& tie) { keyframes_.Writable(id).tie = tie; }
  void SetLines(KeyframeId id, LineSightsPtr lines) { keyframes_.Writable(id).lines = std::move(lines); }
  void SetBag(KeyframeId id, std::shared_ptr<const Bag> bag) { keyframes_.Writable(id).bag = std::move(bag); }
  void SetPosition(LandmarkId id, const Eigen::Vector3d& x_in_world) { landmarks_.Writable(id).position = x_in_world; }

  /// Two keyframes of one sub-map show the same place, as has turned out: remembered, and counted as a loop.
  void AddLoop(KeyframeId a, KeyframeId b);

  /// The sub-map of `joining` becomes part of that of `into`, below which it hangs from now on. Its poses and positions
  /// must be given in the other world before, or right after.
  void Join(KeyframeId joining, KeyframeId into);

  /// Computes direction and distances of a landmark anew from its views.
  void RefreshGeometry(LandmarkId id);

  /// The same, and its descriptor: after its views changed.
  void Refresh(LandmarkId id);

  /// Adds to the counts of a landmark, if it is still there.
  void Count(LandmarkId id, int visible, int found);

  /// A tracker that has seen the last keyframes but so many may hold ids that were merged since.
  static constexpr uint32_t kMergesRemembered = 20;

 private:
  friend class MapAssembly;
  /// What stays of a keyframe: a row each, so that snapshots share them.
  struct Past {
    KeyframeId parent;  ///< not valid while the keyframe is there
    Rigid3 cam_from_parent_cam;
  };
  struct MergeRecord {
    LandmarkId from;
    KeyframeId newest_keyframe;  ///< of that time
  };

  const Past* FindPast(KeyframeId id) const;
  void ForgetOldMerges();
  void Link(KeyframeId a, KeyframeId b, int change);
  void AdoptChildren(const Keyframe& leaving);
  void SetParent(KeyframeId child, KeyframeId parent);
  void DropChild(KeyframeId parent, KeyframeId child);
  bool IsAbove(KeyframeId above, KeyframeId id) const;

  PagedTable<Keyframe> keyframes_;
  PagedTable<Landmark> landmarks_;
  PagedTable<Past> past_;
  std::unordered_map<LandmarkId, LandmarkId> merged_into_;
  std::deque<MergeRecord> merges_;  ///< in the order of time; the writer's alone
  KeyframeId newest_keyframe_;
  size_t num_loops_ = 0;
};

}  // namespace yorb
