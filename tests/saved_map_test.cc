// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Maps from outside: saved, gone on with, located in, looked into, exported; what is refused and what is left alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include "core/text.h"
#include "evaluation/trajectory_io.h"
#include "pictures/picture_file.h"
#include "pictures/png.h"
#include "pictures/test_folder.h"
#include "tests/synthetic_dataset.h"

namespace yorb {
namespace {

using testing::HasSubstr;

struct Outcome {
  int code = -1;
  std::string out, err;
};

class Maps : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TestFolder;
    SyntheticDataset(16).WriteTo(folder_->Path() + "/room");
    const Outcome made = Call("run room --mode inline --save-map room.map --out made --quiet");
    ASSERT_EQ(made.code, 0) << made.err;
    ASSERT_EQ(made.out, "");
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }

  /// `arguments` as a shell has them, within the scratch folder.
  static Outcome Call(const std::string& arguments) {
    const std::string command =
        "cd '" + folder_->Path() + "' && '" YORB_PROGRAM "' " + arguments + " >out 2>err </dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, folder_->Read("out"), folder_->Read("err")};
  }

  static void ExpectRefused(const std::string& word, const std::string& arguments) {
    const Outcome outcome = Call(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(word));
  }

  static std::string Path(const std::string& name) { return folder_->Path() + "/" + name; }
  static std::string Bytes(const std::string& name) {
    std::ifstream file(Path(name), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  }
  static void Put(const std::string& name, const std::string& bytes) {
    std::ofstream(Path(name), std::ios::binary) << bytes;
  }
  static nlohmann::json Info(const std::string& map) {
    const Outcome info = Call("map info " + map + " --json");
    EXPECT_EQ(info.code, 0) << info.err;
    return nlohmann::json::parse(info.out, nullptr, false);
  }

  static TestFolder* folder_;
};
TestFolder* Maps::folder_ = nullptr;

TEST_F(Maps, InfoSaysWhatTheRunSays) {
  const nlohmann::json info = Info("room.map"), metrics = nlohmann::json::parse(Bytes("made/metrics.json"));
  EXPECT_EQ(info["keyframes"], metrics["keyframes"]);
  EXPECT_EQ(info["landmarks"], metrics["landmarks"]);
  EXPECT_EQ(info["submaps"], 1);
  EXPECT_EQ(info["bytes"], Bytes("room.map").size());
  EXPECT_THAT(Call("map info room.map").out, HasSubstr("keyframes"));
}

TEST_F(Maps, BrokenFilesAreRefusedByNameAndLeftAlone) {
  const std::string good = Bytes("room.map"), cut = good.substr(0, good.size() / 2);
  Put("cut.map", cut);
  Put("text.map", "1.5 0 0 0 0 0 0 1\n");
  std::string changed = good;
  changed[good.size() / 3] = static_cast<char>(changed[good.size() / 3] ^ 4);
  Put("changed.map", changed);
  for (const char* name : {"cut.map", "text.map", "changed.map", "missing.map", "room"}) {
    ExpectRefused(name, std::string("map info ") + name);
    ExpectRefused(name, std::string("map export ") + name + " --out broken.ply");
    ExpectRefused(name, std::string("run room --load-map ") + name + " --out broken");
  }
  ExpectRefused("cut.map", "run room --load-map cut.map --save-map cut.map --out broken");
  EXPECT_EQ(Bytes("cut.map"), cut);
  EXPECT_FALSE(std::filesystem::exists(Path("broken.ply")));
}

TEST_F(Maps, WrongCommandLinesAreRefusedByName) {
  ExpectRefused("needs a command", "map");
  ExpectRefused("--jsn", "map info room.map --jsn");
  ExpectRefused("--out", "map export room.map");
  ExpectRefused(".obj", "map export room.map --out x.obj");
  ExpectRefused("x.txt", "map export room.map --out x.txt --dense room");
  ExpectRefused("--cube", "map export room.map --out x.ply --dense room --cube 0");
  ExpectRefused("no_such", "map export room.map --out x.ply --dense no_such");
  ExpectRefused("room.map", "map export room.map --out room.map/x.ply");
  ExpectRefused("--load-map", "run room --localize-only --out broken");
  ExpectRefused("--load-map", "run room --load-map '' --out broken");
  ExpectRefused("--save-map", "run room --save-map '' --out broken");
  ExpectRefused("--save-map", "run room --load-map room.map --localize-only --save-map y.map --out broken");
  ExpectRefused("room/rgb.txt", "run room --save-map room/rgb.txt --out broken");
  EXPECT_FALSE(std::filesystem::exists(Path("broken")));
}

TEST_F(Maps, ARunThatGoesOnWithAMapIsRepeatedByItsConfigToTheBit) {
  const std::string before = Bytes("room.map");
  const Outcome first = Call("run room --mode inline --load-map room.map --save-map a.map --out a --quiet");
  ASSERT_EQ(first.code, 0) << first.err;
  ASSERT_EQ(Call("run room --config a/config.yaml --save-map b.map --out b --quiet").code, 0);
  for (const char* name : {"trajectory.txt", "keyframes.txt"}) {
    EXPECT_EQ(Bytes(std::string("a/") + name), Bytes(std::string("b/") + name)) << name;
  }
  EXPECT_EQ(Bytes("a.map"), Bytes("b.map"));
  EXPECT_EQ(Bytes("room.map"), before);
  EXPECT_GE(Info("a.map")["keyframes"], Info("room.map")["keyframes"]);
}

TEST_F(Maps, LocatingLeavesTheMapAlone) {
  const std::string before = Bytes("room.map");
  std::filesystem::permissions(Path("room.map"), std::filesystem::perms::owner_read);
  const auto written = std::filesystem::last_write_time(Path("room.map"));
  for (const char* mode : {"inline", "offline"}) {
    const Outcome run =
        Call(std::string("run room --load-map room.map --localize-only --quiet --out located --mode ") + mode);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_GE(nlohmann::json::parse(Bytes("located/metrics.json"))["tracked"], 15) << mode;
  }
  EXPECT_EQ(std::filesystem::last_write_time(Path("room.map")), written);
  EXPECT_EQ(Bytes("room.map"), before);
  std::filesystem::permissions(Path("room.map"), std::filesystem::perms::owner_all);
}

TEST_F(Maps, AnyFolderOfPicturesIsLocated) {
  std::filesystem::create_directories(Path("photos"));
  const size_t shown[] = {12, 3, 8};
  for (size_t i = 0; i < 3; ++i) {
    std::filesystem::copy_file(Path("room/rgb/" + std::to_string(shown[i]) + ".png"),
                               Path("photos/" + std::to_string(i) + ".png"));
  }
  const Outcome run = Call("run photos --camera room/camera.yaml --load-map room.map --localize-only --quiet --out l");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const auto located = ReadTrajectoryFile(Path("l/trajectory.txt")),
             made = ReadTrajectoryFile(Path("made/trajectory.txt"));
  ASSERT_TRUE(located && made);
  ASSERT_EQ(located->poses.size(), 3u);
  ASSERT_EQ(made->poses.size(), 16u);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(located->poses[i].timestamp.seconds(), static_cast<double>(i));
    const auto there = made->poses[shown[i]].world_from_cam.translation;
    EXPECT_LT((located->poses[i].world_from_cam.translation - there).norm(), 0.02);
  }
  ExpectRefused("holds neither", "run photos --camera room/camera.yaml --out broken");
}

