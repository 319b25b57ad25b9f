// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// The two ways in which a check is told.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "datasets/check.h"

namespace yorb {
namespace {

using Json = nlohmann::ordered_json;

const char* WordOf(Finding::Level level) {
  switch (level) {
    case Finding::Level::kFine:
      return "fine";
    case Finding::Level::kWarning:
      return "warning";
    case Finding::Level::kError:
      return "error";
  }
  return "";
}

template <typename T>
Json OrNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json JsonOf(const ListFacts& facts) {
  const auto stamp = [](const std::optional<Timestamp>& time) { return time ? Json(ToString(*time)) : Json(nullptr); };
  return {{"count", facts.count},
          {"rate_hz", OrNull(facts.rate_hz)},
          {"longest_gap_s", OrNull(facts.longest_gap_s)},
          {"first", stamp(facts.first)},
          {"last", stamp(facts.last)}};
}

}  // namespace

std::string CheckText(const SequenceCheck& check) {
  std::string text = check.folder + "\n";
  for (const Finding& finding : check.findings) {
    std::string level = WordOf(finding.level), topic = finding.topic;
    level.resize(std::max<size_t>(level.size(), 8), ' ');
    topic.resize(std::max<size_t>(topic.size(), 9), ' ');
    text += "  " + level + topic + finding.text + "\n";
  }
  return text + (check.is_usable() ? "usable\n" : "not usable\n");
}

std::string CheckJson(const SequenceCheck& check) {
  Json findings = Json::array();
  for (const Finding& finding : check.findings) {
    findings.push_back({{"level", WordOf(finding.level)}, {"topic", finding.topic}, {"text", finding.text}});
  }
  const Json json{{"folder", check.folder},
                  {"usable", check.is_usable()},
                  {"camera", check.camera.empty() ? Json(nullptr) : Json(check.camera)},
                  {"width", OrNull(check.width)},
                  {"height", OrNull(check.height)},
                  {"colour", JsonOf(check.colour)},
                  {"depth", JsonOf(check.depth)},
                  {"pairs", OrNull(check.num_pairs)},
                  {"median_pair_distance_s", OrNull(check.median_pair_distance_s)},
                  {"sampled", check.num_sampled},
                  {"unreadable", check.num_unreadable},
                  {"depth_range_m",
                   {{"p5", OrNull(check.depth_p5_m)},
                    {"median", OrNull(check.depth_median_m)},
                    {"p95", OrNull(check.depth_p95_m)}}},
                  {"depth_hole_share", OrNull(check.depth_hole_share)},
                  {"truth_share", OrNull(check.truth_share)},
                  {"findings", findings}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace yorb
