// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "camera/camera_io.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "camera/camera_dialects.h"
#include "core/text.h"

namespace yorb {
namespace {

constexpr int kDeepest = 20;  // nesting of a sane settings file; an alias may point into itself
constexpr size_t kMostEntries = 20000;

bool IsDirective(std::string_view line) { return line.substr(0, 1) == "%"; }

bool IsDocumentMark(std::string_view line) {
  const std::string_view mark = line.substr(0, 3);
  return (mark == "---" || mark == "...") && Trim(line.substr(3)).empty();
}

/// OpenCV's writer of old left out the blank: "Camera.fx:517.3", "data:[ 1, 2 ]".
std::string WithBlankAfterKey(std::string line) {
  const size_t start = line.find_first_not_of(' ');
  if (start == std::string::npos) return line;
  size_t end = start;
  while (end < line.size() &&
         (std::isalnum(static_cast<unsigned char>(line[end])) || line[end] == '_' || line[end] == '.')) {
    ++end;
  }
  const bool is_key = end > start && std::isalpha(static_cast<unsigned char>(line[start])) && end + 1 < line.size();
  if (is_key && line[end] == ':' &&
      std::string_view("0123456789+-.[{\"!").find(line[end + 1]) != std::string_view::npos) {
    line.insert(end + 1, " ");
  }
  return line;
}

/// One of the documents of a file, which `---` parts.
struct Document {
  int num_lines_before = 0;  ///< in the file
  std::string text;
};

/// What strict YAML rejects and OpenCV accepts: the %YAML:1.0 header, tabs between words, CRLF, keys without a blank.
/// Lines stay lines, so that they can be counted.
std::vector<Document> ToStrictYaml(std::string_view text) {
  std::vector<Document> documents(1);
  bool has_content = false;
  for (int number = 0; !text.empty(); ++number) {
    const size_t end = std::min(text.find('\n'), text.size());
    std::string line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    while (!line.empty() && line.back() == '\r') line.pop_back();
    std::replace(line.begin(), line.end(), '\t', ' ');
    if (IsDocumentMark(line) && has_content) {
      documents.push_back({number, ""});
      has_content = false;
    }
    if (IsDirective(line) || IsDocumentMark(line)) line.clear();
    const std::string_view words = Trim(line);
    has_content = has_content || (!words.empty() && words.front() != '#');
    documents.back().text += WithBlankAfterKey(std::move(line)) + "\n";
  }
  if (!has_content && documents.size() > 1) documents.pop_back();  // the last mark ends the file
  return documents;
}

/// Lays a tree of maps and lists out as keys with dots. False when it is too deep or too large to be a camera file.
bool Flatten(const YAML::Node& node, const std::string& key, int depth, KeyTable& table);

bool CollectValues(const YAML::Node& list, int depth, std::vector<std::string>& values) {
  if (depth > kDeepest || values.size() > kMostEntries) return false;
  for (const YAML::Node& item : list) {
    if (item.IsSequence()) {
      if (!CollectValues(item, depth + 1, values)) return false;
    } else {
      values.push_back(item.IsScalar() ? item.Scalar() : std::string());
    }
  }
  return true;
}

bool Flatten(const YAML::Node& node, const std::string& key, int depth, KeyTable& table) {
  if (depth > kDeepest || table.entries.size() > kMostEntries) return false;
  if (node.IsMap()) {
    for (const auto& pair : node) {
      const std::string name = pair.first.IsScalar() ? pair.first.Scalar() : std::string("?");
      if (!Flatten(pair.second, key.empty() ? name : key + "." + name, depth + 1, table)) return false;
    }
    return true;
  }
  KeyEntry entry{key, node.Mark().line + 1, {}, false};
  if (node.IsSequence()) {
    if (!CollectValues(node, depth, entry.values)) return false;
  } else {
    entry.values.push_back(node.IsScalar() ? node.Scalar() : std::string());
  }
  table.Add(std::move(entry));
  return true;
}

/// The keys of one document.
Result<KeyTable> ReadKeys(const Document& document, const std::string& path) {
  KeyTable table{path, {}};
  try {
    const YAML::Node root = YAML::Load(document.text);
    if (!root.IsMap()) return BadInput(path + " is no camera file: it holds no keys with values");
    if (!Flatten(root, "", 0, table)) return BadInput(path + " is no camera file: it is nested too deep or too large");
  } catch (const YAML::Exception& error) {
    const int line = document.num_lines_before + error.mark.line + 1;
    return BadInput(path + ", line " + std::to_string(line) + ": no valid YAML: " + error.msg);
  }
  for (KeyEntry& entry : table.entries) entry.line += document.num_lines_before;
  return table;
}

/// What the first document says counts: `rostopic echo` writes a message after the other. Later ones add what it lacks,
/// such as a depth factor written below a message, which ends in `---`.
Result<KeyTable> ReadKeys(const std::string& text, const std::string& path) {
  if (Trim(text).empty()) return BadInput(path + " is empty, a camera file is expected");
  if (Trim(text).front() == '<') return BadInput(path + " is XML; save the calibration as YAML");
  KeyTable all{path, {}};
  for (const Document& document : ToStrictYaml(text)) {
    auto keys = ReadKeys(document, path);
    if (!keys) return keys.error();
    const size_t num_before = all.entries.size();
    for (KeyEntry& entry : keys->entries) {
      if (num_before == 0 || !all.Has(entry.key)) all.entries.push_back(std::move(entry));
    }
  }
  return all;
}

/// The same picture at another size: halves of pixels move, since pixel (0, 0) is the centre of a pixel.
void Scale(double factor_x, double factor_y, Rig& rig) {
  rig.camera.fx *= factor_x;
  rig.camera.fy *= factor_y;
  rig.camera.cx = (rig.camera.cx + 0.5) * factor_x - 0.5;
  rig.camera.cy = (rig.camera.cy + 0.5) * factor_y - 0.5;
  rig.baseline_px *= factor_x;
}

}  // namespace

Result<Rig> ParseCameraFile(const std::string& text, const std::string& path) {
  const auto keys = ReadKeys(text, path);
  if (!keys) return keys.error();
  auto rig = RigFromKeys(*keys);
  if (rig && rig->name.empty()) rig->name = std::filesystem::path(path).filename().string();
  return rig;
}

Result<Rig> ReadCameraFile(const std::string& path) {
  const auto text = ReadWholeText(path);
  if (!text) return text.error();
  return ParseCameraFile(*text, path);
}

Result<FittedRig> FitToPictures(const Rig& rig, int width, int height) {
  FittedRig fitted{rig, false};
  Pinhole& camera = fitted.rig.camera;
  const std::string size = SizeText(width, height);
  if (camera.width == 0) {
    // No size stated: the principal point is near the middle of nearly every picture, and tells another size apart.
    const bool is_near_middle =
        camera.cx > 0.25 * width && camera.cx < 0.75 * width && camera.cy > 0.25 * height && camera.cy < 0.75 * height;
    if (!is_near_middle) {
      return BadInput("camera " + rig.name + " states no picture size, and its principal point (" +
                      FormatFixed(camera.cx, 1) + ", " + FormatFixed(camera.cy, 1) +
                      ") is far from the middle of the " + size +
                      " pictures; state the width and height that it was calibrated for");
    }
  } else if (camera.width != width || camera.height != height) {
    const double factor_x = static_cast<double>(width) / camera.width;
    const double factor_y = static_cast<double>(height) / camera.height;
    // Halving an odd size rounds by up to a pixel.
    const double slack = 1.0 / std::min({width, height, camera.width, camera.height});
    if (std::abs(factor_x / factor_y - 1) > slack) {
      return BadInput("camera " + rig.name + " is for pictures of " + SizeText(camera.width, camera.height) +
                      ", the pictures are " + size + ": another shape; give the camera of these pictures");
    }
    Scale(factor_x, factor_y, fitted.rig);
    fitted.was_scaled = true;
  }
  camera.width = width;
  camera.height = height;
  return fitted;
}

std::string CameraFileText(const Rig& rig) {
  const Pinhole& camera = rig.camera;
  size_t count = 8;
  while (count > 0 && camera.distortion[count - 1] == 0) --count;
  count = count == 0 ? 0 : count <= 4 ? 4 : count == 5 ? 5 : 8;
  std::string distortion;
  for (size_t i = 0; i < count; ++i) distortion += (i > 0 ? ", " : "") + FormatShortest(camera.distortion[i]);

  std::string name;
  for (const char c : rig.name) name += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  std::string text = "type: pinhole\nname: \"" + name + "\"\n";
  const auto add = [&text](const std::string& key, double value) { text += key + ": " + FormatShortest(value) + "\n"; };
  if (camera.width > 0) {
    add("width", camera.width);
    add("height", camera.height);
  }
  if (rig.fps > 0) add("fps", rig.fps);
  add("fx", camera.fx);
  add("fy", camera.fy);
  add("cx", camera.cx);
  add("cy", camera.cy);
  text += "distortion: [" + distortion + "]\n";
  add("baseline_px", rig.baseline_px);
  add("close_factor", rig.close_factor);
  if (rig.depth_factor > 0) add("depth_factor", rig.depth_factor);
  if (rig.readout_s > 0) add("readout_s", rig.readout_s);
  return text;
}

}  // namespace yorb
