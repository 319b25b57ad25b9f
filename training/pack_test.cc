// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/pack.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/files.h"
#include "pictures/test_folder.h"
#include "training/test_shapes.h"

namespace yorb {
namespace {

TEST(Pack, GivesBackWhatWasPutIn) {
  const TestFolder folder;
  const std::string path = folder.Path("round.pack");
  std::vector<PackItem> items = MakeShapePictures(3, 1);
  items[1].judged.reset(5).reset(100);
  items[1].is_squashed = true;
  auto writer = PackWriter::Create(path, {"disc", "square"});
  ASSERT_TRUE(writer.ok());
  for (const PackItem& item : items) ASSERT_TRUE((*writer)->Add(item).ok());
  ASSERT_TRUE((*writer)->Finish().ok());
  const auto pack = Pack::Open(path);
  ASSERT_TRUE(pack.ok()) << pack.error().message;
  ASSERT_EQ((*pack)->size(), 3u);
  EXPECT_EQ((*pack)->class_names(), (std::vector<std::string>{"disc", "square"}));
  for (size_t i = 0; i < 3; ++i) {
    const PackedPicture picture = (*pack)->Get(i);
    EXPECT_EQ(cv::norm(picture.pixels, items[i].pixels, cv::NORM_INF), 0);
    ASSERT_EQ(picture.boxes.size(), items[i].boxes.size());
    EXPECT_EQ(picture.boxes[0].cx, items[i].boxes[0].cx);
    EXPECT_EQ(picture.judged, items[i].judged);
    EXPECT_EQ(picture.is_squashed, items[i].is_squashed);
  }
}

TEST(Pack, AnUnfinishedOrCutOrForeignFileIsRefused) {
  const TestFolder folder;
  const std::string path = folder.Path("cut.pack");
  {
    auto writer = PackWriter::Create(path, {"disc"});
    ASSERT_TRUE(writer.ok());
    ASSERT_TRUE((*writer)->Add(MakeShapePictures(1, 1)[0]).ok());
  }
  EXPECT_FALSE(Pack::Open(path).ok());
  ASSERT_NE(MakeShapePack(path, 4, 1), nullptr);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 10);
  EXPECT_FALSE(Pack::Open(path).ok());
  ASSERT_TRUE(WriteFileWhole(path, "no pack").ok());
  EXPECT_FALSE(Pack::Open(path).ok());
  EXPECT_FALSE(Pack::Open(path + ".none").ok());
}

}  // namespace
}  // namespace yorb
