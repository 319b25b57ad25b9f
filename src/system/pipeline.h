// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <variant>
#include <vector>

#include "core/channel.h"
#include "core/latest.h"
#include "dynamics/remover.h"
#include "features/frame_builder.h"
#include "looping/looper.h"
#include "mapping/mapper.h"
#include "motion/depth_grid.h"
#include "system/frame_log.h"
#include "system/slam.h"
#include "tracking/tracker.h"

namespace yorb {

/// The stages and the streams between them; the only place where stages meet, and where threads live.
///
///   images --+--extract--+--remove--> frames --track--> events --map~~~> view (read by track and loop)
///            +--detect---+                                ^   |
///                                            corrections  |   v  added
///                                                        loop
///
/// Inline mode calls the same functions one after the other. Offline and live differ in the policy of the first stream
/// and in the detector's: offline each frame that the detector looks at waits for its own boxes, live only until the
/// next picture is due, or else takes the newest there are.
class Pipeline {
 public:
  Pipeline(const Config& config, const Rig& rig, SlamParts parts);
  ~Pipeline();

  bool Push(ImageSet images);
  void Finish();

  /// What a stage threw on its thread: all streams are closed then.
  Status Fault() const;

  MapSnapshot Snapshot() const { return view_.Get(); }
  SlamReport Report() const { return log_.Report(*view_.Get(), first_own_, smooth_); }
  size_t num_frames_done() const { return log_.num_frames(); }

 private:
  /// What was decided about the points of a picture before its pose was known, for who wants to watch.
  struct Judged {
    ImageSet images;
    std::vector<Keypoint> points;
    std::vector<Verdict> verdicts;
    MovingAreas areas;
  };

  /// A frame on its way to the tracker.
  struct Extracted {
    FramePtr frame;
    FrameRecord record;  ///< what is known of it so far
    Sight sight;         ///< without depth, no surface is asked and nothing is looked for that moves
    std::optional<Judged> judged;
  };

  /// What the detector said, and of which picture.
  struct Looked {
    Detections seen;
    Timestamp at;
    double detect_ms = 0;
  };

  struct EndOfFrames {};
  using Event = std::variant<Proposal, Correction, EndOfFrames>;

  Looked Detect(const ImageSet& images);
  bool AskDetector(const ImageSet& images);
  Looked Await(const ImageSet& images, bool was_asked);
  std::optional<Looked> Newest(Timestamp now, bool was_asked);
  Extracted Extract(const ImageSet& images);
  Extracted Remove(const ImageSet& images, Features features, const Looked& looked);
  bool TrackAll(Extracted extracted, const std::function<bool(Proposal)>& give);
  bool IsAwaited(const Proposal& proposal) const;
  Tracked Track(Extracted& extracted);
  KeyframeId Handle(const Proposal& proposal, const MapperHooks& hooks);
  template <typename Apply>
  void LookForLoops(KeyframeId added, Apply&& apply);

  void Spawn(void (Pipeline::*stage)());
  void CloseAll();
  void RunDetection();
  void RunExtraction();
  void RunTracking();
  void RunMapping();
  void RunLooping();

  const Mode mode_;
  const bool smooth_;  ///< the trajectory
  SlamParts parts_;
  FrameBuilder builder_;
  const Dynamics dynamics_;
  const double detection_interval_s_;
  DepthGridMaker grids_;
  Remover remover_;
  Tracker tracker_;
  Mapper mapper_;
  Looper looper_;

  Channel<ImageSet> images_;
  Channel<ImageSet> to_detect_;
  Channel<Looked> looked_;
  Channel<Extracted> frames_;
  Channel<Event> events_;               ///< what the mapper works off; corrections never wait
  Channel<KeyframeId> added_;           ///< what the looper works off; the mapper never waits
  Channel<MapSnapshot> applied_;        ///< the looper waits for its corrections to be in the map
  Channel<MapSnapshot> handled_;        ///< the tracker waits for the map: offline always, live for its beginning
  std::atomic<size_t> num_pending_{0};  ///< proposals that the mapper has not worked off
  Latest<Map> view_;
  Latest<Error> fault_;
  FrameLog log_;
  std::deque<Extracted> waiting_;  ///< of the tracker: what it has seen since it was lost
  const KeyframeId first_own_;     ///< all before are those of the map that was gone on from
  uint32_t next_frame_;
  std::optional<Looked> newest_;         ///< live, where boxes are not followed: the newest
  std::optional<Timestamp> last_asked_;  ///< the newest picture that the detector was given
  std::optional<Timestamp> last_taken_;  ///< live: the newest picture
  double last_detect_s_ = 0;             ///< live: how long the detector took last
  std::vector<std::thread> threads_;
};

}  // namespace yorb
