// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "system/config_io.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include "core/text.h"
#include "system/config_fields.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCameraGroup = "camera";

bool IsPath(const std::string& key) {
  static const std::set<std::string> paths{"masks", "detections", "load_map", "detection.model", "places.vocabulary"};
  return paths.count(key) > 0;
}

/// The known key that a misspelt one most likely means; a key without its group is looked for as well.
std::string NearestKey(const std::string& key) {
  std::vector<std::string> words = ConfigKeys();
  std::map<std::string, std::string> key_of_word;
  for (const std::string& known : ConfigKeys()) {
    key_of_word[known] = known;
    const std::string leaf = known.substr(known.rfind('.') + 1);
    if (key_of_word.emplace(leaf, known).second) words.push_back(leaf);
  }
  return key_of_word[NearestWord(key, words)];
}

bool IsGroup(const std::string& key) {
  const std::vector<std::string> keys = ConfigKeys();
  return std::any_of(keys.begin(), keys.end(),
                     [&](const std::string& known) { return known.rfind(key + ".", 0) == 0; });
}

/// The option of the command line that has this name, where it is no key; empty: there is none.
std::string OptionNamed(std::string key) {
  static const std::set<std::string> options{"save-map", "save-overlay", "out", "quiet"};
  std::replace(key.begin(), key.end(), '_', '-');
  return options.count(key) > 0 ? "--" + key : "";
}

Error UnknownKey(const Setting& setting) {
  const std::string start = setting.origin + ": " + setting.key;
  if (const std::string option = OptionNamed(setting.key); !option.empty()) {
    return BadInput(start + " is no key but an option of the command line: " + option);
  }
  if (setting.key == kCameraGroup) {
    return BadInput(start + " is a group with the numbers of a camera; a camera's name or file is given with --camera");
  }
  if (IsGroup(setting.key)) return BadInput(start + " is a group of keys and takes no value of its own");
  if (setting.key.rfind("Camera", 0) == 0)
    return BadInput(start + " belongs to a camera file; give that with --camera");
  return BadInput(start + " is no known key; did you mean " + NearestKey(setting.key) + "?");
}

/// Walks through the groups of a YAML file and collects what is set.
class Flattener {
 public:
  Flattener(std::string path, ConfigFile& file) : path_(std::move(path)), file_(file) {}

  Status Group(const YAML::Node& node, const std::string& prefix) {
    for (const auto& entry : node) {
      const std::string origin = path_ + ", line " + std::to_string(entry.first.Mark().line + 1);
      if (!entry.first.IsScalar()) return BadInput(origin + ": a key must be a word");
      const Status status = Entry(prefix + entry.first.Scalar(), entry.second, origin);
      if (!status) return status;
    }
    return Status::Ok();
  }

 private:
  Status Entry(const std::string& key, const YAML::Node& value, const std::string& origin) {
    if (!value.IsMap() && !seen_.insert(key).second) return BadInput(origin + ": " + key + " is given twice");
    if (key == kCameraGroup && value.IsMap()) {
      file_.camera_text = YAML::Dump(value) + "\n";
      return Status::Ok();
    }
    if (value.IsMap() && IsGroup(key)) return Group(value, key + ".");
    if (value.IsMap()) return UnknownGroup(key, value, origin);  // and not walked into: an alias may lead back to it
    if (value.IsSequence()) return BadInput(origin + ": " + key + " is a list; one value is expected");
    if (value.IsNull() && IsGroup(key)) return Status::Ok();  // a group whose keys are all commented out
    if (!value.IsScalar()) return BadInput(origin + ": " + key + " has no value");
    file_.settings.push_back({key, IsPath(key) ? BesideFile(value.Scalar()) : value.Scalar(), origin});
    return Status::Ok();
  }

  /// Named by its first key, which says best what was meant.
  static Status UnknownGroup(const std::string& key, const YAML::Node& group, const std::string& origin) {
    const auto first = group.begin();
    const bool is_named = first != group.end() && first->first.IsScalar();
    return UnknownKey({is_named ? key + "." + first->first.Scalar() : key, "", origin});
  }

  /// Paths are relative to the file that names them.
  std::string BesideFile(const std::string& path) const {
    if (path.empty() || fs::path(path).is_absolute()) return path;
    return (fs::path(path_).parent_path() / path).string();
  }

  std::string path_;
  ConfigFile& file_;
  std::set<std::string> seen_;
};

/// The text of a file with a `%YAML:1.0` first line (as OpenCV writes it, and YAML readers refuse it) blanked out.
std::string WithoutVersionLine(std::string text) {
  if (text.rfind("%YAML", 0) == 0) text.erase(0, std::min(text.find('\n'), text.size()));
  return text;
}

