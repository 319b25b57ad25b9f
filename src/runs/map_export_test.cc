// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/map_export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/text.h"
#include "map/test_map.h"
#include "runs/dense_cloud.h"
#include "runs/map_to_cloud.h"
#include "runs/test_dataset.h"

namespace yorb {
namespace {

using testing::HasSubstr;

PointCloud SmallCloud() {
  PointCloud cloud;
  cloud.points = {{1, -2, 3.5}, {1e300, 0, -0.25}};
  return cloud;
}

/// The n-th float of the data, which begin right after `mark`.
float FloatAfter(const std::string& bytes, const std::string& mark, size_t offset) {
  float value = 0;
  std::memcpy(&value, bytes.data() + bytes.find(mark) + mark.size() + offset, sizeof(value));
  return value;
}

TEST(PointCloud, PlyHasExactlyWhatItsHeaderSays) {
  PointCloud cloud = SmallCloud();
  const std::string plain = PlyBytes(cloud), mark = "end_header\n";
  EXPECT_EQ(plain.substr(0, 40), "ply\nformat binary_little_endian 1.0\ncomm");
  EXPECT_THAT(plain,
              HasSubstr("\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n"));
  EXPECT_EQ(plain.size(), plain.find(mark) + mark.size() + 2 * 12);
  EXPECT_EQ(FloatAfter(plain, mark, 8), 3.5f);
  EXPECT_TRUE(std::isfinite(FloatAfter(plain, mark, 12))) << "what a float cannot hold is not infinite";
  cloud.colours = {{1, 2, 3}, {250, 251, 252}};
  const std::string coloured = PlyBytes(cloud);
  EXPECT_THAT(coloured, HasSubstr("property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n"));
  EXPECT_EQ(coloured.size(), coloured.find(mark) + mark.size() + 2 * 15);
  EXPECT_EQ(static_cast<uint8_t>(coloured.back()), 252);
}

TEST(PointCloud, PcdHasExactlyWhatItsHeaderSays) {
  PointCloud cloud = SmallCloud();
  const std::string plain = PcdBytes(cloud), mark = "DATA binary\n";
  EXPECT_THAT(plain, HasSubstr("\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 1\n"));
  EXPECT_THAT(plain, HasSubstr("\nPOINTS 2\nDATA binary\n"));
  EXPECT_EQ(plain.size(), plain.find(mark) + mark.size() + 2 * 12);
  EXPECT_EQ(FloatAfter(plain, mark, 4), -2.f);
  cloud.colours = {{1, 2, 3}, {250, 251, 252}};
  const std::string coloured = PcdBytes(cloud);
  EXPECT_THAT(coloured, HasSubstr("FIELDS x y z rgb\n"));
  EXPECT_EQ(coloured.size(), coloured.find(mark) + mark.size() + 2 * 16);
  EXPECT_EQ(coloured.substr(coloured.size() - 4), (std::string{'\xfc', '\xfb', '\xfa', '\0'}));
}

TEST(MapExport, TheEndingSaysWhat) {
  EXPECT_EQ(*MapExportOf("a/b.ply"), MapExport::kPly);
  EXPECT_EQ(*MapExportOf("B.PCD"), MapExport::kPcd);
  EXPECT_EQ(*MapExportOf("x.y.txt"), MapExport::kKeyframes);
  EXPECT_THAT(MapExportOf("a.obj").error().message, HasSubstr(".obj"));
  EXPECT_THAT(MapExportOf("a.ply/b").error().message, HasSubstr("no ending"));
}

TEST(MapExport, EachSubmapHasAFileAndTogetherTheyHaveAll) {
  const SavedMap saved{LivedInMap(3, 12), {}, 0};
  const Map& map = saved.map;
  const auto roots = RootsInOrder(saved);
  ASSERT_GT(roots.size(), 1u);
  EXPECT_EQ(roots[0], KeyframeId(0));
  const auto clouds = ExportedFiles(saved, "out/x.ply", MapExport::kPly);
  ASSERT_EQ(clouds.size(), roots.size());
  EXPECT_EQ(clouds[0].path, "out/x.ply");
  EXPECT_EQ(clouds[1].path, "out/x_2.ply");
  size_t num_points = 0, num_poses = 0;
  for (const FileToWrite& file : clouds) {
    num_points += (file.content.size() - file.content.find("end_header\n") - 11) / 12;
  }
  EXPECT_EQ(num_points, map.num_landmarks());
  for (const FileToWrite& file : ExportedFiles(saved, "x.txt", MapExport::kKeyframes)) {
    Timestamp last{-1};
    for (const std::string_view line : SplitAt(file.content, '\n')) {
      if (line.empty() || line[0] == '#') continue;
      const auto time = ParseTimestamp(SplitAtBlanks(line)[0]);
      ASSERT_TRUE(time.has_value());
      EXPECT_GT(*time, last);
      last = *time;
      ++num_poses;
    }
  }
  EXPECT_EQ(num_poses, map.num_keyframes());
}

TEST(MapInfo, IsJsonWithNullWhereNothingIsKnown) {
  SavedMap saved{LivedInMap(2, 5), {}, 77};
  const auto json = nlohmann::json::parse(MapInfoJson(saved));
  EXPECT_EQ(json["version"], kMapFileVersion);
  EXPECT_EQ(json["keyframes"], saved.map.num_keyframes());
  EXPECT_EQ(json["landmarks"], saved.map.num_landmarks());
  EXPECT_EQ(json["submaps"], 2u);
  EXPECT_EQ(json["loops"], 1u);
  EXPECT_EQ(json["camera"], "synthetic");
  EXPECT_TRUE(json["vocabulary"].is_null());
  EXPECT_EQ(json["bytes"], 77);
  EXPECT_THAT(MapInfoText("a.map", saved), HasSubstr("a.map: a map of version 1\n"));
}

TEST(MapExport, KeepsTheOrderOfTheRunThatWroteTheMap) {
  const std::string path = testing::TempDir() + "order_" + std::to_string(::getpid()) + ".map";
  const Map map = *MapAssembly::Make(SyntheticMapParts(3, 4));
  const std::vector<KeyframeId> order = {KeyframeId(8), KeyframeId(0), KeyframeId(4)};
  ASSERT_TRUE(WriteMapFile(path, map, {"", order}).ok());
  const SavedMap saved = *ReadMapFile(path);
  EXPECT_EQ(RootsInOrder(saved), order);
  EXPECT_THAT(ExportedFiles(saved, "x.txt", MapExport::kKeyframes)[0].content, HasSubstr("0.800000 "));
  for (const uint32_t wrong : {0u, 5u, 99u}) {  // twice, no root, not there
    ASSERT_TRUE(WriteMapFile(path, map, {"", {KeyframeId(8), KeyframeId(0), KeyframeId(wrong)}}).ok());
    EXPECT_FALSE(ReadMapFile(path).ok()) << wrong;
  }
  ASSERT_TRUE(WriteMapFile(path, map, {"", {KeyframeId(8), KeyframeId(0)}}).ok());
  EXPECT_FALSE(ReadMapFile(path).ok()) << "one is missing";
  std::filesystem::remove(path);
}

/// Maps in files, and what is exported of them, in a folder of their own.
class ExportedMaps : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = testing::TempDir() + "exported_maps_" + std::to_string(::getpid()) + "/";
    std::filesystem::create_directories(folder_);
    ASSERT_TRUE(WriteMapFile(In("three.map"), *MapAssembly::Make(SyntheticMapParts(3, 4)), {}).ok());
    ASSERT_TRUE(WriteMapFile(In("one.map"), *MapAssembly::Make(SyntheticMapParts(1, 4)), {}).ok());
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string In(const std::string& name) const { return folder_ + name; }
  bool Has(const std::string& name) const { return std::filesystem::exists(In(name)); }
  std::vector<std::string> Lines(const std::string& map, const std::string& out) const {
    const auto report = ExportMap(In(map), In(out), {}, {});
    EXPECT_TRUE(report.ok()) << report.error().message;
    return report ? report->lines : std::vector<std::string>();
  }

