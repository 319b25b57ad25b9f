// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// The two ways in which a comparison of detectors is told.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/text.h"
#include "detection/head_layout.h"
#include "experiments/detector.h"

namespace yorb {
namespace {

using Json = nlohmann::ordered_json;
using Cells = std::vector<std::string>;

/// Columns as wide as their widest cell.
std::string Table(const std::vector<Cells>& rows) {
  std::vector<size_t> widths;
  for (const Cells& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  std::string text;
  for (const Cells& row : rows) {
    std::string line;
    for (size_t c = 0; c < row.size(); ++c) line += "  " + row[c] + std::string(widths[c] - row[c].size(), ' ');
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string Number(const std::optional<double>& value, int decimals) {
  return value ? FormatFixed(*value, decimals) : "-";
}

/// Mean over the classes that occur, of those that say something.
std::optional<double> MeanOf(const std::optional<DetectorJudgement>& judgement, bool of_precision) {
  if (!judgement || judgement->scores.classes.empty()) return std::nullopt;
  double sum = 0;
  size_t count = 0;
  for (const ClassScore& score : judgement->scores.classes) {
    if (of_precision && !score.precision) continue;
    sum += of_precision ? *score.precision : score.recall;
    ++count;
  }
  return count > 0 ? std::optional(sum / static_cast<double>(count)) : std::nullopt;
}

std::string SizeOf(const DetectorBenchRow& row) {
  return std::to_string(row.size.width) + "x" + std::to_string(row.size.height);
}

std::string LayersText(const DetectorBenchRow& network) {
  std::vector<Cells> rows{{"row", "from", "parameters", "GFLOPs", "gives", "module"}};
  for (const NetworkRow& row : network.table.rows) {
    const std::string shape = row.shape.empty() ? "-" : ShapeText(row.shape);
    rows.push_back({row.name, row.from, std::to_string(row.parameters), FormatFixed(row.gflops, 3), shape, row.module});
  }
  return "Layers of " + network.name + " (" + network.path + ") at " + SizeOf(network) + ":\n" + Table(rows);
}

std::optional<double> RatioOf(const DetectorBenchRow& row) {
  return row.opencv_cpu_ms && *row.opencv_cpu_ms > 0 ? std::optional(row.cpu_ms / *row.opencv_cpu_ms) : std::nullopt;
}

std::optional<double> MeanPrecision(const DetectorBenchRow& row, bool at_50) {
  if (!row.judgement) return std::nullopt;
  return at_50 ? row.judgement->scores.map50 : row.judgement->scores.map50_95;
}

/// How the people of each sequence are found, a line a network and sequence.
std::string PeopleText(const DetectorReport& report) {
  std::vector<Cells> rows{{"sequence", "network", "people", "found", "recall", "false boxes", "pictures"}};
  for (const DetectorBenchRow& network : report.networks) {
    for (const PeopleScore& score : network.people) {
      rows.push_back({score.sequence, network.name, std::to_string(score.num_true), std::to_string(score.num_found),
                      FormatFixed(score.recall(), 3), std::to_string(score.num_false),
                      std::to_string(score.num_pictures)});
    }
  }
  if (rows.size() == 1) return "";
  return "People of people.txt (2 % of the picture or more, 35 % body or more) at an overlap of .5:\n" + Table(rows);
}

Json PeopleJson(const DetectorBenchRow& network) {
  Json people = Json::array();
  for (const PeopleScore& score : network.people) {
    people.push_back({{"sequence", score.sequence},
                      {"people", score.num_true},
                      {"found", score.num_found},
                      {"recall", score.recall()},
                      {"false_boxes", score.num_false},
                      {"pictures", score.num_pictures}});
  }
  return people;
}

Json OrNull(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

}  // namespace

std::string DetectorText(const DetectorReport& report) {
  std::string text;
  for (const DetectorBenchRow& row : report.networks) {
    text += LayersText(row) + "\n";
    for (const std::string& line : row.training) text += "  " + line + "\n";
  }
  std::vector<Cells> rows{{"network", "size", "layers", "parameters", "GFLOPs", "file MB", "ms", "CPU ms", "fps",
                           "x OpenCV", "recall", "precision", "mAP50", "mAP50-95", "engine"}};
  for (const DetectorBenchRow& row : report.networks) {
    rows.push_back({row.name, SizeOf(row), std::to_string(row.table.num_convolutions),
                    std::to_string(row.table.parameters), Number(row.table.gflops, 2), FormatFixed(row.file_mb, 1),
                    FormatFixed(row.latency_ms, 1), FormatFixed(row.cpu_ms, 1),
                    FormatFixed(row.latency_ms > 0 ? 1000 / row.latency_ms : 0, 0), Number(RatioOf(row), 2),
                    Number(MeanOf(row.judgement, false), 3), Number(MeanOf(row.judgement, true), 3),
                    Number(MeanPrecision(row, true), 3), Number(MeanPrecision(row, false), 3), row.engine});
  }
  text +=
      "Networks side by side, one thread, picture of 640x480 to boxes; layers are convolutions; x OpenCV: CPU time "
      "against OpenCV DNN's in turns:\n";
  return text + Table(rows) + PeopleText(report);
}

std::string DetectorJson(const DetectorReport& report) {
  Json networks = Json::array();
  for (const DetectorBenchRow& row : report.networks) {
    Json layers = Json::array();
    for (const NetworkRow& layer : row.table.rows) {
      layers.push_back({{"row", layer.name},
                        {"from", layer.from},
                        {"parameters", layer.parameters},
                        {"gflops", layer.gflops},
                        {"module", layer.module},
                        {"shape", layer.shape}});
    }
    networks.push_back({{"name", row.name},
                        {"path", row.path},
                        {"width", row.size.width},
                        {"height", row.size.height},
                        {"engine", row.engine},
                        {"layers", layers},
                        {"convolutions", row.table.num_convolutions},
                        {"parameters", row.table.parameters},
                        {"gflops", OrNull(row.table.gflops)},
                        {"file_mb", row.file_mb},
                        {"latency_ms", row.latency_ms},
                        {"cpu_ms", row.cpu_ms},
                        {"fps", row.latency_ms > 0 ? 1000 / row.latency_ms : 0},
                        {"opencv_cpu_ms", OrNull(row.opencv_cpu_ms)},
                        {"ratio_to_opencv", OrNull(RatioOf(row))},
                        {"recall", OrNull(MeanOf(row.judgement, false))},
                        {"precision", OrNull(MeanOf(row.judgement, true))},
                        {"map50", OrNull(MeanPrecision(row, true))},
                        {"map50_95", OrNull(MeanPrecision(row, false))},
                        {"people", PeopleJson(row)},
                        {"training", row.training}});
  }
  return Json{{"networks", networks}}.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace yorb
