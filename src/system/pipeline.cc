// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "system/pipeline.h"

#include <algorithm>
#include <utility>

#include "core/priority.h"
#include "core/stopwatch.h"

namespace yorb {
namespace {

constexpr size_t kImagesAhead = 2, kFramesAhead = 1, kProposalsAhead = 4;

Mode ModeOf(const Config& config) {
  if (config.mode == "inline") return Mode::kInline;
  return config.mode == "live" ? Mode::kLive : Mode::kOffline;
}

Dynamics DynamicsOf(const Config& config) {
  if (config.dynamics == "off") return Dynamics::kOff;
  return config.dynamics == "full" ? Dynamics::kFull : Dynamics::kPaper;
}

/// Only a network is worth sparing, and only boxes that are followed can move along to the pictures between.
double DetectionIntervalOf(const Config& config) {
  return DynamicsOf(config) == Dynamics::kFull && config.detections.empty() ? config.detection.interval_s : 0;
}

/// Where nothing is removed, no more is extracted than is wanted.
FeatureOptions FeaturesOf(const Config& config) {
  FeatureOptions features = config.features;
  if (config.dynamics == "off" && config.masks.empty()) features.over_extraction = 1;
  return features;
}

MapSnapshot StartOf(const SlamParts& parts) { return parts.map ? parts.map : std::make_shared<const Map>(); }

TrackerTask TaskOf(const Config& config, const SlamParts& parts) {
  return {StartOf(parts)->num_keyframes() > 0, DynamicsOf(config) == Dynamics::kFull, config.localize_only};
}

/// The first frame id that no keyframe of the map has.
uint32_t NextFrame(const Map& map) {
  uint32_t next = 0;
  map.VisitKeyframes([&](const Keyframe& keyframe) { next = std::max(next, keyframe.frame->id.value() + 1); });
  return next;
}

/// The share of a mask that is not 0.
double ShareOf(const cv::Mat& mask) {
  return mask.empty() ? 0 : static_cast<double>(cv::countNonZero(mask)) / static_cast<double>(mask.total());
}

/// Whether moving things took most points: those that were extracted are spread over the whole picture, and what is
/// left of it has more to give. Where suspects are kept, fewer others will do.
bool NeedsSecondLook(const FrameRecord& record, bool keeps_suspects) {
  const int share = keeps_suspects ? 4 : 2;
  return record.num_removed > 0 && share * (record.num_extracted - record.num_removed) < record.num_extracted;
}

}  // namespace

Pipeline::Pipeline(const Config& config, const Rig& rig, SlamParts parts)
    : mode_(ModeOf(config)),
      smooth_(config.smooth),
      parts_(std::move(parts)),
      builder_(FeaturesOf(config), rig),
      dynamics_(DynamicsOf(config)),
      detection_interval_s_(DetectionIntervalOf(config)),
      grids_(rig),
      remover_(dynamics_, parts_.motions, config.features.scale_factor, SureConfidence(config)),
      tracker_(config.tracking, config.seed, TaskOf(config, parts_), parts_.vocabulary),
      mapper_(config.mapping, parts_.vocabulary, Map::Continuing(*StartOf(parts_))),
      looper_(config.looping, parts_.vocabulary, config.seed),
      images_(kImagesAhead),
      to_detect_(1),
      looked_(1),
      frames_(kFramesAhead),
      events_(kProposalsAhead),
      added_(1),
      applied_(1),
      handled_(1),
      view_(mapper_.Snapshot()),
      first_own_(view_.Get()->next_keyframe()),
      next_frame_(NextFrame(*view_.Get())) {
  if (mode_ == Mode::kInline) return;
  try {
    if (parts_.detector) Spawn(&Pipeline::RunDetection);
    Spawn(&Pipeline::RunExtraction);
    Spawn(&Pipeline::RunTracking);
    Spawn(&Pipeline::RunMapping);
    Spawn(&Pipeline::RunLooping);
  } catch (...) {  // no more threads to be had
    CloseAll();
    Finish();
    throw;
  }
}

Pipeline::~Pipeline() { Finish(); }

bool Pipeline::Push(ImageSet images) {
  if (mode_ == Mode::kOffline) return images_.Push(std::move(images));
  if (mode_ == Mode::kLive) return images_.TryPush(std::move(images));
  TrackAll(Extract(images), [this](const Proposal& proposal) {
    const KeyframeId added = Handle(proposal, {});
    view_.Set(mapper_.Snapshot());
    LookForLoops(added, [this](const Correction& correction) {
      mapper_.Apply(correction);
      view_.Set(mapper_.Snapshot());
    });
    return true;
  });
  return true;
}

void Pipeline::Spawn(void (Pipeline::*stage)()) {
  threads_.emplace_back([this, stage] {
    try {
      (this->*stage)();
    } catch (const std::exception& error) {
      fault_.Set(std::make_shared<const Error>(FailureOf(error)));
      CloseAll();
    }
  });
}

void Pipeline::CloseAll() {
  images_.Close();
  to_detect_.Close();
  looked_.Close();
  frames_.Close();
  events_.Close();
  added_.Close();
  applied_.Close();
  handled_.Close();
}

Status Pipeline::Fault() const {
  const auto fault = fault_.Get();
  return fault ? Status(*fault) : Status::Ok();
}

void Pipeline::Finish() {
  images_.Close();
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

Pipeline::Looked Pipeline::Detect(const ImageSet& images) {
  const Stopwatch watch;
  auto seen = parts_.detector->Detect(images);
  if (!seen) {
    fault_.Set(std::make_shared<const Error>(seen.error()));
    CloseAll();
    return {};
  }
  return {*std::move(seen), images.timestamp, watch.ms()};
}

bool Pipeline::AskDetector(const ImageSet& images) {
  if (!parts_.detector) return false;
  if (last_asked_ && SecondsBetween(*last_asked_, images.timestamp) < detection_interval_s_) return false;
  if (mode_ == Mode::kOffline) to_detect_.Push(images);
  if (mode_ == Mode::kLive && !to_detect_.TryPush(images)) return false;
  last_asked_ = images.timestamp;
  return true;
}

Pipeline::Looked Pipeline::Await(const ImageSet& images, bool was_asked) {
  const Looked nobody{{false, {}}, images.timestamp, 0};
  if (!parts_.detector || (!was_asked && mode_ != Mode::kLive)) return nobody;
  if (mode_ == Mode::kInline) return Detect(images);
  if (mode_ == Mode::kLive) return Newest(images.timestamp, was_asked).value_or(nobody);
  return looked_.Pop().value_or(nobody);
}

/// Live: the newest boxes that have come, or the picture's own, if they will be there before the next picture is due.
/// Those that nobody follows from picture to picture count until there are others.
std::optional<Pipeline::Looked> Pipeline::Newest(Timestamp now, bool was_asked) {
  constexpr double kLongestS = 0.5;
  const Stopwatch watch;
  const double due_s = last_taken_ ? SecondsBetween(*last_taken_, now) : kLongestS;
  last_taken_ = now;
  std::optional<Looked> newest;
  const auto take = [&](std::optional<Looked> looked) {
    if (!looked) return false;
    last_detect_s_ = 1e-3 * looked->detect_ms;
    newest = std::move(looked);
    return true;
  };
  while (take(looked_.TryPop())) continue;
  const auto is_own = [&] { return newest && newest->at == now; };
  const bool is_worth_it = was_asked && images_.Backlog() == 0 && last_detect_s_ < due_s;
  while (is_worth_it && !is_own() && take(looked_.PopWithin(due_s - watch.seconds()))) continue;
  if (dynamics_ == Dynamics::kFull) return newest;
  if (newest) newest_ = newest;
  if (newest_ && SecondsBetween(newest_->at, now) > kLongestS) newest_.reset();
  return newest_;
}

Pipeline::Extracted Pipeline::Remove(const ImageSet& images, Features features, const Looked& looked) {
  Extracted extracted;
  extracted.sight.grey = images.grey;
  FrameRecord& record = extracted.record;
  const Stopwatch watch;
  const MovingAreas areas = remover_.Look(images, {looked.seen, looked.at});
  std::vector<Verdict> verdicts = areas.Judge(features.keypoints);
  record.num_extracted = static_cast<int>(features.keypoints.size());
  record.num_removed = static_cast<int>(std::count(verdicts.begin(), verdicts.end(), Verdict::kDynamic));
  record.num_given_back = static_cast<int>(std::count(verdicts.begin(), verdicts.end(), Verdict::kGivenBack));
  record.num_boxes = static_cast<int>(areas.boxes().size());
  record.num_bridged = areas.num_bridged();
  if (parts_.watch) extracted.judged = Judged{images, features.keypoints, verdicts, areas};
  extracted.sight.covered = areas.Covered(images.grey.size());
  if (dynamics_ != Dynamics::kOff) {
    extracted.sight.depth = grids_.Make(images.depth, extracted.sight.covered);
    extracted.sight.hidden = ShareOf(extracted.sight.covered);
  }
  record.remove_ms = watch.ms();
  const auto is_dynamic = [&](size_t i) { return verdicts[i] == Verdict::kDynamic; };
  const bool keeps_suspects = dynamics_ == Dynamics::kFull;
  Features suspects;
  if (keeps_suspects && record.num_removed > 0) {
    suspects = Kept(features, [&](size_t i) { return is_dynamic(i) && !areas.Ignores(features.keypoints[i]); });
  }
  if (NeedsSecondLook(record, keeps_suspects)) {
    const auto may_use = [&](const Keypoint& point) { return areas.Judge(point) != Verdict::kDynamic; };
    features = builder_.ExtractAgain(may_use);
  } else if (record.num_removed > 0) {
    features = Kept(std::move(features), [&](size_t i) { return !is_dynamic(i); });
  }
  extracted.frame = builder_.Build(FrameId(next_frame_++), images, std::move(features), std::move(suspects));
  record.num_static = static_cast<int>(extracted.frame->size() - extracted.frame->num_suspects);
  record.detect_ms = looked.detect_ms;
  return extracted;
}

Pipeline::Extracted Pipeline::Extract(const ImageSet& images) {
  const Stopwatch total;
  const bool was_asked = AskDetector(images);
  const Stopwatch watch;
  Features features = builder_.Extract(images);
  const double features_ms = watch.ms();
  const Stopwatch preparing;
  remover_.Prepare(images);  // while the detector looks
  const double prepare_ms = preparing.ms();
  const Looked looked = Await(images, was_asked);
  const double waited_ms = total.ms();
  Extracted extracted = Remove(images, std::move(features), looked);
  // Extraction is the points, those of a second look, and, after the removal, the frame of them.
  extracted.record.extract_ms = features_ms + total.ms() - waited_ms - extracted.record.remove_ms;
  extracted.record.remove_ms += prepare_ms;
  extracted.record.frame_total_ms = total.ms();
  return extracted;
}

KeyframeId Pipeline::Handle(const Proposal& proposal, const MapperHooks& hooks) {
  const MappingTimes times = mapper_.Handle(proposal, hooks);
  log_.Add(times);
  return times.added;
}

/// `apply` returns once the correction is in the map that `view_` shows.
template <typename Apply>
void Pipeline::LookForLoops(KeyframeId added, Apply&& apply) {
  if (!looper_.IsActive()) return;
  const Stopwatch look;
  const auto closed = looper_.Look(added, *view_.Get());
  if (closed) apply(*closed);
  log_.Add("looping", look.ms());
  if (!looper_.WantsToAdjust()) return;
  const Stopwatch adjust;
  const auto adjusted = looper_.Adjust(*view_.Get(), {});
  if (adjusted) apply(*adjusted);
  log_.Add("global_ba", adjust.ms());
}

void Pipeline::RunDetection() {
  while (const auto images = to_detect_.Pop()) {
    Looked looked = Detect(*images);
    if (mode_ == Mode::kLive) {
      looked_.PushNow(std::move(looked));  // the newest are taken, whatever is left there from before
    } else {
      looked_.Push(std::move(looked));
    }
  }
  looked_.Close();
}

void Pipeline::RunExtraction() {
  // Boxes take longer than points, and both are wanted at once.
  if (parts_.detector && mode_ == Mode::kOffline) GiveWay(CanWait::kMoments);
  while (const auto images = images_.Pop()) frames_.Push(Extract(*images));
  to_detect_.Close();
  looked_.Close();  // live: the last boxes find nobody who waits for them
  frames_.Close();
}

void Pipeline::RunTracking() {
  const auto give = [this](Proposal proposal) {
    const bool is_awaited = IsAwaited(proposal);
    ++num_pending_;
    events_.Push(std::move(proposal));
    return !is_awaited || handled_.Pop().has_value();
  };
  while (auto extracted = frames_.Pop()) {
    if (!TrackAll(*std::move(extracted), give)) break;
  }
  events_.Push(EndOfFrames());
}

/// Whether the tracker goes on only when the mapper has worked a proposal off. Offline, where nothing is late, each
/// keyframe is adjusted before the next frame is measured on it; live, a sub-map must at least have begun.
bool Pipeline::IsAwaited(const Proposal& proposal) const {
  return mode_ == Mode::kOffline || !proposal.reference.IsValid();
}

void Pipeline::RunMapping() {
  MapperHooks hooks;
  hooks.publish = [this](MapSnapshot map) { view_.Set(std::move(map)); };
  if (mode_ == Mode::kLive) {
    GiveWay(CanWait::kWhile);  // frames wait for their boxes, points and poses, seldom for the map
    hooks.is_busy = [this] { return events_.Backlog() > 0; };
  }
  while (const auto event = events_.Pop()) {
    if (const auto* proposal = std::get_if<Proposal>(&*event)) {
      const KeyframeId added = Handle(*proposal, hooks);
      view_.Set(mapper_.Snapshot());
      --num_pending_;
      if (IsAwaited(*proposal)) handled_.Push(view_.Get());
      added_.PushNow(added);
    } else if (const auto* correction = std::get_if<Correction>(&*event)) {
      mapper_.Apply(*correction);
      view_.Set(mapper_.Snapshot());
      applied_.Push(view_.Get());
    } else {
      added_.Close();  // the looper ends the events once it has looked at what is left
    }
  }
}

void Pipeline::RunLooping() {
  GiveWay(CanWait::kWhile);
  while (const auto added = added_.Pop()) {
    LookForLoops(*added, [this](const Correction& correction) {
      events_.PushNow(correction);
      applied_.Pop();
    });
  }
  events_.Close();
}

}  // namespace yorb
