// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/trajectory_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "evaluation/test_trajectories.h"

namespace yorb {
namespace {

using ::testing::HasSubstr;

const char* const kPlain =
    "1305031102.175304 1.5 -2.25 3.125 0 0 0.6 0.8\n"
    "1305031102.211214 1.5 -2.25 3.25 0 0 0 1\n"
    "1305031102.243211 1.75 -2.25 3.25 1 0 0 0\n";

void ExpectPlain(const Result<ReadTrajectory>& read) {
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->poses.size(), 3u);
  EXPECT_EQ(read->poses[0].timestamp.ns, 1305031102175304000);
  EXPECT_EQ(read->poses[2].timestamp.ns, 1305031102243211000);
  EXPECT_EQ(read->poses[0].world_from_cam.translation, Eigen::Vector3d(1.5, -2.25, 3.125));
  EXPECT_NEAR(read->poses[0].world_from_cam.rotation.w(), 0.8, 1e-12);
  EXPECT_NEAR(read->poses[0].world_from_cam.rotation.z(), 0.6, 1e-12);
  EXPECT_NEAR(read->poses[2].world_from_cam.rotation.x(), 1, 1e-12);
  EXPECT_TRUE(read->warnings.empty());
}

/// The complaint about a file with this text.
std::string Refusal(const std::string& text, TrajectoryFormat format = TrajectoryFormat::kAuto) {
  const auto read = ReadTrajectoryFile(TestFile("bad.txt", text), format);
  if (read) return "not refused";
  EXPECT_EQ(read.error().kind, Error::Kind::kBadInput);
  EXPECT_THAT(read.error().message, HasSubstr("bad.txt"));
  return read.error().message;
}

TEST(TrajectoryIo, AllFormsOfTextReadAlike) {
  const std::string forms[] = {
      kPlain,
      "\xef\xbb\xbf# timestamp tx ty tz qx qy qz qw\r\n\r\n1305031102.175304\t1.5 -2.25\t3.125 0 0 0.6 0.8 \r\n"
      "  1305031102.211214 1.5 -2.25 3.25 0 0 0 1\r\n# a note\r\n1305031102.243211 1.75 -2.25 3.25 1 0 0 0",
      "1.305031102175304e9 +1.5 -225e-2 3.125 0 0 0.06e1 0.8\n1305031102.211214 1.5 -2.25 3.25 0 0 0 1\n"
      "1305031102243211E-6 1.75 -2.25 3.25 1 0 0 0\n",
      "1305031102.175304,1.5,-2.25,3.125,0,0,0.6,0.8\n1305031102.211214, 1.5, -2.25, 3.25, 0, 0, 0, 1\n"
      "1305031102.243211,1.75,-2.25,3.25,1,0,0,0,\n",
      "timestamp,tx,ty,tz,qx,qy,qz,qw\n1305031102.175304,1.5,-2.25,3.125,0,0,0.6,0.8\n"
      "1305031102.211214,1.5,-2.25,3.25,0,0,0,1\n1305031102.243211,1.75,-2.25,3.25,1,0,0,0\n",
      "1305031102.175304 1.5 -2.25 3.125 0 0 6 8\n1305031102.211214 1.5 -2.25 3.25 0 0 0 1\n"
      "1305031102.243211 1.75 -2.25 3.25 1 0 0 0\n"};
  for (const std::string& form : forms) ExpectPlain(ReadTrajectoryFile(TestFile("form.txt", form)));
}

TEST(TrajectoryIo, HeadersSayTheOrderAndTheUnit) {
  ExpectPlain(ReadTrajectoryFile(
      TestFile("a.csv",
               "time [ns], qw, qx, qy, qz, x, y, z\n1305031102175304000,.8,0,0,.6,1.5,-2.25,3.125\n"
               "1305031102211214000,1,0,0,0,1.5,-2.25,3.25\n1305031102243211000,0,1,0,0,1.75,-2.25,3.25\n")));
  ExpectPlain(ReadTrajectoryFile(
      TestFile("b.txt",
               "# stamp qw qx qy qz tx ty tz\n1305031102.175304 .8 0 0 .6 1.5 -2.25 3.125\n"
               "1305031102.211214 1 0 0 0 1.5 -2.25 3.25\n1305031102.243211 0 1 0 0 1.75 -2.25 3.25\n")));
}

TEST(TrajectoryIo, StampsInTwoColumnsAreRefusedAndNotCutToSeconds) {
  for (const char* header : {"secs,nsecs,x,y,z,qx,qy,qz,qw", "sec,nanosec,x,y,z,qx,qy,qz,qw"}) {
    const std::string rows = "\n1305031102,175304000,0,0,0,0,0,0,1\n1305031102,211214000,1,0,0,0,0,0,1\n";
    EXPECT_THAT(Refusal(header + rows), HasSubstr("line 1: neither numbers nor a header")) << header;
  }
}

const std::string kEurocHeader =
    "#timestamp, p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], q_RS_z [], v_RS_R_x [m "
    "s^-1]\n";
const std::string kEurocRows =
    "1305031102175304000,1.5,-2.25,3.125,.8,0,0,.6,9\n1305031102211214000,1.5,-2.25,3.25,1,0,0,0,9\n"
    "1305031102243211000,1.75,-2.25,3.25,0,1,0,0,9\n";

TEST(TrajectoryIo, EurocByItsHeaderOrByName) {
  auto by_header = ReadTrajectoryFile(TestFile("a.csv", kEurocHeader + kEurocRows));
  ASSERT_TRUE(by_header) << by_header.error().message;
  EXPECT_EQ(by_header->warnings.size(), 1u) << "the header names no unit: said once";
  by_header->warnings.clear();
  ExpectPlain(by_header);
  ExpectPlain(ReadTrajectoryFile(TestFile("b.csv", kEurocRows), TrajectoryFormat::kEuroc));
  EXPECT_THAT(Refusal(kEurocRows), HasSubstr("--format euroc"));
  const auto seconds = ReadTrajectoryFile(TestFile("c.txt", "1305031102.175304 1.5 -2.25 3.125 0 0 0.6 0.8\n"),
                                          TrajectoryFormat::kEuroc);
  ASSERT_FALSE(seconds);
  EXPECT_THAT(seconds.error().message, testing::AllOf(HasSubstr("line 1"), HasSubstr("--format left out"),
                                                      HasSubstr("--reference-format euroc")));
}

TEST(TrajectoryIo, AnotherFormatsRowsPointToTheFormatRatherThanToTheLine) {
  const std::string kitti = "1 0 0 5 0 1 0 6 0 0 1 7\n1 0 0 5 0 1 0 6 0 0 1 8\n", tum = kPlain;
  const struct {
    std::string text;
    TrajectoryFormat format;
    const char *columns, *remedy;
  } cases[] = {{kEurocHeader + kEurocRows, TrajectoryFormat::kTum, "line 2: 9 columns", "--reference-format euroc"},
               {kEurocRows, TrajectoryFormat::kKitti, "line 1: 9 columns", "--format euroc"},
               {kitti, TrajectoryFormat::kTum, "line 1: 12 columns", "--format kitti"},
               {kitti, TrajectoryFormat::kAuto, "line 1: 12 columns", "--format kitti"},
               {"1.0" + kitti.substr(1), TrajectoryFormat::kEuroc, "line 1: '1.0'", "--format kitti"},
               {tum, TrajectoryFormat::kKitti, "line 1: 8 columns", "--format left out"}};
  for (const auto& one : cases) {
    const std::string refusal = Refusal(one.text, one.format);
    EXPECT_THAT(refusal, testing::AllOf(HasSubstr(one.columns), HasSubstr(one.remedy)));
    EXPECT_THAT(refusal, testing::Not(HasSubstr("remove the line")));
  }
  EXPECT_THAT(Refusal(tum + "4 1 0 0 0 0 0 1 9\n5 1 0 0 0 0 0 1\n", TrajectoryFormat::kTum),
              HasSubstr("line 4: 9 columns where 8 are expected; mend or remove the line"));
  EXPECT_THAT(Refusal("0 1 0 0 5 0 1 0 6 0 0 1 7\n"), HasSubstr("see --format")) << "nor an unlikely format";
}

TEST(TrajectoryIo, KittiByNameAlone) {
  const std::string rows = "1 0 0 5 0 1 0 6 0 0 1 7\n0 -1 0 1 1 0 0 2 0 0 1 3\n";
  const auto read = ReadTrajectoryFile(TestFile("kitti.txt", rows), TrajectoryFormat::kKitti);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->poses.size(), 2u);
  EXPECT_FALSE(read->has_stamps);
  EXPECT_EQ(read->poses[0].world_from_cam.translation, Eigen::Vector3d(5, 6, 7));
  EXPECT_LT((read->poses[1].world_from_cam * Eigen::Vector3d(1, 0, 0) - Eigen::Vector3d(1, 3, 3)).norm(), 1e-12);
  EXPECT_THAT(Refusal(rows), HasSubstr("--format kitti"));
  EXPECT_THAT(Refusal("1 0 0 5 0 1 0 6 0 0 2 7\n", TrajectoryFormat::kKitti), HasSubstr("no rotation"));
  EXPECT_THAT(Refusal("1 0 0 5 0 1 0 6 0 0 -1 7\n", TrajectoryFormat::kKitti), HasSubstr("no rotation"));
}

