// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/map_export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "core/text.h"
#include "map/test_map.h"

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
  const Map map = LivedInMap(3, 12);
  const auto roots = RootsBySize(map);
  ASSERT_GT(roots.size(), 1u);
  EXPECT_EQ(roots[0], KeyframeId(0));
  const auto clouds = ExportedFiles(map, "out/x.ply", MapExport::kPly);
  ASSERT_EQ(clouds.size(), roots.size());
  EXPECT_EQ(clouds[0].path, "out/x.ply");
  EXPECT_EQ(clouds[1].path, "out/x_2.ply");
  size_t num_points = 0, num_poses = 0;
  for (const FileToWrite& file : clouds) {
    num_points += (file.content.size() - file.content.find("end_header\n") - 11) / 12;
  }
  EXPECT_EQ(num_points, map.num_landmarks());
  for (const FileToWrite& file : ExportedFiles(map, "x.txt", MapExport::kKeyframes)) {
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

}  // namespace
}  // namespace yorb
