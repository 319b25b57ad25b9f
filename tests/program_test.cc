// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// The program from outside: exit codes, complaints, signals, what is written and what is not.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/text.h"
#include "system/config_io.h"
#include "tests/synthetic_dataset.h"

namespace yorb {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// What a call of the program came to.
struct Outcome {
  int code = -1;  ///< 128 + n where signal n ended it
  std::string out, err;
};

class Program : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    std::filesystem::remove_all(Folder());
    const SyntheticDataset room(12);
    room.WriteTo(Folder() + "/room");
    room.WriteTo(Folder() + "/long", 200);
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(Folder()); }
  static std::string Folder() { return testing::TempDir() + "program_test_" + std::to_string(::getpid()); }
  static std::string In(const std::string& name) { return Folder() + "/" + name; }

  /// Starts the program with its output in files.
  static pid_t Start(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), YORB_PROGRAM);
    // Opened before the fork: a signal may end the child before it does anything.
    const int out = ::open(In("stdout").c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    const int err = ::open(In("stderr").c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    const pid_t child = ::fork();
    if (child != 0) {
      ::close(out);
      ::close(err);
      return child;
    }
    std::vector<char*> raw;
    for (std::string& argument : arguments) raw.push_back(argument.data());
    raw.push_back(nullptr);
    ::dup2(out, STDOUT_FILENO);
    ::dup2(err, STDERR_FILENO);
    ::execv(raw[0], raw.data());
    ::_exit(99);
  }

  static Outcome WaitFor(pid_t child) {
    int status = 0;
    ::waitpid(child, &status, 0);
    Outcome outcome;
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    outcome.out = *ReadWholeText(In("stdout"));
    outcome.err = *ReadWholeText(In("stderr"));
    return outcome;
  }

  static Outcome Call(std::vector<std::string> arguments) { return WaitFor(Start(std::move(arguments))); }

  static size_t Lines(const std::string& text) {
    return static_cast<size_t>(std::count(text.begin(), text.end(), '\n'));
  }

  /// Bad input: exit code 2 and one line that names `word`.
  static void ExpectRefused(const std::string& word, const std::vector<std::string>& arguments) {
    const Outcome outcome = Call(arguments);
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_EQ(Lines(outcome.err), 1u) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(word));
    EXPECT_EQ(outcome.out, "");
  }
};

TEST_F(Program, HelpAndVersionAreNoErrors) {
  for (const char* command : {"run", "check", "eval", "synth", "detect", "vocab", "map", "bench"}) {
    const Outcome help = Call({command, "--help"});
    EXPECT_EQ(help.code, 0) << command;
    const size_t examples = help.out.find("Examples:");
    ASSERT_NE(examples, std::string::npos) << command;
    EXPECT_THAT(help.out.substr(examples), HasSubstr("yorb " + std::string(command))) << "examples of use";
  }
  EXPECT_EQ(Call({"--help"}).code, 0);
  EXPECT_THAT(Call({"--version"}).out, HasSubstr("yorb 0."));
}