TEST(TrajectoryIo, SquareMatricesAreReadAsKittisAre) {
  const auto kitti = TrajectoryFormat::kKitti;
  const std::string square = "1 0 0 5 0 1 0 6 0 0 1 7 0 0 0 1\n", turned = "0 -1 0 1 1 0 0 2 0 0 1 3 0e0 0 0 1.0\n";
  const auto read = ReadTrajectoryFile(TestFile("square.txt", square + turned), kitti);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->poses.size(), 2u);
  EXPECT_EQ(read->poses[0].world_from_cam.translation, Eigen::Vector3d(5, 6, 7));
  EXPECT_LT((read->poses[1].world_from_cam * Eigen::Vector3d(1, 0, 0) - Eigen::Vector3d(1, 3, 3)).norm(), 1e-12);
  EXPECT_THAT(Refusal(square), HasSubstr("line 1: 16 columns")) << "by name alone, as KITTI's";
  EXPECT_THAT(Refusal(square), HasSubstr("--format kitti"));
  EXPECT_THAT(Refusal("1 0 0 0 0 1 0 0 0 0 1 0 5 6 7 1\n", kitti), HasSubstr("column by column"));
  EXPECT_THAT(Refusal(square + "1 0 0 5 0 1 0 6 0 0 1 7\n", kitti), HasSubstr("line 2: 12 columns where 16"));
  const std::string block = "1 0 0 5\n0 1 0 6\n0 0 1 7\n0 0 0 1\n";
  EXPECT_THAT(Refusal(block, kitti), HasSubstr("over four lines"));
  EXPECT_THAT(Refusal(block), HasSubstr("over four lines"));
}

