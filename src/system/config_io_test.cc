// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "system/config_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "system/config_fields.h"

namespace yorb {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class ConfigIo : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string("config_io_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string File(const std::string& text) const {
    const std::string path = (folder_ / "my config.yaml").string();
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }

  Result<Config> Read(const std::string& text) const {
    const auto file = ReadConfigFile(File(text));
    if (!file) return file.error();
    return WithSettings(Config(), file->settings);
  }

  std::string Complaint(const std::string& text) const {
    const auto config = Read(text);
    return config ? "no complaint" : config.error().message;
  }

  static std::string SetComplaint(const std::string& text) {
    const auto setting = ParseSetting(text, "--set");
    if (!setting) return setting.error().message;
    const auto config = WithSettings(Config(), {*setting});
    return config ? "no complaint" : config.error().message;
  }

  std::filesystem::path folder_;
};

TEST_F(ConfigIo, WhatIsWrittenReadsBackAsTheSameToTheBit) {
  Config config;
  config.mode = "inline";
  config.seed = 123456789012345;
  config.features.alpha = std::nextafter(0.7, 1);
  config.features.wanted = 777;
  const std::string text = ConfigText(config, "");
  const auto back = Read(text);
  ASSERT_TRUE(back.ok()) << back.error().message;
  EXPECT_EQ(back->features.alpha, config.features.alpha);
  EXPECT_EQ(back->seed, config.seed);
  EXPECT_EQ(ConfigText(*back, ""), text);
  EXPECT_EQ(ConfigDigest(*back, ""), ConfigDigest(config, ""));
}

TEST_F(ConfigIo, EveryKeyCanBeSetToItsOwnValue) {
  Config config;
  EXPECT_GE(FieldsOf(config).size(), 15u);
  for (const ConfigField& field : FieldsOf(config)) {
    EXPECT_EQ(SetComplaint(field.key + "=" + field.text), "no complaint");
    EXPECT_THAT(ConfigText(config, ""), HasSubstr(field.key.substr(field.key.rfind('.') + 1) + ": "));
  }
}

TEST_F(ConfigIo, OnlyWhatTheFileNamesIsChanged) {
  const auto config =
      Read("\xef\xbb\xbf# mine\r\nfeatures:\r\n  wanted: 1200\r\n  detector: \"fixed\"\r\ntracking:\r\n");
  ASSERT_TRUE(config.ok()) << config.error().message;
  Config expected;
  expected.features.wanted = 1200;
  expected.features.detector = "fixed";
  EXPECT_EQ(ConfigText(*config, ""), ConfigText(expected, ""));
}

TEST_F(ConfigIo, PathsAreRelativeToTheFileThatNamesThem) {
  const auto config = Read("masks: ../m/arm.png\nload_map: /maps/a.map\nplaces:\n  vocabulary: own.yvoc\n");
  ASSERT_TRUE(config.ok()) << config.error().message;
  EXPECT_EQ(config->masks, (folder_ / "../m/arm.png").string());
  EXPECT_EQ(config->load_map, "/maps/a.map");
  EXPECT_EQ(config->places.vocabulary, (folder_ / "own.yvoc").string());
  EXPECT_EQ(config->detections, "");

  Config typed;
  typed.detections = "../people.txt";
  const Config whole = WithWholePaths(typed);
  EXPECT_TRUE(std::filesystem::path(whole.detections).is_absolute());
  EXPECT_EQ(whole.masks, "") << "no path at all";
  EXPECT_EQ(Read(ConfigText(whole, ""))->detections, whole.detections) << "the same wherever it is read";
}

TEST_F(ConfigIo, EmptyFilesChangeNothing) {
  for (const char* text : {"", "# nothing\n", "---\n", "%YAML:1.0\n---\n"}) {
    const auto config = Read(text);
    ASSERT_TRUE(config.ok()) << config.error().message;
    EXPECT_EQ(ConfigText(*config, ""), ConfigText(Config(), ""));
  }
}

