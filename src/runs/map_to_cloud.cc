// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/map_to_cloud.h"

#include <filesystem>
#include <memory>
#include <utility>

#include "core/file_draft.h"
#include "core/text.h"
#include "datasets/masked_dataset.h"
#include "datasets/open_dataset.h"
#include "runs/dense_cloud.h"
#include "runs/map_export.h"
#include "runs/run_folder.h"
#include "system/config_io.h"

namespace yorb {
namespace {

/// A recording with the masks that the user names.
struct Recording {
  std::unique_ptr<Dataset> plain;
  std::unique_ptr<MaskedDataset> masked;
  const Dataset& dataset() const { return masked ? *masked : *plain; }
};

/// Opened with the camera of the map, which knows it better than a folder's name.
Result<Recording> Open(const DenseRequest& dense, const Map& map) {
  const Rig& rig = *map.Find(map.newest_keyframe())->frame->rig;
  Recording recording;
  auto plain = OpenDataset(*dense.sequence, ChosenCamera{rig, "of the map", true});
  if (!plain) return plain.error();
  recording.plain = *std::move(plain);
  if (dense.config.masks.empty()) return recording;
  auto masked = MaskedDataset::Open(*recording.plain, dense.config.masks);
  if (!masked) return masked.error();
  recording.masked = *std::move(masked);
  return recording;
}

Status CheckRequest(const DenseRequest& dense, MapExport kind, const std::string& out) {
  if (!dense.sequence && !dense.named_option.empty()) {
    return BadInput(dense.named_option + " is for dense clouds alone; name the sequence with --dense, or leave " +
                    dense.named_option + " out");
  }
  if (dense.sequence && kind == MapExport::kKeyframes) {
    return BadInput("--dense makes points; name a .ply or .pcd file with --out, not " + out);
  }
  if (dense.config.dynamics != "full" && dense.config.dynamics != "off") {
    return BadInput("--dynamics " + dense.config.dynamics + ": full or off is expected");
  }
  if (!(dense.cube_m >= 0.001 && dense.cube_m <= 10)) {
    return BadInput("--cube " + FormatShortest(dense.cube_m) + ": a side from 0.001 to 10 metres is expected");
  }
  return ValidateConfig(dense.config);
}

/// Writes the files, and tells of others that would be taken for theirs: they may be of an older export, or of another
/// map.
Status WriteFiles(const std::string& out, const std::vector<FileToWrite>& files, size_t num_submaps,
                  ExportReport& report) {
  Status written = WriteFilesTogether(files);
  if (!written) return written;
  for (const std::string& path : OlderFiles(out, files, num_submaps)) {
    report.lines.push_back(path + " was there before: it is no part of this map");
  }
  return written;
}

void ExplainWorlds(size_t num_submaps, ExportReport& report) {
  if (num_submaps < 2) return;
  report.lines.push_back(std::to_string(num_submaps) + " sub-maps, each in a world of its own");
}

/// What was found of the keyframes in the recording.
std::string PicturesText(const DenseClouds& made, const Map& map, const std::string& sequence) {
  return std::to_string(made.num_keyframes) + " of " + std::to_string(map.num_keyframes()) +
         " keyframes have their pictures in " + sequence + "; people in " + std::to_string(made.num_with_people) +
         " of them";
}

Result<ExportReport> ExportDense(const SavedMap& saved, const std::string& out, MapExport kind,
                                 const DenseRequest& dense, const std::function<bool()>& should_stop) {
  const Map& map = saved.map;
  const auto recording = Open(dense, map);
  if (!recording) return recording.error();
  const auto parts = MakeParts(dense.config, recording->dataset());
  if (!parts) return parts.error();
  const DenseOptions options{dense.cube_m, should_stop};
  const std::vector<KeyframeId> roots = RootsInOrder(saved);
  auto made = MakeDenseClouds(map, roots, recording->dataset(), *parts, options);
  if (!made) return made.error();
  ExportReport report;
  report.was_stopped = made->was_stopped;
  if (made->was_stopped) return report;
  report.lines.push_back(PicturesText(*made, map, *dense.sequence));
  if (made->num_of_others > 0) {
    report.lines.push_back(std::to_string(made->num_of_others) +
                           " keyframes were taken from other pictures and are left out");
  }
  std::vector<FileToWrite> files;
  for (size_t i = 0; i < made->clouds.size(); ++i) {
    if (made->clouds[i].points.empty() && i > 0) continue;
    files.push_back({NumberedPath(out, i + 1), CloudBytes(made->clouds[i], kind)});
    report.lines.push_back(files.back().path + ": " + std::to_string(made->clouds[i].points.size()) + " points, of " +
                           SubmapText(map, roots[i]));
  }
  ExplainWorlds(roots.size(), report);
  const Status written = WriteFiles(out, files, roots.size(), report);
  if (!written) return written.error();
  return report;
}

Result<ExportReport> ExportLandmarksOrKeyframes(const SavedMap& saved, const std::string& out, MapExport kind) {
  const std::vector<KeyframeId> roots = RootsInOrder(saved);
  ExportReport report;
  for (size_t i = 0; i < roots.size(); ++i) {
    report.lines.push_back(NumberedPath(out, i + 1) + ": " + SubmapText(saved.map, roots[i]));
  }
  ExplainWorlds(roots.size(), report);
  const Status written = WriteFiles(out, ExportedFiles(saved, out, kind), roots.size(), report);
  if (!written) return written.error();
  return report;
}

/// Bad input where a file of the export would take the place of the map that it is made of.
Status CheckMapKept(const std::string& file, const SavedMap& saved, const std::string& out) {
  const size_t num_submaps = RootsInOrder(saved).size();
  for (size_t number = 1; number <= num_submaps; ++number) {
    std::error_code ignored;
    if (std::filesystem::equivalent(file, NumberedPath(out, number), ignored))
      return BadInput("--out " + out + " would overwrite the map " + file + "; name another file");
  }
  return Status::Ok();
}

}  // namespace

Result<ExportReport> ExportMap(const std::string& file, const std::string& out, const DenseRequest& dense,
                               const std::function<bool()>& should_stop) {
  const auto kind = MapExportOf(out);
  if (!kind) return kind.error();
  const Status fine = CheckRequest(dense, *kind, out);
  if (!fine) return fine.error();
  const auto saved = ReadMapFile(file);
  if (!saved) return saved.error();
  if (saved->map.num_keyframes() == 0) return BadInput(file + " holds no keyframe; there is nothing to export");
  if (const Status kept = CheckMapKept(file, *saved, out); !kept) return kept.error();
  const auto draft = FileDraft::Open(out);  // let go at once: whether a file can be made there
  if (!draft) return BadInput("nothing can be written there: " + draft.error().message);
  if (dense.sequence) return ExportDense(*saved, out, *kind, dense, should_stop);
  return ExportLandmarksOrKeyframes(*saved, out, *kind);
}

}  // namespace yorb
