// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/box_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>
#include <utility>

#include "core/text.h"
#include "detection/class_names.h"

namespace yorb {
namespace {

using Json = nlohmann::json;

bool IsSound(const Box& box) {
  return std::isfinite(box.left) && std::isfinite(box.top) && std::isfinite(box.right) && std::isfinite(box.bottom) &&
         std::isfinite(box.confidence) && HasArea(box);
}

void Add(const Box& box, TimedBoxes& moment) {
  if (IsSound(box)) {
    moment.boxes.push_back(box);
  } else {
    ++moment.num_dropped;
  }
}

/// Lines of one moment may be many (people.txt); they become one.
void Add(TimedBoxes moment, BoxFile& file) {
  const auto is_same = [&](const TimedBoxes& last) {
    return last.time == moment.time && last.width == moment.width && last.height == moment.height;
  };
  if (!file.moments.empty() && is_same(file.moments.back())) {
    TimedBoxes& last = file.moments.back();
    last.boxes.insert(last.boxes.end(), moment.boxes.begin(), moment.boxes.end());
    last.num_dropped += moment.num_dropped;
  } else {
    file.moments.push_back(std::move(moment));
  }
}

/// A number that is there and can be no time in seconds.
Error NoSeconds(const std::string& where, const std::string& stamp) {
  return BadInput(where + ": the time stamp " + stamp.substr(0, 40) +
                  " is none in seconds; if it counts nanoseconds (or micro- or milliseconds), write seconds with a " +
                  "decimal point, as the pictures' stamps are");
}

Status ReadPeople(const TextFile& text, BoxFile& file) {
  for (const TextLine& line : text.lines) {
    const auto words = SplitAtBlanks(line.text);
    const auto time = ParseTimestamp(words.front());
    std::vector<double> numbers;
    for (size_t i = 1; i < words.size(); ++i) {
      if (const auto number = ParseDouble(words[i])) numbers.push_back(*number);
    }
    if ((words.size() != 5 && words.size() != 6) || numbers.size() + 1 != words.size() ||
        (!time && !ParseDouble(words.front()))) {
      return BadInput(text.Where(line) + ": a line is 'timestamp left top right bottom visible_px', or JSON with " +
                      "timestamp and boxes; here stands '" + line.text.substr(0, 80) + "'");
    }
    if (!time) return NoSeconds(text.Where(line), std::string(words.front()));
    TimedBoxes moment{*time, {}, line.number};
    Add(Box{"person", 1, numbers[0], numbers[1], numbers[2], numbers[3]}, moment);
    Add(std::move(moment), file);
  }
  return Status::Ok();
}

constexpr double kMostConfidence = 1.001;  // 1, rounded somehow

/// A number, or the text of one; not a number where there is none.
double NumberOf(const Json& object, const char* key, double otherwise) {
  const auto found = object.find(key);
  if (found == object.end()) return otherwise;
  if (found->is_number()) return found->get<double>();
  if (found->is_string()) return ParseDouble(found->get<std::string>()).value_or(std::nan(""));
  return std::nan("");
}

/// The class by its word, or by COCO's number.
std::optional<std::string> NameOf(const Json& object) {
  for (const char* key : {"name", "class_name", "class", "label", "cls", "class_id"}) {
    const auto found = object.find(key);
    if (found == object.end()) continue;
    std::optional<long long> number;
    if (found->is_number_integer()) number = found->get<long long>();
    if (found->is_number_float()) number = WholeNumber(found->get<double>());  // tensors give 0.0
    if (found->is_string()) number = ParseInteger(Trim(found->get<std::string>()));
    if (!number && !found->is_string()) return std::nullopt;
    if (!number) return found->get<std::string>();
    const auto count = static_cast<long long>(CocoNames().size());
    if (*number < 0 || *number >= count) return std::nullopt;
    return CocoNames()[static_cast<size_t>(*number)];
  }
  return std::nullopt;
}

/// By any of the names that it goes by; 1 where there is none.
double ConfidenceOf(const Json& object) {
  for (const char* key : {"confidence", "conf", "score"}) {
    if (object.contains(key)) return NumberOf(object, key, 1);
  }
  return 1;
}

/// The names of the four edges in files of several tools.
constexpr std::array<std::array<const char*, 3>, 4> kEdgeNames = {
    {{"left", "xmin", "x1"}, {"top", "ymin", "y1"}, {"right", "xmax", "x2"}, {"bottom", "ymax", "y2"}}};

/// The four edges by their names, in the box or in an object in it, or as a list. What is wrong, in words.
std::string ReadEdges(const Json& object, Box& box) {
  double* const edges[] = {&box.left, &box.top, &box.right, &box.bottom};
  const auto inner = object.find("box");
  const auto list = inner == object.end() ? object.find("xyxy") : inner;
  const bool is_list = list != object.end() && list->is_array() && list->size() == 4;
  const Json& named = inner != object.end() && inner->is_object() ? *inner : object;
  for (size_t i = 0; i < 4; ++i) {
    const auto key =
        std::find_if(kEdgeNames[i].begin(), kEdgeNames[i].end(), [&](const char* k) { return named.contains(k); });
    if (!is_list && key == kEdgeNames[i].end()) {
      return std::string("a box has no ") + kEdgeNames[i][0] +
             (object.contains("bbox") || object.contains("xywh")
                  ? "; four numbers may be a corner and a size, or two corners: write left, top, right and bottom"
                  : "; its edges are left, top, right and bottom, px");
    }
    const Json one{{"edge", is_list ? (*list)[i] : named[*key]}};
    *edges[i] = NumberOf(one, "edge", 0);
  }
  return "";
}

/// A box as its four edges, with name and confidence. What is wrong with it, in words; empty where all is well.
std::string ReadBox(const Json& object, Box& box) {
  if (!object.is_object()) return "a box is an object with name, confidence, left, top, right, bottom";
  const auto name = NameOf(object);
  if (!name) return "a box needs a name: a word, or a number of COCO's from 0 to 79";
  box.name = *name;
  box.confidence = ConfidenceOf(object);
  if (box.confidence < 0 || box.confidence > kMostConfidence)
    return "a confidence is a number from 0 to 1, not " + FormatShortest(box.confidence);
  return ReadEdges(object, box);
}

std::optional<Timestamp> TimeOf(const Json& object) {
  const auto found = object.find("timestamp");
  if (found == object.end()) return std::nullopt;
  if (found->is_string()) return ParseTimestamp(found->get<std::string>());
  return found->is_number() ? ParseTimestamp(FormatShortest(found->get<double>())) : std::nullopt;
}

/// Of the picture; 0 where it is not said.
std::pair<int, int> SizeOf(const Json& object) {
  constexpr double kMost = 1e6;
  const double width = NumberOf(object, "width", 0), height = NumberOf(object, "height", 0);
  const bool is_size = width >= 1 && width <= kMost && height >= 1 && height <= kMost;
  return is_size ? std::pair(static_cast<int>(width), static_cast<int>(height)) : std::pair(0, 0);
}

/// Where boxes are given for pictures that nothing says the time of.
Error NoTime(const std::string& where, const Json& json) {
  const std::string needed = where + ": has no timestamp in seconds";
  if (json.contains("image_id") || json.contains("annotations")) {
    return BadInput(needed + ": COCO's files name pictures by their ids; write a line a picture, " +
                    "{\"timestamp\": 1.5, \"boxes\": [...]}");
  }
  if (json.contains("image"))
    return BadInput(needed + ": it names a picture; `yorb detect SEQUENCE --json`, given the sequence's own folder, " +
                    "writes lines with time stamps");
  return BadInput(needed + "; a line is {\"timestamp\": 1.5, \"boxes\": [...]}");
}

/// Where a line stops to be JSON.
Error NoJson(const std::string& where, const std::string& line) {
  std::string fault = "is cut short";
  try {
    const Json read = Json::parse(line);
    if (!read.is_discarded()) fault = "is no list of boxes";
  } catch (const Json::parse_error& error) {
    if (error.byte > 0 && error.byte <= line.size())
      fault = "is no JSON from column " + std::to_string(error.byte) + " on, '" + line.substr(error.byte - 1, 20) + "'";
  } catch (const Json::exception&) {
    fault = "holds a number that is too large";
  }
  const bool is_no_number = line.find("NaN") != std::string::npos || line.find("Infinity") != std::string::npos;
  return BadInput(where + ": " + fault +
                  (is_no_number ? "; JSON has no NaN and no Infinity: write null"
                                : "; a line is {\"timestamp\": 1.5, \"boxes\": [...]}"));
}

/// What is said of one picture, or of one box of it.
Status ReadMoment(const Json& json, const std::string& where, int number, BoxFile& file) {
  if (!json.is_object())
    return BadInput(where + ": is no JSON object; a line is {\"timestamp\": 1.5, \"boxes\": [...]}");
  const auto time = TimeOf(json);
  if (!time && json.contains("timestamp")) return NoSeconds(where, json["timestamp"].dump());
  if (!time) return NoTime(where, json);
  Json list = Json::array();
  const bool is_flat =
      json.contains("box") || json.contains("bbox") || json.contains("xyxy") ||
      std::any_of(kEdgeNames[0].begin(), kEdgeNames[0].end(), [&](const char* k) { return json.contains(k); });
  for (const char* key : {"boxes", "detections"}) {
    if (json.contains(key)) list = json[key];
  }
  if (is_flat && list.is_array()) list.push_back(json);
  if (!list.is_array() || (list.empty() && !json.contains("boxes") && !json.contains("detections")))
    return BadInput(where + ": has no list of boxes");
  TimedBoxes moment{*time, {}, number};
  if (!is_flat) std::tie(moment.width, moment.height) = SizeOf(json);
  for (const Json& entry : list) {
    Box box;
    const std::string fault = ReadBox(entry, box);
    if (!fault.empty()) return BadInput(where + ": " + fault);
    Add(box, moment);
  }
  Add(std::move(moment), file);
  return Status::Ok();
}

/// One document in place of lines: a list of what lines hold, or a single one of them over several lines.
std::optional<Json> WholeDocument(const TextFile& text) {
  const std::string& first = text.lines.front().text;
  if (first.front() == '{' && Json::accept(first)) return std::nullopt;
  std::string all;
  for (const TextLine& line : text.lines) all += line.text + "\n";
  Json json = Json::parse(all, nullptr, false);
  if (json.is_discarded()) return std::nullopt;
  return json.is_array() ? json : Json::array({json});
}

Status ReadJson(const TextFile& text, BoxFile& file) {
  if (const auto whole = WholeDocument(text)) {
    file.rows = "entry";
    file.names_all = whole->empty();  // as in an empty file, nobody was seen
    for (size_t i = 0; i < whole->size(); ++i) {
      const std::string where = file.path + ", entry " + std::to_string(i + 1);
      if (const Status read = ReadMoment((*whole)[i], where, static_cast<int>(i + 1), file); !read) return read;
    }
    return Status::Ok();
  }
  for (const TextLine& line : text.lines) {
    const Json json = Json::parse(line.text, nullptr, false);
    if (json.is_discarded()) return NoJson(text.Where(line), line.text);
    if (const Status read = ReadMoment(json, text.Where(line), line.number, file); !read) return read;
  }
  return Status::Ok();
}

/// Corners as fractions of the picture, where pixels are meant.
bool AreFractions(const BoxFile& file) {
  bool has_boxes = false;
  for (const TimedBoxes& moment : file.moments) {
    for (const Box& box : moment.boxes) {
      has_boxes = true;
      if (box.right > 1.5 || box.bottom > 1.5) return false;
    }
  }
  return has_boxes;
}

}  // namespace

size_t BoxFile::num_dropped() const {
  size_t count = 0;
  for (const TimedBoxes& moment : moments) count += moment.num_dropped;
  return count;
}

Result<BoxFile> ReadBoxFile(const std::string& path) {
  const auto text = ReadTextFile(path);
  if (!text) return text.error();
  BoxFile file;
  file.path = path;
  const char first = text->lines.empty() ? '0' : text->lines.front().text.front();
  file.names_all = first != '{' && first != '[';
  const Status status = file.names_all ? ReadPeople(*text, file) : ReadJson(*text, file);
  if (!status) return status.error();
  if (AreFractions(file))
    return BadInput(path + ": all boxes lie between 0 and 1, as fractions of the picture do; pixels are expected");
  return file;
}

std::string ToJsonLine(const BoxLine& about, const std::vector<Box>& boxes) {
  const auto quoted = [](const std::string& text) {
    return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
  };
  std::string line = "{";
  const auto add = [&](const char* key, const std::string& value) {
    line += (line.size() > 1 ? ", \"" : "\"") + std::string(key) + "\": " + value;
  };
  if (about.time) add("timestamp", ToString(*about.time));
  if (about.image) add("image", quoted(*about.image));
  if (about.width) add("width", std::to_string(*about.width));
  if (about.height) add("height", std::to_string(*about.height));
  std::string list;
  for (const Box& box : boxes) {
    list += (list.empty() ? "{" : ", {");
    list += "\"name\": " + quoted(box.name) + ", \"confidence\": " + FormatFixed(box.confidence, 4) +
            ", \"left\": " + FormatFixed(box.left, 2) + ", \"top\": " + FormatFixed(box.top, 2) +
            ", \"right\": " + FormatFixed(box.right, 2) + ", \"bottom\": " + FormatFixed(box.bottom, 2) + "}";
  }
  add("boxes", "[" + list + "]");
  return line + "}";
}

}  // namespace yorb
