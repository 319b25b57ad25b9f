// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/evaluation_text.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/text.h"
#include "evaluation/trajectory_charts.h"

namespace yorb {
namespace {

using Json = nlohmann::ordered_json;

Json Number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json SummaryJson(const Summary& s) {
  Json json;
  const std::pair<const char*, double> entries[] = {{"rmse", s.rmse}, {"mean", s.mean}, {"median", s.median},
                                                    {"std", s.std},   {"min", s.min},   {"max", s.max}};
  for (const auto& [name, value] : entries) json[name] = s.count > 0 ? Number(value) : Json(nullptr);
  return json;
}

const char* UnitWord(RpeUnit unit) {
  switch (unit) {
    case RpeUnit::kSeconds:
      return "s";
    case RpeUnit::kMetres:
      return "m";
    case RpeUnit::kFrames:
      return "frames";
  }
  return "s";
}

const char* AlignWord(EvalAlign align) {
  switch (align) {
    case EvalAlign::kSe3:
      return "se3";
    case EvalAlign::kSim3:
      return "sim3";
    case EvalAlign::kNone:
      return "none";
  }
  return "se3";
}

Json OneJson(const Evaluation& evaluation, const EvalOptions& options) {
  const Alignment& alignment = evaluation.ate.reference_from_estimate;
  const Eigen::Matrix3d rotation = alignment.rotation.toRotationMatrix();
  Json json;
  json["ate"] = SummaryJson(evaluation.ate.summary);
  json["rpe"] = {{"translation", SummaryJson(evaluation.rpe.translation_summary)},
                 {"rotation_deg", SummaryJson(evaluation.rpe.rotation_summary)},
                 {"pairs", evaluation.rpe.translation.size()},
                 {"delta", Number(options.rpe_delta)},
                 {"unit", UnitWord(options.rpe_unit)}};
  json["pairs"] = evaluation.pairs.size();
  json["coverage"] = evaluation.coverage ? Number(*evaluation.coverage) : Json(nullptr);
  json["scale"] = Number(alignment.scale);
  json["align"] = AlignWord(options.align);
  json["rotation"] = Json::array();
  json["translation"] = Json::array();
  for (int row = 0; row < 3; ++row) {
    json["rotation"].push_back({Number(rotation(row, 0)), Number(rotation(row, 1)), Number(rotation(row, 2))});
    json["translation"].push_back(Number(alignment.translation(row)));
  }
  return json;
}

/// What the table lists of each estimate; NaN where nothing can be said.
struct Column {
  const char* title;
  int decimals;
  double (*value)(const Evaluation&);
};
double NanIfNone(const Summary& summary, double value) { return summary.count > 0 ? value : std::nan(""); }
const Column kColumns[] = {
    {"ATE RMSE [m]", 6, [](const Evaluation& e) { return e.ate.summary.rmse; }},
    {"RPE RMSE [m]", 6,
     [](const Evaluation& e) { return NanIfNone(e.rpe.translation_summary, e.rpe.translation_summary.rmse); }},
    {"RPE RMSE [deg]", 6,
     [](const Evaluation& e) { return NanIfNone(e.rpe.rotation_summary, e.rpe.rotation_summary.rmse); }},
    {"pairs", 0, [](const Evaluation& e) { return static_cast<double>(e.pairs.size()); }},
    {"coverage", 4, [](const Evaluation& e) { return e.coverage.value_or(std::nan("")); }}};
constexpr const char* kJsonColumns[] = {"ate_rmse", "rpe_translation_rmse", "rpe_rotation_deg_rmse", "pairs",
                                        "coverage"};

Summary ColumnSummary(const std::vector<Evaluation>& evaluations, const Column& column) {
  std::vector<double> values;
  for (const Evaluation& evaluation : evaluations) {
    if (std::isfinite(column.value(evaluation))) values.push_back(column.value(evaluation));
  }
  return Summarize(std::move(values));
}

std::string PadLeft(const std::string& text, size_t width) {
  return std::string(width - std::min(width, text.size()), ' ') + text;
}
std::string PadRight(const std::string& text, size_t width) {
  return text + std::string(width - std::min(width, text.size()), ' ');
}

std::string Cell(double value, int decimals) { return std::isfinite(value) ? FormatFixed(value, decimals) : "-"; }

std::string TableText(const std::vector<Evaluation>& evaluations) {
  size_t name_width = 8;
  for (const Evaluation& evaluation : evaluations) name_width = std::max(name_width, evaluation.estimate_path.size());
  std::string text = PadRight("estimate", name_width);
  const auto width = [](const Column& column) { return std::max<size_t>(12, std::string(column.title).size()) + 2; };
  for (const Column& column : kColumns) text += PadLeft(column.title, width(column));
  text += '\n';
  for (const Evaluation& evaluation : evaluations) {
    text += PadRight(evaluation.estimate_path, name_width);
    for (const Column& column : kColumns)
      text += PadLeft(Cell(column.value(evaluation), column.decimals), width(column));
    text += '\n';
  }
  for (const bool is_mean : {true, false}) {
    text += PadRight(is_mean ? "mean" : "s.d.", name_width);
    for (const Column& column : kColumns) {
      const Summary summary = ColumnSummary(evaluations, column);
      const double value = summary.count == 0 ? std::nan("") : is_mean ? summary.mean : summary.std;
      text += PadLeft(Cell(value, std::max(1, column.decimals)), width(column));
    }
    text += '\n';
  }
  return text;
}

std::string SummaryRow(const std::string& title, const Summary& s) {
  std::string row = PadRight(title, 22);
  for (const double value : {s.rmse, s.mean, s.median, s.std, s.min, s.max})
    row += PadLeft(s.count > 0 ? FormatFixed(value, 6) : "-", 12);
  return row + '\n';
}

std::string OneText(const Evaluation& evaluation, const EvalOptions& options) {
  std::string text = evaluation.estimate_path + "\n" + PadRight("", 22);
  for (const char* word : {"rmse", "mean", "median", "std", "min", "max"}) text += PadLeft(word, 12);
  const std::string delta = " (" + FormatShortest(options.rpe_delta) + " " + UnitWord(options.rpe_unit) + ")";
  text += '\n' + SummaryRow("ATE [m]", evaluation.ate.summary) +
          SummaryRow("RPE" + delta + " [m]", evaluation.rpe.translation_summary) +
          SummaryRow("RPE" + delta + " [deg]", evaluation.rpe.rotation_summary);
  text += "pairs " + std::to_string(evaluation.pairs.size()) + ", RPE pairs " +
          std::to_string(evaluation.rpe.translation.size()) + ", align " + AlignWord(options.align);
  if (options.align == EvalAlign::kSim3)
    text += ", scale " + FormatFixed(evaluation.ate.reference_from_estimate.scale, 6);
  if (evaluation.coverage) text += ", coverage " + FormatFixed(*evaluation.coverage, 4);
  return text + '\n';
}

/// A CSV field; quoted where it has to be.
std::string CsvField(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

/// The legend's names: file names, with their folders where these alone tell them apart.
std::string ShortName(const std::vector<Evaluation>& evaluations, size_t index) {
  const std::filesystem::path path = evaluations[index].estimate_path;
  const auto is_same = [&](const Evaluation& other) {
    return std::filesystem::path(other.estimate_path).filename() == path.filename();
  };
  const bool is_alone = std::count_if(evaluations.begin(), evaluations.end(), is_same) == 1;
  return is_alone ? path.filename().string() : path.string();
}

}  // namespace

std::string EvaluationJson(const std::vector<Evaluation>& evaluations, const EvalOptions& options) {
  constexpr auto kReplace = Json::error_handler_t::replace;  // of file names that are no UTF-8
  if (evaluations.size() == 1) return OneJson(evaluations[0], options).dump(2, ' ', false, kReplace) + '\n';
  Json json;
  json["estimates"] = Json::array();
  for (const Evaluation& evaluation : evaluations) {
    Json one = {{"file", evaluation.estimate_path}};
    one.update(OneJson(evaluation, options));
    json["estimates"].push_back(std::move(one));
  }
  for (size_t i = 0; i < std::size(kColumns); ++i) {
    const Summary summary = ColumnSummary(evaluations, kColumns[i]);
    json["mean"][kJsonColumns[i]] = summary.count > 0 ? Number(summary.mean) : Json(nullptr);
    json["std"][kJsonColumns[i]] = summary.count > 0 ? Number(summary.std) : Json(nullptr);
  }
  return json.dump(2, ' ', false, kReplace) + '\n';
}

std::string EvaluationText(const std::vector<Evaluation>& evaluations, const EvalOptions& options) {
  return evaluations.size() == 1 ? OneText(evaluations[0], options) : TableText(evaluations);
}

std::string EvaluationCsv(const std::vector<Evaluation>& evaluations, const Trajectory& reference) {
  std::string csv = "timestamp,reference_timestamp,error_m,x,y,z,reference_x,reference_y,reference_z,estimate\n";
  for (const Evaluation& evaluation : evaluations) {
    const std::string name = CsvField(evaluation.estimate_path);
    for (size_t i = 0; i < evaluation.pairs.size(); ++i) {
      const auto [true_index, index] = evaluation.pairs[i];
      const Eigen::Vector3d found = evaluation.aligned[index].world_from_cam.translation,
                            truth = reference[true_index].world_from_cam.translation;
      csv += ToString(evaluation.estimate[index].timestamp) + ',' + ToString(reference[true_index].timestamp) + ',' +
             FormatFixed(evaluation.ate.errors[i], 9);
      for (const double value : {found.x(), found.y(), found.z(), truth.x(), truth.y(), truth.z()})
        csv += ',' + FormatFixed(value, 9);
      csv += ',' + name + '\n';
    }
  }
  return csv;
}

std::string EvaluationSvg(const std::vector<Evaluation>& evaluations, const Trajectory& reference) {
  TrajectoryChartInput input;
  input.reference = reference;
  std::vector<NamedErrors> errors;
  for (size_t i = 0; i < evaluations.size(); ++i) {
    const std::string name = ShortName(evaluations, i);
    input.estimates.push_back({name, evaluations[i].aligned});
    NamedErrors error{name, {}, evaluations[i].ate.errors};
    for (const StampPair& pair : evaluations[i].pairs)
      error.stamps.push_back(evaluations[i].aligned[pair.second].timestamp);
    errors.push_back(std::move(error));
  }
  std::vector<std::vector<Chart>> rows = {{TopViewChart(input)}};
  for (Chart& chart : CoordinateCharts(input)) rows.push_back({std::move(chart)});
  rows.push_back({ErrorChart(input, errors)});
  std::string title = "ATE RMSE " + LengthText(evaluations[0].ate.summary.rmse) + ", " +
                      std::to_string(evaluations[0].pairs.size()) + " pairs";
  if (evaluations.size() > 1)
    title = std::to_string(evaluations.size()) + " estimates, mean ATE RMSE " +
            LengthText(ColumnSummary(evaluations, kColumns[0]).mean);
  return ChartSheetSvg(title, rows);
}

std::string LengthText(double metres) {
  return metres < 0.1 ? FormatFixed(1e3 * metres, 2) + " mm" : FormatFixed(metres, 3) + " m";
}

}  // namespace yorb
