// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/head_layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace yorb {
namespace {

using Shapes = std::vector<std::vector<int64_t>>;

HeadFacts Facts(const Shapes& shapes, int num_names, int width = 64, int height = 64) {
  HeadFacts facts;
  facts.shapes = shapes, facts.width = width, facts.height = height, facts.num_names = num_names;
  return facts;
}

void ExpectLayout(const HeadFacts& facts, LayoutKind kind, int num_classes) {
  const auto layout = RecogniseLayout(facts);
  ASSERT_TRUE(layout) << layout.error().message;
  EXPECT_EQ(layout->kind, kind) << LayoutText(*layout, facts);
  EXPECT_EQ(layout->num_classes, num_classes);
}

TEST(HeadLayout, YoloFiveAndEightAreToldByTheNumberOfCells) {
  ExpectLayout(Facts({{1, 252, 85}}, 80), LayoutKind::kAnchorRows, 80);
  ExpectLayout(Facts({{1, 84, 84}}, 0), LayoutKind::kCentreColumns, 80);
  ExpectLayout(Facts({{1, 25200, 85}}, 0, 640, 640), LayoutKind::kAnchorRows, 80);
  ExpectLayout(Facts({{1, 84, 8400}}, 0, 640, 640), LayoutKind::kCentreColumns, 80);
  ExpectLayout(Facts({{1, 35, 1680}}, 31, 320, 256), LayoutKind::kCentreColumns, 31);
  ExpectLayout(Facts({{1, 25500, 85}}, 80, 640, 640), LayoutKind::kAnchorRows, 80);  // four strides, 8 to 64
  ExpectLayout(Facts({{1, 6000, 85}}, 80, 640, 640), LayoutKind::kAnchorRows, 80);   // two, 16 and 32
}

TEST(HeadLayout, SixColumnsAreOneClassOrEndToEnd) {
  ExpectLayout(Facts({{1, 252, 6}}, 1), LayoutKind::kAnchorRows, 1);
  ExpectLayout(Facts({{1, 252, 6}}, 0), LayoutKind::kAnchorRows, 1);
  ExpectLayout(Facts({{1, 252, 6}}, 10), LayoutKind::kCornerRows, 10);
  ExpectLayout(Facts({{1, 300, 6}}, 10), LayoutKind::kCornerRows, 10);
  ExpectLayout(Facts({{1, 300, 6}}, 0), LayoutKind::kCornerRows, 0);
  ExpectLayout(Facts({{1, 84, 6}}, 10), LayoutKind::kCornerRows, 10);
  for (const int num_names : {0, 1, 2}) {
    EXPECT_FALSE(RecogniseLayout(Facts({{1, 84, 6}}, num_names))) << "a row a cell: YOLOv6's, or YOLOv8's turned round";
  }
  for (const int num_names : {0, 1}) {
    ExpectLayout(Facts({{1, 60, 6}}, num_names), LayoutKind::kAnchorRows, 1);  // YOLOv3-tiny has two strides
  }
  ExpectLayout(Facts({{1, 60, 6}}, 10), LayoutKind::kCornerRows, 10);
  ExpectLayout(Facts({{1, 5, 84}}, 1), LayoutKind::kCentreColumns, 1);
  ExpectLayout(Facts({{1, 6, 84}}, 2), LayoutKind::kCentreColumns, 2);
}

TEST(HeadLayout, RowsOfAllCellsWithObjectnessAreToldByTheNumberOfClasses) {
  ExpectLayout(Facts({{1, 8400, 85}}, 0, 640, 640), LayoutKind::kCellRows, 80);
  ExpectLayout(Facts({{1, 8400, 8}}, 3, 640, 640), LayoutKind::kCellRows, 3);
  ExpectLayout(Facts({{1, 84, 85}}, 80), LayoutKind::kCellRows, 80);  // 85 are cells, too, of four strides
  ExpectLayout(Facts({{1, 84, 85}}, 0), LayoutKind::kCellRows, 80);
  ExpectLayout(Facts({{1, 84, 84}}, 79), LayoutKind::kCellRows, 79);
  EXPECT_FALSE(RecogniseLayout(Facts({{1, 8400, 8}}, 0, 640, 640))) << "three classes, or YOLOv8's four";
  const auto cells = CellsOfRows(252, Facts({}, 0));
  ASSERT_EQ(cells.size(), 252u);
  EXPECT_EQ(cells[65].column, 1);  // the second anchor's
  EXPECT_EQ(cells[200].stride, 16);
  EXPECT_TRUE(CellsOfRows(253, Facts({}, 0)).empty());
}

TEST(HeadLayout, BoxesApartAreFoundBesideTheirScores) {
  ExpectLayout(Facts({{1, 84, 4}, {1, 84, 80}}, 0), LayoutKind::kBoxesApart, 80);
  ExpectLayout(Facts({{1, 3, 84}, {1, 4, 84}}, 3), LayoutKind::kBoxesApart, 3);
  EXPECT_FALSE(RecogniseLayout(Facts({{1, 300, 4}, {1, 300, 80}}, 80))) << "no cells: RT-DETR's, fractions";
  ExpectLayout(Facts({{1, 84, 4}, {1, 84, 7}}, 0), LayoutKind::kBoxesApart, 7);
  EXPECT_FALSE(RecogniseLayout(Facts({{1, 84, 4}, {1, 84, 1}, {1, 84, 7}}, 7))) << "objectness stands apart, too";
  EXPECT_FALSE(RecogniseLayout(Facts({{1, 84, 4}, {1, 84, 7}}, 8)));
}

TEST(HeadLayout, RawMapsMayStandInAnyOrderAndHaveAnAxisForTheAnchors) {
  ExpectLayout(Facts({{1, 21, 2, 2}, {1, 21, 8, 8}, {1, 21, 4, 4}}, 2), LayoutKind::kRawMaps, 2);
  ExpectLayout(Facts({{1, 3, 8, 8, 7}, {1, 3, 4, 4, 7}, {1, 3, 2, 2, 7}}, 2), LayoutKind::kRawMaps, 2);
  ExpectLayout(Facts({{1, 3, 7, 8, 8}, {1, 3, 7, 4, 4}, {1, 3, 7, 2, 2}}, 2), LayoutKind::kRawMaps, 2);
  ExpectLayout(Facts({{1, 3, 8, 8, 8}, {1, 3, 8, 4, 4}, {1, 3, 8, 2, 2}}, 3), LayoutKind::kRawMaps, 3);
  const auto layout = RecogniseLayout(Facts({{1, 21, 1, 2}, {1, 21, 4, 8}, {1, 21, 2, 4}}, 0, 64, 32));
  ASSERT_TRUE(layout) << layout.error().message;
  EXPECT_EQ(layout->maps[0].output, 1u);
  EXPECT_EQ(layout->maps[0].stride, 8);
  EXPECT_EQ(layout->maps[2].output, 0u);
}

TEST(HeadLayout, OutputsBesideTheBoxesAreLeftAlone) {
  ExpectLayout(Facts({{1, 38, 84}, {1, 32, 16, 16}}, 2), LayoutKind::kCentreColumns, 2);  // segmentation
  ExpectLayout(Facts({{1, 252, 39}, {1, 32, 16, 16}}, 0), LayoutKind::kAnchorRows, 2);
  ExpectLayout(Facts({{1, 252, 7}, {1, 3, 8, 8, 7}, {1, 3, 4, 4, 7}, {1, 3, 2, 2, 7}}, 2), LayoutKind::kAnchorRows, 2);
  HeadFacts pose = Facts({{1, 56, 84}}, 1);
  pose.num_keypoint_values = 51;
  ExpectLayout(pose, LayoutKind::kCentreColumns, 1);
}

TEST(HeadLayout, RowsOfCellsAreYoloEightsTurnedRoundWhereNamesSaySo) {
  ExpectLayout(Facts({{1, 84, 7}}, 3), LayoutKind::kCentreRows, 3);
  ExpectLayout(Facts({{1, 8400, 84}}, 80, 640, 640), LayoutKind::kCentreRows, 80);
  ExpectLayout(Facts({{1, 84, 5}}, 1), LayoutKind::kCentreRows, 1);
  ExpectLayout(Facts({{1, 84, 39}, {1, 32, 16, 16}}, 3), LayoutKind::kCentreRows, 3);
  EXPECT_FALSE(RecogniseLayout(Facts({{1, 84, 7}}, 0))) << "YOLOX has a row a cell, and objectness";
  ExpectLayout(Facts({{1, 84, 7}}, 2), LayoutKind::kCellRows, 2);
  EXPECT_FALSE(RecogniseLayout(Facts({{1, 300, 7}}, 3))) << "no row a cell";
}

TEST(HeadLayout, EndToEndRowsMayHaveMasksAndPointsBehindThem) {
  ExpectLayout(Facts({{1, 300, 38}, {1, 32, 16, 16}}, 2), LayoutKind::kCornerRows, 2);
  HeadFacts pose = Facts({{1, 300, 57}}, 1);
  EXPECT_FALSE(RecogniseLayout(pose)) << "nothing says what the 51 numbers are";
  pose.num_keypoint_values = 51;
  ExpectLayout(pose, LayoutKind::kCornerRows, 1);
  EXPECT_FALSE(RecogniseLayout(Facts({{1, 84, 38}, {1, 32, 16, 16}}, 2))) << "or YOLOv8's turned round";
}

TEST(HeadLayout, ScoresWhoseBoxesStandApartAreNoBoxes) {
  for (const Shapes& shapes : {Shapes{{1, 84, 4}, {1, 84, 7}}, Shapes{{1, 84, 6}, {1, 84, 1, 4}},
                               Shapes{{1, 4, 84}, {1, 10, 84}}, Shapes{{1, 300, 6}, {1, 300, 4}}}) {
    const auto layout = RecogniseLayout(Facts(shapes, 6));
    ASSERT_FALSE(layout) << ShapeText(shapes[0]);
    EXPECT_THAT(layout.error().message, testing::HasSubstr("boxes and scores stand apart"));
  }
}

TEST(HeadLayout, MapsWithoutNamesThatMayBeYoloEightsAreRefused) {
  const auto maps = [](int64_t size) { return Shapes{{1, size, 8, 8}, {1, size, 4, 4}, {1, size, 2, 2}}; };
  const auto joined = [&](int64_t size, int num_names) {
    HeadFacts facts = Facts(maps(size), num_names);
    facts.are_joined = true;
    return facts;
  };
  for (const int64_t size : {66, 69, 144}) {
    const auto layout = RecogniseLayout(joined(size, 0));
    ASSERT_FALSE(layout) << size;
    EXPECT_THAT(layout.error().message, testing::HasSubstr(".names"));
  }
  ExpectLayout(joined(66, 17), LayoutKind::kRawMaps, 17);
  ExpectLayout(joined(60, 0), LayoutKind::kRawMaps, 15);
  ExpectLayout(Facts(maps(75), 0), LayoutKind::kRawMaps, 20);
  ExpectLayout(Facts(maps(255), 0), LayoutKind::kRawMaps, 80);
  ExpectLayout(Facts(maps(66), 2), LayoutKind::kEdgeMaps, 2);
  EXPECT_FALSE(RecogniseLayout(Facts(maps(66), 3)));
}

TEST(HeadLayout, AllElseIsRefusedWithItsShapes) {
  const std::vector<std::pair<Shapes, int>> others{
      {{{1, 1, 3}}, 3},                                    // a classifier
      {{{1, 1, 64, 64}}, 0},                               // a depth map
      {{{5, 3}}, 2},                                       // what NonMaxSuppression gives
      {{{1, 7, 84}}, 2},                                   // rotated boxes
      {{{1, 84, 84}}, 3},                                  // 80 classes, 3 names
      {{{1, 84, 8}}, 2},                                   // one row a cell, of another number of classes
      {{{1, 21, 8, 8}, {1, 21, 4, 4}}, 2},                 // two maps
      {{{1, 21, 8, 8}, {1, 21, 4, 4}, {1, 24, 2, 2}}, 0},  // maps that disagree
      {{}, 0},
  };
  for (const auto& [shapes, num_names] : others) {
    const auto layout = RecogniseLayout(Facts(shapes, num_names));
    EXPECT_FALSE(layout) << (shapes.empty() ? "" : ShapeText(shapes[0]));
    if (layout || shapes.empty()) continue;
    EXPECT_THAT(layout.error().message, testing::HasSubstr(ShapeText(shapes[0])));
  }
}

TEST(HeadLayout, WhatANetworkSaysThatItIsForIsToldWhereItIsRefused) {
  HeadFacts facts = Facts({{1, 7, 84}}, 2);
  facts.task = "obb";
  EXPECT_THAT(RecogniseLayout(facts).error().message, testing::HasSubstr("'obb'"));
  facts.task = "detect";
  EXPECT_THAT(RecogniseLayout(facts).error().message, testing::HasSubstr("no detector that is read: its outputs"));
}

TEST(HeadLayout, AListOfNamesThatDoesNotFitIsNamedWithItsNumber) {
  HeadFacts facts = Facts({{1, 6, 84}}, 1);
  EXPECT_THAT(RecogniseLayout(facts).error().message, testing::HasSubstr("64x64 and 1 class name;"));
  facts.names_file = "a/net.names";
  EXPECT_THAT(RecogniseLayout(facts).error().message,
              testing::AllOf(testing::HasSubstr("does not fit a/net.names, which has 1 class name:"),
                             testing::HasSubstr("(1, 6, 84)"), testing::HasSubstr("2 classes")));
  facts.num_names = 3;
  EXPECT_THAT(RecogniseLayout(facts).error().message, testing::HasSubstr("3 class names"));
  facts.shapes = {{1, 1000}};
  EXPECT_THAT(RecogniseLayout(facts).error().message,
              testing::AllOf(testing::HasSubstr("no detector"), testing::HasSubstr("3 class names in a/net.names")));
}

}  // namespace
}  // namespace yorb