  std::string folder_;
};

TEST_F(ExportedMaps, SayOfEachFileWhatItHas) {
  using testing::AllOf;
  EXPECT_THAT(Lines("three.map", "x.txt"),
              testing::ElementsAre(AllOf(HasSubstr("x.txt: 4 keyframes, "), HasSubstr("from 0.000000 to 0.300000 s")),
                                   AllOf(HasSubstr("x_2.txt: 4 keyframes, "), HasSubstr("from 0.400000 to 0.700000 s")),
                                   AllOf(HasSubstr("x_3.txt: 4 keyframes, "), HasSubstr("from 0.800000 to 1.100000 s")),
                                   HasSubstr("3 sub-maps")));
  const SavedMap one = *ReadMapFile(In("one.map"));
  EXPECT_THAT(Lines("one.map", "y.ply"),
              testing::ElementsAre(HasSubstr(std::to_string(one.map.num_landmarks()) + " landmarks")));
}

TEST_F(ExportedMaps, TellOfAnOlderExportBesideThem) {
  Lines("three.map", "x.ply");
  Lines("three.map", "x.pcd");
  ASSERT_TRUE(Has("x_2.ply") && Has("x_3.ply"));
  ASSERT_TRUE(WriteFileWhole(In("x_5.ply"), "far away").ok());
  const std::vector<std::string> lines = Lines("one.map", "x.ply");
  EXPECT_THAT(lines, testing::Contains(In("x_2.ply") + " was there before: it is no part of this map"));
  EXPECT_TRUE(Has("x_2.ply") && Has("x_3.ply")) << "they may be somebody's own";
  EXPECT_TRUE(Has("x.ply") && Has("x_5.ply") && Has("x_2.pcd") && Has("x_3.pcd"));
  std::filesystem::create_directories(In("x_2.txt"));
  Lines("one.map", "x.txt");
  EXPECT_TRUE(Has("x_2.txt")) << "a folder is no export";
}

TEST_F(ExportedMaps, NeverTakeThePlaceOfTheMap) {
  for (const char* map : {"own.ply", "own_3.ply"}) {  // the first of the three files, and the last
    std::filesystem::copy_file(In("three.map"), In(map));
    const auto refused = ExportMap(In(map), folder_ + "./own.ply", {}, {});
    ASSERT_FALSE(refused.ok()) << map;
    EXPECT_THAT(refused.error().message, HasSubstr("overwrite the map " + In(map)));
    EXPECT_TRUE(ReadMapFile(In(map)).ok());
    std::filesystem::remove(In(map));
  }
}

TEST_F(ExportedMaps, AreRefusedWithOptionsThatOnlyDenseCloudsHave) {
  DenseRequest request;
  request.named_option = "--masks";
  const auto refused = ExportMap(In("one.map"), In("x.ply"), request, {});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().kind, Error::Kind::kBadInput);
  EXPECT_THAT(refused.error().message, testing::AllOf(HasSubstr("--masks"), HasSubstr("--dense")));
  EXPECT_FALSE(Has("x.ply"));
}

