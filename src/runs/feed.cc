// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/feed.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <string>
#include <thread>
#include <utility>

#include "core/log.h"
#include "core/prefetch.h"
#include "core/stopwatch.h"
#include "datasets/depth_watch.h"

namespace yorb {
namespace {

constexpr size_t kReadAhead = 2;        // frames; one of 640 x 480 takes 2 MB
constexpr double kLongestWaitS = 1;     // live: between two frames, however long the gap in the recording is
constexpr double kSignalCheckS = 0.02;  // live: how often a wait looks whether it shall end

struct ReadFrame {
  size_t index = 0;
  double read_ms = 0;
  Result<LoadedFrame> loaded;
};

/// Reads the frames in their order, ahead of their use.
class Reader {
 public:
  Reader(const Dataset& dataset, size_t count)
      : frames_([&dataset, count, next = size_t{0}]() mutable { return Read(dataset, next++, count); }, kReadAhead) {}

  std::optional<ReadFrame> Next() { return frames_.Next(); }

 private:
  static std::optional<ReadFrame> Read(const Dataset& dataset, size_t index, size_t count) {
    if (index >= count) return std::nullopt;
    const Stopwatch watch;
    Result<LoadedFrame> loaded = dataset.Load(index);
    return ReadFrame{index, watch.ms(), std::move(loaded)};
  }

  Prefetch<ReadFrame> frames_;
};

/// Lets the frames of a recording go at the pace of their time stamps.
class Pace {
 public:
  /// Waits until the frame is due; false when the wait shall end. A frame that comes late (a slow disk, results being
  /// saved) moves all later ones: what the player owes is not asked of the system in a burst.
  bool WaitFor(Timestamp time, const std::function<bool()>& should_stop) {
    const auto now = std::chrono::steady_clock::now();
    if (!last_) {
      due_ = now;
    } else {
      const double wait_s = std::clamp(SecondsBetween(*last_, time), 0.0, kLongestWaitS);
      due_ = std::max(now, due_ + std::chrono::nanoseconds(static_cast<int64_t>(wait_s * 1e9)));
    }
    last_ = time;
    const auto slice = std::chrono::nanoseconds(static_cast<int64_t>(kSignalCheckS * 1e9));
    while (std::chrono::steady_clock::now() < due_) {
      if (should_stop && should_stop()) return false;
      std::this_thread::sleep_until(std::min(due_, std::chrono::steady_clock::now() + slice));
    }
    return true;
  }

 private:
  std::optional<Timestamp> last_;
  std::chrono::steady_clock::time_point due_;
};

/// Hands one frame on. Nothing where the run cannot go on; `log` then says why.
std::optional<Fate> PushFrame(LoadedFrame frame, Slam& slam, FeedLog& log) {
  log.num_skipped += static_cast<size_t>(frame.num_skipped);
  if (!frame.images) return Fate::kSkipped;
  const auto is_pushed = slam.Push(*std::move(frame.images));
  if (!is_pushed) {
    log.error = is_pushed.error();
    return std::nullopt;
  }
  return *is_pushed ? Fate::kPushed : Fate::kDropped;
}

/// Boxes of a file and pictures that are stored lying: `yorb detect` gives them in the picture as viewers show it.
class TurnedPictures {
 public:
  explicit TurnedPictures(const Config& config)
      : boxes_(config.dynamics == "off" ? std::string() : config.detections) {}

  void Watch(const LoadedFrame& frame, const std::string& name) {
    if (frame.orientation == 1 || boxes_.empty()) return;
    LogWarning("turned-pictures", name + " is to be turned, says its EXIF block (orientation " +
                                      std::to_string(frame.orientation) +
                                      "), and is used as it is stored: the boxes of " + boxes_ +
                                      " must be in pixels of the stored picture; those of `yorb detect` are in pixels "
                                      "of the turned one, so take the block away before it looks");
    boxes_.clear();  // once is enough
  }

 private:
  std::string boxes_;
};

void FeedFrames(const Dataset& dataset, const Config& config, Slam& slam, const FeedHooks& hooks, FeedLog& log) {
  const bool is_live = config.mode == "live";
  Reader reader(dataset, FramesToFeed(dataset, config));
  DepthWatch depth(dataset.rig());
  TurnedPictures turned(config);
  Pace pace;
  while (auto frame = reader.Next()) {
    log.was_stopped = (hooks.should_stop && hooks.should_stop()) ||
                      (is_live && !pace.WaitFor(dataset.TimeOf(frame->index), hooks.should_stop));
    if (log.was_stopped) return;
    if (!frame->loaded) {
      log.error = frame->loaded.error();
      return;
    }
    depth.Add(*frame->loaded);
    turned.Watch(*frame->loaded, dataset.PictureName(frame->index));
    log.had_depth = depth.has_seen_any();
    const auto fate = PushFrame(*std::move(frame->loaded), slam, log);
    if (!fate) return;
    log.fates.push_back(*fate);
    log.read_ms.push_back(frame->read_ms);
    if (hooks.after_frame) hooks.after_frame(log);
  }
  depth.Conclude(!config.localize_only);
}

}  // namespace

size_t FramesToFeed(const Dataset& dataset, const Config& config) {
  const auto asked_for = static_cast<size_t>(config.max_frames);
  return asked_for == 0 ? dataset.size() : std::min(dataset.size(), asked_for);
}

FeedLog Feed(const Dataset& dataset, const Config& config, Slam& slam, const FeedHooks& hooks) {
  FeedLog log;
  try {
    FeedFrames(dataset, config, slam, hooks, log);
  } catch (const std::exception& error) {
    log.error = FailureOf(error);
  }
  slam.Finish();
  if (const Status fault = slam.Fault(); !fault) log.error = fault.error();
  if (log.error && log.error->kind == Error::Kind::kFailure) {
    log.error->message = "the run was broken off: " + log.error->message;
  }
  return log;
}

}  // namespace yorb