TEST_F(Maps, TheCameraOfAMapIsTakenWhereNothingElseSaysWhich) {
  std::filesystem::create_directories(Path("shots"));
  std::filesystem::create_directories(Path("halves"));
  for (const char* name : {"3.png", "8.png"}) {
    std::filesystem::copy_file(Path(std::string("room/rgb/") + name), Path(std::string("shots/") + name));
    cv::Mat half;
    cv::resize(ReadPictureFile(Path(std::string("room/rgb/") + name)).pixels, half, {}, 0.5, 0.5);
    Put(std::string("halves/") + name, *EncodePng(half));
  }
  const std::string ways[] = {"", "--camera room/camera.yaml "};
  for (const std::string& way : ways) {
    const Outcome run = Call("run shots --load-map room.map --localize-only " + way + "--quiet --mode inline --out " +
                             (way.empty() ? "maps" : "given"));
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err, "");
  }
  EXPECT_EQ(Bytes("maps/trajectory.txt"), Bytes("given/trajectory.txt"));
  EXPECT_THAT(Bytes("maps/log.txt"), HasSubstr("of the map room.map"));
  // Other pictures may come from another camera; a run without a map has none to take.
  ExpectRefused("--camera", "run halves --load-map room.map --localize-only --out broken");
  ExpectRefused("no_such.map", "run shots --load-map no_such.map --localize-only --out broken");
  ExpectRefused("rgb.txt", "run shots --load-map room.map --out broken");
  EXPECT_FALSE(std::filesystem::exists(Path("broken")));
}

TEST_F(Maps, AreExportedWithTheCountsOfInfo) {
  const nlohmann::json info = Info("room.map");
  ASSERT_EQ(Call("map export room.map --out 'new place/x.ply' --quiet").code, 0);
  EXPECT_THAT(Bytes("new place/x.ply"), HasSubstr("element vertex " + info["landmarks"].dump() + "\n"));
  ASSERT_EQ(Call("map export room.map --out x.pcd").code, 0);
  EXPECT_THAT(Bytes("x.pcd"), HasSubstr("POINTS " + info["landmarks"].dump() + "\n"));
  ASSERT_EQ(Call("map export room.map --out x.txt").code, 0);
  EXPECT_EQ(Bytes("x.txt"), Bytes("made/keyframes.txt"));
  const Outcome dense = Call("map export room.map --out dense.ply --dense room --dynamics off --cube 0.02");
  ASSERT_EQ(dense.code, 0) << dense.err;
  EXPECT_THAT(dense.out, HasSubstr(info["keyframes"].dump() + " of " + info["keyframes"].dump()));
  EXPECT_THAT(Bytes("dense.ply"), HasSubstr("property uchar blue\n"));
  EXPECT_GT(Bytes("dense.ply").size(), 10000u);
}

}  // namespace
}  // namespace yorb
