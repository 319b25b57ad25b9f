// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "system/pipeline.h"

#include "core/stopwatch.h"

namespace yorb {
namespace {

constexpr size_t kImagesAhead = 2, kFramesAhead = 1, kProposalsAhead = 4;

}  // namespace

Pipeline::Pipeline(const Config& config, const Rig& rig, Mode mode)
    : mode_(mode),
      builder_(config.features, rig),
      tracker_(config.tracking, config.seed),
      mapper_(config.mapping),
      images_(kImagesAhead),
      frames_(kFramesAhead),
      proposals_(kProposalsAhead),
      first_map_(1),
      view_(std::make_shared<const Map>()) {
  if (mode_ == Mode::kInline) return;
  try {
    Spawn(&Pipeline::RunExtraction);
    Spawn(&Pipeline::RunTracking);
    Spawn(&Pipeline::RunMapping);
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
  if (const auto proposal = Track(Extract(images))) {
    Handle(*proposal, {});
    view_.Set(mapper_.Snapshot());
  }
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
  frames_.Close();
  proposals_.Close();
  first_map_.Close();
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

Pipeline::Extracted Pipeline::Extract(const ImageSet& images) {
  const Stopwatch watch;
  Extracted extracted;
  extracted.frame = builder_.Build(FrameId(next_frame_++), images);
  extracted.extract_ms = watch.ms();
  return extracted;
}

std::optional<Proposal> Pipeline::Track(const Extracted& extracted) {
  const Stopwatch watch;
  const MapSnapshot map = view_.Get();
  Tracked tracked = tracker_.Track(extracted.frame, *map, num_pending_);
  tracked.record.extract_ms = extracted.extract_ms;
  tracked.record.track_ms = watch.ms();
  tracked.record.frame_total_ms = tracked.record.extract_ms + tracked.record.track_ms;
  log_.Add(tracked.record);
  return std::move(tracked.proposal);
}

void Pipeline::Handle(const Proposal& proposal, const MapperHooks& hooks) { log_.Add(mapper_.Handle(proposal, hooks)); }

void Pipeline::RunExtraction() {
  while (const auto images = images_.Pop()) frames_.Push(Extract(*images));
  frames_.Close();
}

void Pipeline::RunTracking() {
  while (const auto extracted = frames_.Pop()) {
    auto proposal = Track(*extracted);
    if (!proposal) continue;
    const bool is_first = !proposal->reference.IsValid();
    ++num_pending_;
    proposals_.Push(*std::move(proposal));
    if (is_first) first_map_.Pop();
  }
  proposals_.Close();
}

void Pipeline::RunMapping() {
  const MapperHooks hooks{[this] { return proposals_.Backlog() > 0; },
                          [this](MapSnapshot map) { view_.Set(std::move(map)); }};
  while (const auto proposal = proposals_.Pop()) {
    Handle(*proposal, hooks);
    view_.Set(mapper_.Snapshot());
    --num_pending_;
    if (!proposal->reference.IsValid()) first_map_.Push(view_.Get());
  }
}

}  // namespace yorb