TEST(TrajectoryIo, NanosecondsAreReadWithAWord) {
  const auto read = ReadTrajectoryFile(
      TestFile("ns.txt", "1305031102175304000 1 2 3 0 0 0 1\n1305031102211214000.0 1 2 3 0 0 0 1\n"));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->poses[0].timestamp.ns, 1305031102175304000);
  EXPECT_EQ(read->poses[1].timestamp.ns, 1305031102211214000);
  ASSERT_EQ(read->warnings.size(), 1u);
  EXPECT_THAT(read->warnings[0], HasSubstr("nanoseconds"));
  EXPECT_THAT(Refusal("1305031102175304000,1,2,3,1,0,0,0\n"), HasSubstr("--format")) << "TUM's order or EuRoC's?";
}

TEST(TrajectoryIo, ALoneRepeatedStampKeepsTheLastPose) {
  const auto read = ReadTrajectoryFile(
      TestFile("twice.txt", "1 1 0 0 0 0 0 1\n1.0 2 0 0 0 0 0 1\n2 3 0 0 0 0 0 1\n2 4 0 0 0 0 0 1\n"));
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->poses.size(), 2u);
  EXPECT_EQ(read->poses[0].world_from_cam.translation.x(), 2);
  EXPECT_EQ(read->poses[1].world_from_cam.translation.x(), 4);
  ASSERT_EQ(read->warnings.size(), 1u);
  EXPECT_THAT(read->warnings[0], HasSubstr("line 2"));
}