/// Words that YAML readers would not take for text ("off" is a switch to many) stand in quotes.
std::string YamlText(const std::string& text) {
  static const std::set<std::string> switches{"", "on", "off", "yes", "no", "true", "false", "null", "y", "n"};
  const bool is_plain =
      text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_/.") == std::string::npos;
  if (is_plain && switches.count(text) == 0 && text.front() != '.') return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    if (c == '\n') {
      quoted += "\\n";
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

std::string Indented(const std::string& text) {
  std::string indented;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) indented += line.empty() ? "\n" : "  " + line + "\n";
  return indented;
}

}  // namespace

Result<ConfigFile> ReadConfigFile(const std::string& path) {
  const auto text = ReadWholeText(path);
  if (!text) return text.error();
  try {
    const std::vector<YAML::Node> documents = YAML::LoadAll(WithoutVersionLine(*text));
    if (documents.size() > 1) return BadInput(path + " holds more than one YAML document");
    ConfigFile file;
    if (documents.empty() || documents.front().IsNull()) return file;
    if (!documents.front().IsMap()) return BadInput(path + " is no config file: lines of `key: value` are expected");
    const Status status = Flattener(path, file).Group(documents.front(), "");
    if (!status) return status.error();
    return file;
  } catch (const YAML::Exception& error) {
    const std::string where = error.mark.is_null() ? path : path + ", line " + std::to_string(error.mark.line + 1);
    return BadInput(where + ": no valid YAML: " + error.msg);
  }
}

Result<Setting> ParseSetting(const std::string& text, const std::string& origin) {
  const size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    return BadInput(origin + " " + text + ": write key=value, such as features.wanted=1200");
  }
  return Setting{std::string(Trim(text.substr(0, equals))), std::string(Trim(text.substr(equals + 1))), origin};
}

Result<Config> WithSettings(Config config, const std::vector<Setting>& settings) {
  const std::vector<ConfigField> fields = FieldsOf(config);
  for (const Setting& setting : settings) {
    const auto field = std::find_if(fields.begin(), fields.end(), [&](const auto& f) { return f.key == setting.key; });
    if (field == fields.end()) return UnknownKey(setting);
    if (!field->set(setting.value)) {
      return BadInput(setting.origin + ": " + setting.key + " is \"" + setting.value + "\"; " + field->wanted +
                      " is expected");
    }
  }
  return config;
}

Status ValidateConfig(const Config& config) {
  Config copy = config;
  for (const ConfigField& field : FieldsOf(copy)) {
    if (!field.set(field.text)) return BadInput(field.key + " is " + field.text + "; " + field.wanted + " is expected");
  }
  if (config.features.fixed_threshold_low > config.features.fixed_threshold) {
    return BadInput("features.fixed_threshold_low is above features.fixed_threshold; it is the lower one of the two");
  }
  if (config.features.alpha_low > config.features.alpha) {
    return BadInput("features.alpha_low is above features.alpha; it is the lower one of the two");
  }
  if (config.features.wanted < config.tracking.min_first_points && !config.localize_only) {
    return BadInput("features.wanted is " + std::to_string(config.features.wanted) +
                    ", fewer points than a map begins with: tracking.min_first_points is " +
                    std::to_string(config.tracking.min_first_points) + "; raise the former or lower the latter");
  }
  return Status::Ok();
}

std::string ConfigText(const Config& config, const std::string& camera_text) {
  Config copy = config;
  std::string text, group;
  for (const ConfigField& field : FieldsOf(copy)) {
    const size_t dot = field.key.find('.');
    const std::string its_group = dot == std::string::npos ? "" : field.key.substr(0, dot);
    if (its_group != group && !its_group.empty()) text += its_group + ":\n";
    group = its_group;
    const std::string name = dot == std::string::npos ? field.key : "  " + field.key.substr(dot + 1);
    text += name + ": " + (field.is_text ? YamlText(field.text) : field.text) + "\n";
  }
  if (!camera_text.empty()) text += std::string(kCameraGroup) + ":\n" + Indented(camera_text);
  return text;
}

Config WithWholePaths(Config config) {
  std::error_code ignored;
  for (const ConfigField& field : FieldsOf(config)) {
    if (!IsPath(field.key) || field.text.empty()) continue;
    const std::string whole = fs::absolute(field.text, ignored).lexically_normal().string();
    if (!ignored) field.set(whole);
  }
  return config;
}

std::string ConfigDigest(const Config& config, const std::string& camera_text) {
  uint64_t hash = 0xcbf29ce484222325ull;  // FNV-1a
  for (const char c : ConfigText(config, camera_text)) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
  return HexText(hash);
}

std::vector<std::string> ConfigKeys() {
  Config config;
  const std::vector<ConfigField> fields = FieldsOf(config);
  std::vector<std::string> keys;
  std::transform(fields.begin(), fields.end(), std::back_inserter(keys),
                 [](const ConfigField& field) { return field.key; });
  return keys;
}

}  // namespace yorb