/// Adds a keyframe of the wall's first moment with points in the left half of its picture. A lens has moved the ideal
/// ones into the right half.
void AddWithDepth(Map& map, const WallDataset& wall, size_t num_points, float metres) {
  auto frame = std::make_shared<Frame>();
  frame->id = FrameId(map.next_keyframe().value());
  frame->timestamp = wall.TimeOf(0);
  frame->rig = std::make_shared<const Rig>(wall.rig());
  for (size_t i = 0; i < num_points; ++i) {
    frame->keypoints.push_back({5 + 5 * static_cast<float>(i), 100, 0, 0, 0});
    frame->points_px.emplace_back(300.f, 100.f);
    frame->depth.push_back(metres);
  }
  map.AddKeyframe(frame, Rigid3::Identity(), map.newest_keyframe());
}

TEST(DenseExport, LeavesKeyframesOfOtherPicturesOut) {
  WallDataset wall(1);
  wall.left_mm = 3000;
  Map map;
  AddWithDepth(map, wall, 20, 3.2f);
  AddWithDepth(map, wall, 20, 2.f);
  AddWithDepth(map, wall, 20, 3.5f);
  const auto made = MakeDenseClouds(map, {KeyframeId(0)}, wall, {}, {});
  ASSERT_TRUE(made.ok()) << made.error().message;
  EXPECT_EQ(made->num_keyframes, 1u);
  EXPECT_EQ(made->num_of_others, 2u);

  AddWithDepth(map, wall, 19, 2.f);
  EXPECT_EQ(MakeDenseClouds(map, {KeyframeId(0)}, wall, {}, {})->num_keyframes, 2u) << "too few to tell";
  wall.left_mm = 0;
  EXPECT_EQ(MakeDenseClouds(map, {KeyframeId(0)}, wall, {}, {})->num_keyframes, 4u) << "a hole tells nothing";
}

TEST(DenseExport, IsRefusedWhereAllKeyframesAreOfOtherPictures) {
  const WallDataset wall(1);
  Map map;
  AddWithDepth(map, wall, 30, 1.f);
  const auto refused = MakeDenseClouds(map, {KeyframeId(0)}, wall, {}, {});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().kind, Error::Kind::kBadInput);
}

}  // namespace
}  // namespace yorb