TEST(TrajectoryIo, BadLinesAreNamed) {
  const std::string good = "1 1 0 0 0 0 0 1\n";
  EXPECT_THAT(Refusal(good + "\n0.5 1 0 0 0 0 0 1\n"), HasSubstr("line 3: the time stamp goes back"));
  EXPECT_THAT(Refusal(good + "2 1 0 0 nan 0 0 1\n"), HasSubstr("line 2: nan or inf"));
  EXPECT_THAT(Refusal(good + "2 1 -inf 0 0 0 0 1\n"), HasSubstr("line 2: nan or inf"));
  EXPECT_THAT(Refusal(good + "2 1 1e999 0 0 0 0 1\n"), HasSubstr("line 2: nan or inf"));
  EXPECT_THAT(Refusal(good + "nan 1 0 0 0 0 0 1\n"), HasSubstr("line 2"));
  EXPECT_THAT(Refusal(good + "2 1 0 0 0 0 0 0\n"), HasSubstr("line 2: a zero quaternion"));
  EXPECT_THAT(Refusal(good + "2 1 0 0 0 0 x 1\n"), HasSubstr("line 2: 'x' is not a number"));
  EXPECT_THAT(Refusal(good + "2 1 0 0 0 0\n3 1 0 0 0 0 0 1\n"), HasSubstr("line 2: 6 columns"));
  EXPECT_THAT(Refusal(good + "2 1 0 0 0 0 0 1 9\n"), HasSubstr("line 2: 9 columns"));
  EXPECT_THAT(Refusal(good + "2 1 0 0 0 0"), HasSubstr("cut short"));
  EXPECT_THAT(Refusal(good + "2 1 0 0 0.6 0 0 0."), HasSubstr("cut short")) << "its last number lost its digits";
  EXPECT_THAT(Refusal("1,5 1,0 0,0 0,0 0,0 0,0 0,0 1,0\n"), HasSubstr("line 1"));
  EXPECT_THAT(Refusal("1 1 0 0 0 0 0 1 9\n"), HasSubstr("9 columns")) << "never the first eight";
  EXPECT_THAT(Refusal("a b c d e f g h\n" + good), HasSubstr("line 1"));
  EXPECT_THAT(Refusal(good + "timestamp tx ty tz qx qy qz qw\n"), HasSubstr("line 2"));
  EXPECT_THAT(Refusal("# only comments\n"), HasSubstr("no poses"));
  EXPECT_THAT(Refusal("timestamp tx ty tz qx qy qz qw\n"), HasSubstr("no poses"));
  EXPECT_THAT(Refusal(""), HasSubstr("no poses"));
}

TEST(TrajectoryIo, WhatTumTextWritesComesBack) {
  const Trajectory walk = SmoothWalk(50, 33);
  const auto read = ReadTrajectoryFile(TestFile("walk.txt", TumText(walk)));
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->poses.size(), walk.size());
  for (size_t i = 0; i < walk.size(); ++i) {
    EXPECT_EQ(read->poses[i].timestamp, walk[i].timestamp);
    EXPECT_LT((read->poses[i].world_from_cam.translation - walk[i].world_from_cam.translation).norm(), 1e-8);
    EXPECT_LT(read->poses[i].world_from_cam.rotation.angularDistance(walk[i].world_from_cam.rotation), 1e-7);
  }
}

TEST(TrajectoryIo, AMissingFileIsNamed) {
  const auto read = ReadTrajectoryFile("nowhere/missing.txt");
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, HasSubstr("nowhere/missing.txt"));
}

}  // namespace
}  // namespace yorb