TEST_F(Program, WrongCommandLinesAreRefusedInOneLineWithTheNearestKnownWord) {
  const std::string room = In("room"), out = In("refused");
  ExpectRefused("needs a command", {});
  ExpectRefused("run", {"rnu", room});
  ExpectRefused("--seed", {"run", room, "--sed", "3", "--out", out});
  ExpectRefused("--sed ", {"run", room, "--sed=3", "--out", out});
  ExpectRefused("features.detector", {"run", room, "--set", "features.detectr=fixed", "--out", out});
  ExpectRefused("inlne", {"run", room, "--mode", "inlne", "--out", out});
  ExpectRefused("--seed", {"run", room, "--seed", "1.5", "--out", out});
  ExpectRefused("--seed", {"run", room, "--seed", "", "--out", out});
  ExpectRefused("--max-frames", {"run", room, "--max-frames", "0", "--out", out});
  ExpectRefused("--max-frames", {"run", room, "--max-frames=-5", "--out", out});
  ExpectRefused("no_such.yaml", {"run", room, "--config", "no_such.yaml", "--out", out});
  ExpectRefused("no_such_folder", {"run", "no_such_folder", "--out", out});
  ExpectRefused("DIR", {"run", "--out", out});
  ExpectRefused("--out", {"run", room, "--out", ""});
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(Program, OptionsWithNothingBehindThemAreRefusedByName) {
  const std::string room = In("room");
  for (const char* option : {"--camera", "--config", "--set", "--detections", "--masks", "--model", "--save-overlay",
                             "--save-map", "--load-map", "--out"})
    ExpectRefused(option + std::string(" is empty"), {"run", room, option, ""});
  ExpectRefused("--camera is empty", {"check", room, "--camera", ""});
  ExpectRefused("--model is empty", {"detect", room, "--model", ""});
  ExpectRefused("--evaluate is empty", {"detect", "--evaluate", ""});
  ExpectRefused("--masks is empty", {"map", "export", In("a.map"), "--out", In("a.ply"), "--masks", ""});
  ExpectRefused("--out is empty", {"bench", "detector", "--out", ""});
  ExpectRefused("--estimate is empty", {"eval", "--reference", "a", "--estimate", "b", ""});
  ExpectRefused("--csv is empty", {"eval", "--reference", "a", "--estimate", "b", "--csv", ""});
}

TEST_F(Program, WhatWasAskedForIsNotLeftOutInSilence) {
  const std::string room = In("room"), out = In("asked");
  ExpectRefused("no_boxes.txt", {"run", room, "--detections", "no_boxes.txt", "--out", out});
  ExpectRefused("holds pictures", {"run", room, "--save-overlay", room + "/rgb", "--out", out});
  ExpectRefused("people.txt", {"bench", "dynamic", room, "--way", "full-exact"});
}

TEST_F(Program, BenchesOfferWhatTheyTake) {
  const std::string room = In("room");
  const Outcome dynamic = Call({"bench", "dynamic", "--help"}), light = Call({"bench", "light", "--help"});
  EXPECT_THAT(Call({"bench", "speed", "--help"}).out, AllOf(HasSubstr("--dynamics "), HasSubstr("--detections ")));
  EXPECT_THAT(dynamic.out, HasSubstr("--mode "));
  for (const char* option : {"--dynamics", "--detections"}) {
    EXPECT_THAT(dynamic.out, Not(HasSubstr(option)));
    ExpectRefused("yorb bench dynamic: " + std::string(option), {"bench", "dynamic", room, option, "full"});
  }
  for (const char* option : {"--mode", "--dynamics", "--detections", "--masks", "--model"}) {
    EXPECT_THAT(light.out, Not(HasSubstr(option)));
    ExpectRefused(option, {"bench", "light", room, option, "live"});
  }
}

TEST_F(Program, BenchesRefuseSettingsThatTheyWouldPassOver) {
  const std::string room = In("room");
  for (const char* bench : {"dynamic", "light"}) {
    for (const char* setting :
         {"load_map=nothere.map", "localize_only=true", "detections=people.txt", "dynamics=paper"})
      ExpectRefused("--set: " + std::string(setting).substr(0, 6), {"bench", bench, room, "--set", setting});
  }
  ExpectRefused("--set: mode", {"bench", "light", room, "--set", "mode=live"});
  ASSERT_TRUE(WriteFileWhole(In("whole.yaml"), ConfigText(Config(), "")).ok());
  ASSERT_TRUE(WriteFileWhole(In("paper.yaml"), "dynamics: paper\n").ok());
  ExpectRefused("paper.yaml, line 1: dynamics", {"bench", "dynamic", room, "--config", In("paper.yaml")});
  ExpectRefused("people.txt", {"bench", "dynamic", room, "--config", In("whole.yaml"), "--way", "full-exact"});
  ExpectRefused("nothere.map", {"bench", "speed", room, "--set", "load_map=nothere.map", "dynamics=off"});
}

TEST_F(Program, CountsOfBenchesAreWholeNumbersFromOneOn) {
  for (const char* bad : {"-1", "0", "x", "1.5", "99999999999999999999"}) {
    ExpectRefused("--rounds must be a whole number from 1 ", {"bench", "detector", "--rounds", bad});
    ExpectRefused("--runs must be a whole number from 1 ", {"bench", "dynamic", In("room"), "--runs", bad});
    if (bad != std::string("0"))  // all pictures
      ExpectRefused("--pictures must be a whole number from 0 ", {"bench", "features", In("no"), "--pictures", bad});
  }
}

TEST_F(Program, EvalNeverOverwritesWhatItReads) {
  const std::string poses = "1 0 0 0 0 0 0 1\n2 1 0 0 0 0 0 1\n3 1 1 0 0 0 0 1\n4 1 1 1 0 0 0 1\n";
  for (const char* name : {"truth.txt", "found.txt", "found.svg"}) ASSERT_TRUE(WriteFileWhole(In(name), poses).ok());
  const std::vector<std::string> eval = {"eval",       "--reference",   In("truth.txt"),
                                         "--estimate", In("found.svg"), In("found.txt")};
  const auto with = [&](const std::string& option, const std::string& path) {
    std::vector<std::string> arguments = eval;
    arguments.insert(arguments.end(), {option, path});
    return arguments;
  };
  ExpectRefused("what --reference reads", with("--csv", In("truth.txt")));
  ExpectRefused("what --estimate reads", with("--csv", In("room/../found.txt")));
  ExpectRefused("what --estimate reads", with("--plot", In("found.svg")));
  std::filesystem::create_symlink(In("truth.txt"), In("link.csv"));
  ExpectRefused("what --reference reads", with("--csv", In("link.csv")));
  for (const char* name : {"truth.txt", "found.txt", "found.svg"}) EXPECT_EQ(*ReadWholeText(In(name)), poses) << name;
  std::vector<std::string> covered = with("--csv", In("room/rgb.txt"));
  covered.insert(covered.end(), {"--sequence", In("room")});
  ExpectRefused("what --sequence reads", covered);
  std::vector<std::string> both = with("--csv", In("room/../x.svg"));
  both.insert(both.end(), {"--plot", In("x.svg")});
  ExpectRefused("--plot would be one file", both);
  covered.back() = In("nothere");
  ExpectRefused("--sequence: folder " + In("nothere"), covered);
  for (int times = 0; times < 2; ++times) EXPECT_EQ(Call(with("--csv", In("errors.csv"))).code, 0) << "its own results";
}

TEST_F(Program, WarningsThatRepeatAreCountedByCommandsWithoutALogToo) {
  SyntheticDataset(8).WriteTo(In("torn"));
  for (int i = 2; i < 7; ++i) ASSERT_TRUE(WriteFileWhole(In("torn/rgb/" + std::to_string(i) + ".png"), "").ok());
  const Outcome outcome = Call({"bench", "speed", In("torn"), "--dynamics", "off", "--mode", "inline"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("more of these warnings"));
}

TEST_F(Program, AnUnusableOutputFolderIsRefusedBeforeAnyWork) {
  ASSERT_TRUE(WriteFileWhole(In("plain"), "mine").ok());
  ExpectRefused("plain", {"run", In("room"), "--out", In("plain")});
  ExpectRefused("plain", {"run", In("room"), "--out", In("plain/run")});
  EXPECT_EQ(*ReadWholeText(In("plain")), "mine");
}

TEST_F(Program, BenchesTryTheirFolderBeforeAnyWork) {
  const std::string taken = In("plain/bench");
  ASSERT_TRUE(WriteFileWhole(In("plain"), "mine").ok());
  ExpectRefused("plain", {"bench", "features", In("room/rgb"), "--out", taken});
  ExpectRefused("plain", {"bench", "light", In("room"), "--out", taken});
  ExpectRefused("plain", {"bench", "detector", "--out", taken});
  ExpectRefused("holds no pictures", {"bench", "detector", "--out", In("bench"), "--pictures", In("nothere")});
}

TEST_F(Program, PlacesOfOneNameHaveTheirOwnFigures) {
  for (const char* folder : {"one/office", "two/office"}) {
    std::filesystem::create_directories(In(folder));
    std::filesystem::copy_file(In("room/rgb/0.png"), In(folder + std::string("/0.png")));
  }
  const Outcome outcome = Call({"bench", "features", In("one/office"), In("two/office"), "--out", In("figures")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  for (const char* name : {"office", "office_2"})
    EXPECT_TRUE(std::filesystem::exists(In("figures/" + std::string(name) + "_figure5_light.png"))) << name;
}

TEST_F(Program, QuietRunsPrintNothingAndOthersAFewLines) {
  const Outcome quiet = Call({"run", In("room"), "--mode", "inline", "--out", In("quiet"), "--quiet"});
  EXPECT_EQ(quiet.code, 0) << quiet.err;
  EXPECT_EQ(quiet.out, "");
  const Outcome loud = Call({"run", In("room"), "--mode", "inline", "--out", In("loud")});
  EXPECT_EQ(loud.code, 0) << loud.err;
  EXPECT_THAT(Lines(loud.out), AllOf(testing::Ge(2u), testing::Le(8u)));
}

TEST_F(Program, AnInlineRunIsRepeatedByItsConfigAloneToTheBit) {
  ASSERT_EQ(Call({"run", In("room"), "--mode", "inline", "--max-frames", "9", "--set", "features.wanted=400",
                  "levels=6", "--out", In("a")})
                .code,
            2);
  const Outcome first = Call({"run", In("room"), "--mode", "inline", "--max-frames", "9", "--set",
                              "features.wanted=400", "features.levels=6", "--out", In("a")});
  ASSERT_EQ(first.code, 0) << first.err;
  const Outcome again = Call({"run", In("room"), "--config", In("a/config.yaml"), "--out", In("b")});
  ASSERT_EQ(again.code, 0) << again.err;
  for (const char* file : {"trajectory.txt", "keyframes.txt", "config.yaml"}) {
    EXPECT_EQ(*ReadWholeText(In(std::string("a/") + file)), *ReadWholeText(In(std::string("b/") + file))) << file;
  }
}

TEST_F(Program, ASignalEndsTheRunWithEverythingWrittenInEachMode) {
  const std::pair<int, int> signals[] = {{SIGINT, 130}, {SIGTERM, 143}, {SIGHUP, 143}};
  int next = 0;
  for (const char* mode : {"inline", "offline", "live"}) {
    const auto [number, code] = signals[next++];
    const std::string out = In(std::string("stopped_") + mode);
    const pid_t child = Start({"run", In("long"), "--mode", mode, "--out", out});
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    ::kill(child, number);
    const Outcome outcome = WaitFor(child);
    EXPECT_EQ(outcome.code, code) << mode << ": " << outcome.err;
    const auto metrics = nlohmann::json::parse(*ReadWholeText(out + "/metrics.json"));
    EXPECT_EQ(Lines(*ReadWholeText(out + "/trajectory.txt")), metrics["tracked"].get<size_t>()) << mode;
    EXPECT_LT(metrics["frames"].get<size_t>(), 2400u) << mode;
  }
}

TEST_F(Program, ASignalWhileStartingIsHeededToo) {
  for (const int wait_ms : {0, 20, 60, 150}) {
    const pid_t child = Start({"run", In("long"), "--out", In("early")});
    std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms));
    ::kill(child, SIGINT);
    EXPECT_EQ(WaitFor(child).code, 130) << wait_ms << " ms";
  }
}

TEST_F(Program, RunKeepsItsInputsFromItsResults) {
  const std::string room = In("room"), out = In("kept"), mine = "features:\n  wanted: 400  # mine\n";
  std::filesystem::create_directory(out);
  for (const char* name : {"config.yaml", "log.txt"}) {
    ASSERT_TRUE(WriteFileWhole(out + "/" + name, name[0] == 'c' ? mine : "")) << name;
  }
  ExpectRefused("--config", {"run", room, "--config", out + "/config.yaml", "--out", out});
  ExpectRefused("--detections", {"run", room, "--detections", out + "/../kept/log.txt", "--out", out + "/"});
  EXPECT_EQ(*ReadWholeText(out + "/config.yaml"), mine);
  const std::string again = In("again_and_again");
  for (const char* config : {"/kept/config.yaml", "/again_and_again/config.yaml"}) {
    const Outcome outcome = Call({"run", room, "--config", Folder() + config, "--out", again, "--dynamics", "off"});
    EXPECT_EQ(outcome.code, 0) << "an older run's may be replaced: " << outcome.err;
  }
}

TEST_F(Program, SynthTakesAShortDistortionInPlaceOfAllOfTheCameras) {
  const Outcome outcome = Call({"synth", "xyz", "--out", In("flat"), "--frames", "1", "--width", "128", "--height",
                                "96", "--camera", "tum_fr1", "--distortion", "0,0,0,0"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(*ReadWholeText(In("flat/camera.yaml")), HasSubstr("distortion: []"));
}

TEST_F(Program, VocabulariesAreTrainedReadAndRefused) {
  const Outcome trained = Call({"vocab", "train", In("room"), "--out", In("own.yvoc"), "--levels", "2"});
  EXPECT_EQ(trained.code, 0) << trained.err;
  EXPECT_THAT(trained.out, AllOf(HasSubstr("12 pictures"), HasSubstr("own.yvoc")));
  const Outcome info = Call({"vocab", "info", In("own.yvoc"), "--json"});
  EXPECT_EQ(info.code, 0) << info.err;
  const auto json = nlohmann::json::parse(info.out);
  EXPECT_EQ(json["levels"], 2);
  EXPECT_GT(json["words"], 100);
  EXPECT_EQ(json["bytes"], std::filesystem::file_size(In("own.yvoc")));
  std::filesystem::resize_file(In("own.yvoc"), 5000);
  ExpectRefused("own.yvoc", {"vocab", "info", In("own.yvoc")});
  ExpectRefused("own.yvoc", {"run", In("room"), "--set", "places.vocabulary=" + In("own.yvoc"), "--out", In("no")});
  EXPECT_FALSE(std::filesystem::exists(In("no")));
  const std::string picture = In("picture.png");  // `--out pictures/*.png`, say
  ASSERT_TRUE(WriteFileWhole(picture, "a picture"));
  ExpectRefused("no vocabulary", {"vocab", "train", In("room"), "--out", picture});
  EXPECT_EQ(*ReadWholeText(picture), "a picture");
  ExpectRefused("--levels", {"vocab", "train", In("room"), "--out", In("a.yvoc"), "--levels", "0"});
  ExpectRefused("missing", {"vocab", "train", In("missing"), "--out", In("a.yvoc")});
  ExpectRefused("--out", {"vocab", "train", In("room"), "--out", "/dev/null/a.yvoc"});
  EXPECT_FALSE(std::filesystem::exists(In("a.yvoc")));
}

}  // namespace
}  // namespace yorb
