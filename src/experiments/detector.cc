// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/detector.h"

#include <ctime>
#include <filesystem>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <set>
#include <utility>

#include "core/stats.h"
#include "core/stopwatch.h"
#include "detection/yolo_detector.h"
#include "pictures/png.h"
#include "pictures/still_picture.h"
#include "runs/draw_boxes.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

DetectionOptions OptionsFor(const std::string& path, const DetectorBenchOptions& options) {
  DetectionOptions detection;
  detection.model = path;
  detection.confidence = options.confidence;
  detection.width = options.size.width, detection.height = options.size.height;
  return detection;
}

/// Time that this thread has spent computing.
double CpuMs() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

/// A network in the race, with its times.
struct Runner {
  std::unique_ptr<YoloDetector> detector;
  std::vector<double> wall_ms, cpu_ms;
};

Status RunOnce(const ImageSet& images, Runner& runner) {
  const double before = CpuMs();
  const Stopwatch watch;
  const auto detections = runner.detector->Detect(images);
  runner.wall_ms.push_back(watch.ms());
  runner.cpu_ms.push_back(CpuMs() - before);
  return detections ? Status::Ok() : Status(detections.error());
}

/// A picture of a camera's size with something in it.
ImageSet TimedPicture() {
  cv::Mat small(60, 80, CV_8UC3), picture;
  cv::RNG(1).fill(small, cv::RNG::UNIFORM, 0, 256);
  cv::resize(small, picture, {640, 480}, 0, 0, cv::INTER_CUBIC);
  return ImageSetOf(picture);
}

struct Race {
  std::vector<Runner> fast;
  std::vector<std::optional<Runner>> by_opencv;
};

/// All in turns, so that each meets the machine in the same states.
Status Run(const DetectorBenchOptions& options, Race& race) {
  const ImageSet images = TimedPicture();
  for (size_t round = 0; round < options.rounds; ++round) {
    if (options.should_stop && options.should_stop()) break;
    for (Runner& runner : race.fast) {
      if (Status status = RunOnce(images, runner); !status) return status;
    }
    for (auto& runner : race.by_opencv) {
      if (!runner) continue;
      if (Status status = RunOnce(images, *runner); !status) return status;
    }
  }
  return Status::Ok();
}

Result<Race> Enter(const DetectorBenchOptions& options) {
  Race race;
  for (const std::string& path : options.models) {
    DetectionOptions detection = OptionsFor(path, options);
    auto detector = YoloDetector::Open(detection);
    if (!detector) return detector.error();
    race.fast.push_back({*std::move(detector), {}, {}});
    detection.engine = "opencv";
    auto slow = YoloDetector::Open(detection);
    race.by_opencv.emplace_back();
    if (slow) race.by_opencv.back() = Runner{*std::move(slow), {}, {}};
  }
  return race;
}

Result<DetectorBenchRow> RowOf(const std::string& path, const Race& race, size_t index) {
  const Runner& runner = race.fast[index];
  const auto network = OpenNetwork(path, runner.detector->input_size());
  if (!network) return network.error();
  DetectorBenchRow row;
  row.path = path;
  row.name = fs::path(path).stem().string();
  row.size = runner.detector->input_size();
  row.engine = runner.detector->engine_name();
  row.table = TableOf(*network);
  std::error_code ignored;
  row.file_mb = static_cast<double>(fs::file_size(path, ignored)) * 1e-6;
  row.latency_ms = Summarize(runner.wall_ms).median;
  row.cpu_ms = Summarize(runner.cpu_ms).median;
  if (race.by_opencv[index]) row.opencv_cpu_ms = Summarize(race.by_opencv[index]->cpu_ms).median;
  for (const auto& [key, value] : network->model.metadata) {
    if (key.rfind("training", 0) == 0) row.training.push_back(key + ": " + value);
  }
  return row;
}

