// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/overlay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pictures/test_folder.h"
#include "runs/run.h"
#include "runs/test_dataset.h"

namespace yorb {
namespace {

std::vector<std::string> NamesIn(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  return names;
}

TEST(Overlay, TakesThePlaceOfAnOlderOneAndOfNothingElse) {
  const TestFolder folder;
  RunOptions options;
  options.config.mode = "inline";
  options.config.dynamics = "off";
  options.config.features.wanted = 300;
  options.out = folder.Path("out");
  options.overlay = folder.Path("overlay");
  ASSERT_TRUE(RunSequence(WallDataset(5), options, {}).ok());
  EXPECT_EQ(NamesIn(options.overlay).size(), 6u) << "five pictures and points.csv";
  folder.Write("overlay/mine.png", "somebody's");
  ASSERT_TRUE(RunSequence(WallDataset(2, 8), options, {}).ok());
  EXPECT_THAT(NamesIn(options.overlay),
              testing::UnorderedElementsAre("points.csv", "mine.png", "100.000000.png", "100.125000.png"));
  EXPECT_EQ(folder.Read("overlay/points.csv").find("100.033"), std::string::npos);
}

TEST(Overlay, ThatIsOpenedAndNeverBegunLeavesEverythingAsItWas) {
  const TestFolder folder;
  ASSERT_TRUE(OverlayWriter::Open(folder.Path("new")).ok());
  EXPECT_TRUE(std::filesystem::is_empty(folder.Path("new")));
  folder.Write("older/points.csv", "timestamp,x,y,level,verdict\n1.000000,2,3,0,static\n");
  folder.Write("older/1.000000.png", "a picture");
  ASSERT_TRUE(OverlayWriter::Open(folder.Path("older")).ok());
  EXPECT_EQ(NamesIn(folder.Path("older")).size(), 2u);
  EXPECT_THAT(folder.Read("older/points.csv"), testing::EndsWith("static\n"));
}

TEST(Overlay, IsRefusedAFolderWithSomethingElseInIt) {
  const TestFolder folder;
  folder.Write("photos/a.png", "a picture");
  folder.Write("recording/1.000000.jpg", "a picture");
  folder.Write("cloud/points.csv", "x,y,z\n1,2,3\n");
  for (const char* name : {"photos", "recording", "cloud"}) {
    const auto opened = OverlayWriter::Open(folder.Path(name));
    ASSERT_FALSE(opened.ok()) << name;
    EXPECT_THAT(opened.error().message, testing::HasSubstr(folder.Path(name) + " holds "));
  }
  EXPECT_EQ(folder.Read("cloud/points.csv"), "x,y,z\n1,2,3\n");
}

}  // namespace
}  // namespace yorb