TEST_F(ConfigIo, UnknownKeysAreRefusedByNameWithTheNearestKnownOne) {
  EXPECT_THAT(
      Complaint("features:\n  detectr: fixed\n"),
      AllOf(HasSubstr("my config.yaml, line 2"), HasSubstr("features.detectr"), HasSubstr("features.detector?")));
  EXPECT_THAT(Complaint("feature:\n  detector: fixed\n"),
              AllOf(HasSubstr("feature.detector is"), HasSubstr("features.detector?")));
  EXPECT_THAT(SetComplaint("detectr=fixed"), HasSubstr("features.detector?"));
  EXPECT_THAT(SetComplaint("seeds=3"), AllOf(HasSubstr("--set: seeds"), HasSubstr("seed?")));
  EXPECT_THAT(Complaint("%YAML:1.0\nCamera.fx: 517\n"), AllOf(HasSubstr("Camera.fx"), HasSubstr("--camera")));
}

TEST_F(ConfigIo, OptionsOfTheCommandLineAreNamedAsSuch) {
  EXPECT_THAT(Complaint("seed: 1\nsave_map: a.map\n"),
              AllOf(HasSubstr("line 2: save_map"), HasSubstr("--save-map"), testing::Not(HasSubstr("load_map"))));
  EXPECT_THAT(SetComplaint("save-overlay=o"), HasSubstr("--save-overlay"));
}

TEST_F(ConfigIo, SwitchesAreReadInYamlsSpellings) {
  for (const char* yes : {"true", "True", "TRUE"}) {
    EXPECT_TRUE(Read(std::string("looping:\n  close_loops: ") + yes)->looping.close_loops) << yes;
  }
  for (const char* no : {"false", "False", "FALSE"}) {
    EXPECT_FALSE(Read(std::string("looping:\n  close_loops: ") + no)->looping.close_loops) << no;
  }
  for (const char* neither : {"tRUE", "1", ""}) {
    EXPECT_THAT(SetComplaint(std::string("looping.close_loops=") + neither), HasSubstr("true or false")) << neither;
  }
}

TEST_F(ConfigIo, WrongValuesAreRefusedWithKeyFileAndLine) {
  EXPECT_THAT(Complaint("\n\nfeatures:\n  wanted: many\n"),
              AllOf(HasSubstr("line 4"), HasSubstr("features.wanted"), HasSubstr("many"), HasSubstr("whole number")));
  for (const char* value : {"1200.5", "1e3", "", "-5", "nan", "99999999999999999999", "4294967796"}) {
    EXPECT_THAT(SetComplaint(std::string("features.wanted=") + value), HasSubstr("features.wanted is")) << value;
  }
  for (const char* value : {"nan", ".nan", "inf", "-inf", "0,7", "1e999", "0.7x", "0x1"}) {
    EXPECT_THAT(SetComplaint(std::string("features.alpha=") + value), HasSubstr("features.alpha is")) << value;
  }
  EXPECT_THAT(SetComplaint("features.detector=adaptve"), AllOf(HasSubstr("adaptve"), HasSubstr("fixed or adaptive")));
  EXPECT_THAT(SetComplaint("mode=inlne"), HasSubstr("inline, offline or live"));
  EXPECT_THAT(SetComplaint("features.fast_arc=11"), HasSubstr("9 or 12"));
}

TEST_F(ConfigIo, WrongShapesAreRefused) {
  EXPECT_THAT(Complaint("features:\n  detector: [fixed, 3]\n"),
              AllOf(HasSubstr("features.detector"), HasSubstr("list")));
  EXPECT_THAT(Complaint("features:\n  wanted:\n    more: 3\n"), HasSubstr("features.wanted.more"));
  EXPECT_THAT(Complaint("features:\n  wanted:\n"), HasSubstr("features.wanted has no value"));
  EXPECT_THAT(Complaint("features: 3\n"), AllOf(HasSubstr("features"), HasSubstr("group")));
  EXPECT_THAT(Complaint("seed: 3\nmode: inline\nseed: 4\n"),
              AllOf(HasSubstr("line 3"), HasSubstr("seed is given twice")));
  EXPECT_THAT(Complaint("features:\n  wanted: 900\nfeatures.wanted: 900\n"), HasSubstr("given twice"));
  EXPECT_THAT(Complaint("features:\n  detector: fixed\n bad: [\n"),
              AllOf(HasSubstr("my config.yaml, line"), HasSubstr("YAML")));
  EXPECT_THAT(Complaint("- a\n- b\n"), HasSubstr("no config file"));
  EXPECT_THAT(Complaint("just words\n"), HasSubstr("no config file"));
  EXPECT_THAT(Complaint("seed: 1\n---\nseed: 2\n"), HasSubstr("more than one"));
  EXPECT_THAT(Complaint("? [a, b]\n: 3\n"), HasSubstr("a key must be a word"));
  EXPECT_THAT(Complaint("camera: tum_fr1\n"), HasSubstr("--camera"));
  EXPECT_THAT(SetComplaint("features.detector"), HasSubstr("key=value"));
  EXPECT_THAT(SetComplaint("=3"), HasSubstr("key=value"));
}