Result<DetectorJudgement> Judge(const LabelledSet& set, const std::string& path, const DetectorBenchOptions& options) {
  DetectionOptions detection = OptionsFor(path, options);
  detection.confidence = 0.001;  // the whole curve
  detection.most_overlap = 0.6;
  auto detector = YoloDetector::Open(detection);
  if (!detector) return detector.error();
  (*detector)->TakeAllClasses();
  return JudgeDetector(set, **detector, {options.confidence, {}, options.should_stop});
}

Result<std::vector<PeopleScore>> FindPeople(const std::string& path, const DetectorBenchOptions& options) {
  auto detector = YoloDetector::Open(OptionsFor(path, options));
  if (!detector) return detector.error();
  std::vector<PeopleScore> scores;
  for (const std::string& sequence : options.sequences) {
    auto score = MeasurePeople(sequence, **detector, options.should_stop);
    if (!score) return score.error();
    scores.push_back(*std::move(score));
  }
  return scores;
}

}  // namespace

Result<DetectorReport> MeasureDetectors(const DetectorBenchOptions& options) {
  if (options.models.empty()) return BadInput("no network is named");
  auto race = Enter(options);
  if (!race) return race.error();
  if (Status status = Run(options, *race); !status) return status.error();
  std::optional<LabelledSet> set;
  if (options.labelled) {
    auto read = ReadLabelledSet(*options.labelled, options.set);
    if (!read) return read.error();
    set = *std::move(read);
  }
  DetectorReport report;
  for (size_t i = 0; i < options.models.size(); ++i) {
    auto row = RowOf(options.models[i], *race, i);
    if (!row) return row.error();
    if (set) {
      auto judgement = Judge(*set, options.models[i], options);
      if (!judgement) return judgement.error();
      row->judgement = *std::move(judgement);
    }
    auto people = FindPeople(options.models[i], options);
    if (!people) return people.error();
    row->people = *std::move(people);
    report.networks.push_back(*std::move(row));
  }
  return report;
}

Unreadable DetectorReport::unreadable() const {
  Unreadable all;
  if (networks.empty()) return all;
  const DetectorBenchRow& any = networks.front();  // all of them see the same pictures
  if (any.judgement) all.Add(any.judgement->unreadable);
  for (const PeopleScore& score : any.people) all.Add(score.unreadable);
  return all;
}

Result<DetectorFigureFiles> DetectorFigures(const std::vector<std::string>& pictures,
                                            const DetectorBenchOptions& options, const std::string& folder) {
  if (pictures.empty()) return DetectorFigureFiles();
  std::vector<std::unique_ptr<YoloDetector>> detectors;
  for (const std::string& path : options.models) {
    auto detector = YoloDetector::Open(OptionsFor(path, options));
    if (!detector) return detector.error();
    detectors.push_back(*std::move(detector));
  }
  DetectorFigureFiles made;
  std::set<std::string> figures;
  for (const std::string& path : pictures) {
    const auto pixels = ReadUprightPicture(path);
    if (!pixels) {
      made.unreadable.Add(pixels.error());
      continue;
    }
    std::vector<cv::Mat> seen;
    for (size_t i = 0; i < detectors.size(); ++i) {
      const auto detections = detectors[i]->Detect(ImageSetOf(*pixels));
      if (!detections) return detections.error();
      seen.push_back(DrawBoxes(*pixels, detections->boxes));
      cv::putText(seen.back(), fs::path(options.models[i]).stem().string(), {6, seen.back().rows - 8},
                  cv::FONT_HERSHEY_SIMPLEX, 0.6, cv::Scalar(255, 255, 255), 2, cv::LINE_AA);
    }
    cv::Mat together;
    cv::hconcat(seen, together);
    auto bytes = EncodePng(together);
    if (!bytes) return bytes.error();
    const fs::path figure = fs::path(folder) / ("figure9_" + fs::path(path).stem().string() + ".png");
    made.files.push_back({UntakenPath(figure.string(), figures), *std::move(bytes)});
  }
  return made;
}

}  // namespace yorb
