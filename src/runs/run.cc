// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/run.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include "camera/camera_io.h"
#include "core/files.h"
#include "core/log.h"
#include "core/stopwatch.h"
#include "core/text.h"
#include "datasets/masked_dataset.h"
#include "evaluation/report.h"
#include "geometry/trajectory.h"
#include "runs/feed.h"
#include "runs/make_detector.h"
#include "runs/overlay.h"
#include "runs/resources.h"
#include "runs/results.h"
#include "runs/run_folder.h"
#include "runs/run_map.h"
#include "runs/run_report.h"
#include "system/config_io.h"
#include "system/slam.h"

namespace yorb {
namespace {

/// What a run consists of while it goes on.
struct Run {
  const Dataset& dataset;
  const RunOptions& options;
  std::string out;
  std::string camera_text;
  Stopwatch watch;
  double last_saved_s = 0;
  size_t num_boxes_unmatched = 0;
  VocabularyPtr vocabulary;  ///< of this run; may be null
};

RunMetrics MetricsOf(const Run& run, const FeedLog& fed, const SlamReport& report, size_t num_frames) {
  RunMetrics metrics;
  metrics.frames = num_frames;
  metrics.tracked = report.trajectory().size();
  metrics.keyframes = report.num_keyframes;
  metrics.submaps = report.submaps.size();
  metrics.landmarks = report.num_landmarks;
  metrics.loops = report.num_loops;
  metrics.skipped = fed.num_skipped;
  metrics.dynamics = DynamicsOf(run.options.config.dynamics, report.frames);
  metrics.dynamics.boxes_unmatched = run.num_boxes_unmatched;
  metrics.dynamics.landmarks_removed = report.num_landmarks_gone;
  metrics.wall_s = run.watch.seconds();
  metrics.cpu_s = CpuSeconds();
  metrics.peak_rss_mb = PeakRssMb();
  metrics.stage_ms = report.stage_ms;
  metrics.stage_ms["read"] = fed.read_ms;
  metrics.seed = run.options.config.seed;
  metrics.mode = run.options.config.mode;
  metrics.config_digest = ConfigDigest(WithWholePaths(run.options.config), run.camera_text);
  return metrics;
}

/// Writes all files of the run folder: first the results, then what tells of them, so that a disk that is nearly full
/// takes the trajectory. Nothing is replaced before all that belongs together could be written.
Status Save(const Run& run, const FeedLog& fed, const SlamReport& report) {
  const std::vector<FrameRow> rows = FrameRows(run.dataset, fed.fates, report.frames);
  const RunMetrics metrics = MetricsOf(run, fed, report, rows.size());
  const auto in_folder = [&](const std::string& name) { return InRunFolder(run.out, name); };
  std::vector<FileToWrite> results = {
      {in_folder("config.yaml"), ConfigText(WithWholePaths(run.options.config), run.camera_text)},
      {in_folder("metrics.json"), MetricsJson(metrics)},
  };
  // A sub-map that was never joined to the first has files of its own: trajectory_2.txt and so on.
  const std::string trajectory = in_folder("trajectory.txt"), keyframes = in_folder("keyframes.txt");
  for (size_t i = 0; i < report.submaps.size(); ++i) {
    results.push_back({NumberedPath(trajectory, i + 1), TumText(report.submaps[i].trajectory)});
    results.push_back({NumberedPath(keyframes, i + 1), TumText(report.submaps[i].keyframes)});
  }
  const Status status = WriteFilesTogether(results);
  if (!status) return status;
  // Those of an older run, or of this one before two sub-maps were joined.
  for (const std::string& path : {trajectory, keyframes}) {
    std::error_code ignored;
    for (const std::string& older : OlderFiles(path, results, report.submaps.size()))
      std::filesystem::remove(older, ignored);
  }
  return WriteFilesTogether({
      {in_folder("frames.csv"), FramesCsv(rows)},
      {in_folder("log.txt"), LogText()},
      {in_folder("report.html"), ReportHtml(ReportOf(run.options, metrics, rows, report))},
  });
}

/// Saves while the run goes on. A failure is not the end: the disk may have room again by then.
void SaveNowAndThen(Run& run, const FeedLog& fed, const Slam& slam) {
  if (run.watch.seconds() < run.last_saved_s + run.options.save_every_s) return;
  const Status status = Save(run, fed, slam.Report());
  if (!status) LogWarning("save-failed", status.error().message + "; the run goes on, and writes again at its end");
  run.last_saved_s = run.watch.seconds();
}

RunSummary Summarise(const Run& run, const FeedLog& fed, const SlamReport& report) {
  RunSummary summary;
  summary.out = run.out;
  summary.frames = fed.fates.size();
  summary.tracked = report.trajectory().size();
  summary.keyframes = report.num_keyframes;
  summary.landmarks = report.num_landmarks;
  summary.skipped = fed.num_skipped;
  for (const Fate fate : fed.fates) summary.dropped += fate == Fate::kDropped;
  summary.wall_s = run.watch.seconds();
  summary.was_stopped = fed.was_stopped;
  summary.error = fed.error;
  return summary;
}

void LogSummary(const RunSummary& summary) {
  const auto share =
      summary.frames == 0 ? 0.0 : 100.0 * static_cast<double>(summary.tracked) / static_cast<double>(summary.frames);
  LogInfo(std::string(summary.was_stopped ? "stopped"
                      : summary.error     ? "broken off"
                                          : "done") +
          ": " + std::to_string(summary.tracked) + " of " + std::to_string(summary.frames) + " frames tracked (" +
          FormatFixed(share, 1) + " %), " + std::to_string(summary.keyframes) + " keyframes, " +
          std::to_string(summary.landmarks) + " landmarks, " + FormatFixed(summary.wall_s, 1) + " s");
  if (summary.dropped > 0) LogInfo(std::to_string(summary.dropped) + " frames were dropped because they came too fast");
  if (summary.error) LogInfo("the reason: " + summary.error->message);
}

/// Why there is no pose at all, where it is not for want of depth, of which the feeder has told.
void WarnOfMissingMap(const Run& run, const FeedLog& fed, const SlamReport& report) {
  if (report.frames.empty()) return;
  if (report.num_keyframes > 0 && report.trajectory().empty()) {
    LogWarning("not-in-map", "none of the " + std::to_string(report.frames.size()) + " frames was found in the map " +
                                 run.options.config.load_map);
  }
  if (!fed.had_depth || report.num_keyframes > 0) return;
  const bool has_boxes = std::any_of(report.frames.begin(), report.frames.end(),
                                     [](const FrameRecord& frame) { return frame.num_boxes > 0; });
  LogWarning("no-map", "no map began: none of the " + std::to_string(report.frames.size()) + " frames shows " +
                           std::to_string(run.options.config.tracking.min_first_points) +
                           " corners with depth; is the picture black, blank or very small" +
                           (run.options.config.masks.empty() ? "" : ", or all of it masked") +
                           (has_boxes ? ", or all of it within boxes of what moves?" : "?"));
}

/// The map into its file, whatever the end of the run is.
void SaveMap(const Run& run, const Slam& slam, const SlamReport& report, RunSummary& summary) {
  if (run.options.save_map.empty()) return;
  std::vector<KeyframeId> roots;
  for (const SubmapReport& submap : report.submaps) roots.push_back(submap.root);
  const auto is_written = SaveRunMap(run.options.save_map, *slam.Snapshot(), run.vocabulary.get(), roots);
  if (!is_written) {
    summary.error = is_written.error();
  } else if (*is_written) {
    summary.map = run.options.save_map;
  }
}

/// A run that ended before its first frame leaves an older one's results alone.
bool ShouldSave(const Run& run, const FeedLog& fed) {
  if (!fed.fates.empty()) return true;
  std::error_code ignored;
  return !fed.error && !std::filesystem::exists(InRunFolder(run.out, "trajectory.txt"), ignored);
}

/// Everything from the first frame to the last file.
RunSummary Carry(Run& run, Slam& slam, const RunHooks& hooks) {
  const size_t num_frames = FramesToFeed(run.dataset, run.options.config);
  FeedHooks feed_hooks;
  feed_hooks.should_stop = hooks.should_stop;
  feed_hooks.after_frame = [&](const FeedLog& fed) {
    if (hooks.on_progress) hooks.on_progress({std::min(fed.fates.size(), num_frames), num_frames});
    SaveNowAndThen(run, fed, slam);
  };
  const FeedLog fed = Feed(run.dataset, run.options.config, slam, feed_hooks);
  const SlamReport report = slam.Report();
  RunSummary summary = Summarise(run, fed, report);
  WarnOfMissingMap(run, fed, report);
  SumUpWarnings();
  LogSummary(summary);
  if (!ShouldSave(run, fed)) return summary;
  const Status status = Save(run, fed, report);
  if (!status) summary.error = status.error();
  SaveMap(run, slam, report, summary);
  return summary;
}

/// Where a path leads, whether something is there or not: absolute, behind links, without a slash at its end.
std::filesystem::path PlaceOf(const std::string& path) {
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(path, error);
  std::filesystem::path place = std::filesystem::weakly_canonical(absolute, error);
  if (error) place = absolute.lexically_normal();
  return place.has_filename() ? place : place.parent_path();
}

/// The first step from a folder to a place in it; "." for the folder itself, ".." for a place outside.
std::string FirstStep(const std::filesystem::path& folder, const std::filesystem::path& place) {
  const std::filesystem::path steps = place.lexically_relative(folder);
  return steps.empty() ? ".." : steps.begin()->string();
}

/// Bad input where the map and the run's other results would take each other's place.
Status CheckMapPlace(const RunOptions& options) {
  if (options.save_map.empty()) return Status::Ok();
  const std::filesystem::path map = PlaceOf(options.save_map);
  std::error_code ignored;
  if (std::filesystem::is_directory(map, ignored)) return Status::Ok();  // which CheckMapOptions refuses by name
  for (const std::string& folder : {options.out, options.overlay}) {
    if (folder.empty() || FirstStep(map, PlaceOf(folder)) == "..") continue;
    return BadInput("--save-map " + options.save_map + " is where the folder " + folder +
                    " comes to be; name another file, such as " + map.filename().string() + ".map");
  }
  if (options.out.empty() || !IsResultName(FirstStep(PlaceOf(options.out), map))) return Status::Ok();
  return BadInput("--save-map " + options.save_map +
                  " is the place of one of the run's own results; name another file, such as " +
                  InRunFolder(options.out, "my.map"));
}

Result<RunSummary> RunUnmasked(const Dataset& dataset, const RunOptions& options, const RunHooks& hooks) {
  auto parts = MakeParts(options.config, dataset);
  if (!parts) return parts.error();
  Run run{dataset, options, options.out, CameraFileText(dataset.rig()), {}};
  run.num_boxes_unmatched = parts->num_boxes_unmatched;
  run.vocabulary = parts->slam.vocabulary;
  ReturnFreedMemory();  // of the files that all of it was made from
  if (options.out.empty()) {
    auto made = MakeDefaultRunFolder();
    if (!made) return made.error();
    run.out = *std::move(made);
  }
  const Status usable = PrepareRunFolder(run.out);
  if (!usable) return usable.error();
  std::shared_ptr<OverlayWriter> overlay;
  if (!options.overlay.empty()) {
    auto opened = OverlayWriter::Open(options.overlay);
    if (!opened) return opened.error();
    overlay = *std::move(opened);
    parts->slam.watch = [overlay](const Watched& watched) { overlay->Write(watched); };
  }
  auto slam = Slam::Create(options.config, dataset.rig(), std::move(parts->slam));
  if (!slam) return slam.error();
  if (overlay) {
    if (const Status begun = overlay->Begin(); !begun) return begun.error();
  }
  LogInfo("run of " + options.title + ": " + std::to_string(FramesToFeed(dataset, options.config)) + " frames, mode " +
          options.config.mode + ", seed " + std::to_string(options.config.seed) + ", camera " + dataset.rig().name +
          ", results in " + run.out);
  RunSummary summary = Carry(run, **slam, hooks);
  if (overlay && !overlay->status() && !summary.error) summary.error = overlay->status().error();
  return summary;
}

}  // namespace

Result<RunSummary> RunSequence(const Dataset& dataset, const RunOptions& options, const RunHooks& hooks) {
  Status valid = ValidateConfig(options.config);
  if (valid) valid = CheckMapPlace(options);
  if (valid) valid = CheckMapOptions(options.config, options.save_map);
  if (!valid) return valid.error();
  if (options.config.masks.empty()) return RunUnmasked(dataset, options, hooks);
  const auto masked = MaskedDataset::Open(dataset, options.config.masks);
  if (!masked) return masked.error();
  return RunUnmasked(**masked, options, hooks);
}

}  // namespace yorb