TEST_F(ConfigIo, GroupsThatLeadBackToThemselvesOrMultiplyEnd) {
  EXPECT_THAT(Complaint("a: &a {b: *a}\n"), HasSubstr("a.b is no known key"));
  EXPECT_THAT(Complaint("features: &a {wanted: 900, features: *a}\n"),
              HasSubstr("features.features.wanted is no known"));
  std::string laughs = "a: &a {x: 1}\n";
  for (char group = 'b'; group < 'l'; ++group) {
    laughs += std::string(1, group) + ": &" + group + " {";
    for (int i = 0; i < 9; ++i) laughs += "k" + std::to_string(i) + ": *" + static_cast<char>(group - 1) + ", ";
    laughs += "}\n";
  }
  EXPECT_THAT(Complaint(laughs), HasSubstr("a.x is no known key"));
}

TEST_F(ConfigIo, MissingFilesAndFoldersAreRefusedByName) {
  EXPECT_THAT(ReadConfigFile("no_such.yaml").error().message, HasSubstr("no_such.yaml does not exist"));
  EXPECT_THAT(ReadConfigFile(folder_.string()).error().message, HasSubstr("is a folder"));
}

TEST_F(ConfigIo, LaterSettingsWin) {
  const auto config = WithSettings(Config(), {{"seed", "2", "a"}, {"seed", "3", "--set"}});
  ASSERT_TRUE(config.ok());
  EXPECT_EQ(config->seed, 3);
}

TEST_F(ConfigIo, TheCameraTravelsWithTheConfig) {
  const std::string camera = "name: tum_fr1\nfx: 517.306408\ndistortion: [0.262383, -0.953104]\n";
  const std::string text = ConfigText(Config(), camera);
  const auto file = ReadConfigFile(File(text));
  ASSERT_TRUE(file.ok()) << file.error().message;
  EXPECT_EQ(file->camera_text, camera);
  EXPECT_NE(ConfigDigest(Config(), camera), ConfigDigest(Config(), ""));
}

TEST_F(ConfigIo, ValuesThatCannotStandTogetherAreRefused) {
  Config config;
  EXPECT_TRUE(ValidateConfig(config).ok());
  config.features.fixed_threshold_low = config.features.fixed_threshold + 1;
  EXPECT_FALSE(ValidateConfig(config).ok());
  config = Config();
  config.features.alpha = std::nan("");
  EXPECT_THAT(ValidateConfig(config).error().message, HasSubstr("features.alpha is nan"));
  config = Config();
  config.features.wanted = config.tracking.min_first_points;
  EXPECT_TRUE(ValidateConfig(config).ok());
  config.features.wanted = 80;
  EXPECT_THAT(ValidateConfig(config).error().message,
              AllOf(HasSubstr("features.wanted is 80"), HasSubstr("tracking.min_first_points is 100")));
  config.localize_only = true;
  EXPECT_TRUE(ValidateConfig(config).ok()) << "no map is begun";
}

TEST_F(ConfigIo, SwitchWordsStandInQuotesSoThatOtherReadersTakeThemForText) {
  Config config;
  config.dynamics = "off";
  EXPECT_THAT(ConfigText(config, ""), HasSubstr("dynamics: \"off\""));
}

}  // namespace
}  // namespace yorb
