// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "system/config.h"

namespace yorb {

/// One value for one dotted key, and who says so: "my.yaml, line 3" or "--set".
struct Setting {
  std::string key;    ///< features.wanted
  std::string value;  ///< as it was written
  std::string origin;
};

/// What a config file holds: the settings that differ from the default, and perhaps the camera of the run it was
/// written by (group `camera`), as the text of a camera file.
struct ConfigFile {
  std::vector<Setting> settings;
  std::string camera_text;
};

/// Reads a YAML file of groups and keys. Bad input where it is no YAML, holds lists, or names a key twice; whether the
/// keys are known is for WithSettings to say.
Result<ConfigFile> ReadConfigFile(const std::string& path);

/// Reads "features.wanted=1200".
Result<Setting> ParseSetting(const std::string& text, const std::string& origin);

/// `config` with the settings laid over it, the last one of a key winning. Bad input names the key, its origin and what
/// may stand there; for an unknown key the nearest known one.
Result<Config> WithSettings(Config config, const std::vector<Setting>& settings);

/// Bad input where values that may stand alone cannot stand together, or one is out of its range.
Status ValidateConfig(const Config& config);

/// All values as YAML, with the camera (the text of a camera file, may be empty) as group `camera`. Read back, it gives
/// the same values to the bit.
std::string ConfigText(const Config& config, const std::string& camera_text);

/// The same with every path from the root, so that it means the same wherever it is read.
Config WithWholePaths(Config config);

/// Sixteen hexadecimal digits that are equal for equal values of everything in ConfigText.
std::string ConfigDigest(const Config& config, const std::string& camera_text);

/// All dotted keys, in the order of ConfigText.
std::vector<std::string> ConfigKeys();

}  // namespace yorb
