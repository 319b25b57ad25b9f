// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Synthetic depth: a person before a wall and behind a desk, whose pixels are known one by one.
#include "dynamics/remover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "core/random.h"
#include "dynamics/test_depth.h"

namespace yorb {
namespace {

/// A scene and whose pixel is whose.
struct Scene {
  ImageSet images;
  cv::Mat person{kHeight, kWidth, CV_8UC1, cv::Scalar(0)};  ///< 255 on the person
  Box box{"person", 0.9, 0, 0, 0, 0};                       ///< of what is visible of it
};

/// The wall stands at 3 m. The desk's top comes nearer towards the lower edge. The person is an ellipse, nearer at the
/// head than at the feet as seen by a camera that looks down; `metres` is the depth of its middle.
Scene MakeScene(double metres, bool has_desk = true) {
  Scene scene;
  Random random(7, 1);
  scene.images.grey = cv::Mat(kHeight, kWidth, CV_8UC1, cv::Scalar(90));
  scene.images.depth = {cv::Mat(kHeight, kWidth, CV_16UC1), kMetresPerUnit};
  int left = kWidth, right = 0, top = kHeight, bottom = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      double depth = 3.0;
      const double across = (x - 300) / 90.0, along = (y - 200) / 190.0;
      const double body = metres + 0.25 * along;
      if (across * across + along * along < 1) {
        depth = body;
        scene.person.at<uint8_t>(y, x) = 255;
      }
      const double desk = 2.4 - 1.5 * (y - 240) / 240.0;
      if (has_desk && y > 240 && desk < depth) {
        depth = desk;
        scene.person.at<uint8_t>(y, x) = 0;
      }
      if (scene.person.at<uint8_t>(y, x) != 0) {
        left = std::min(left, x), right = std::max(right, x + 1), top = std::min(top, y),
        bottom = std::max(bottom, y + 1);
      }
      const double noise = 0.003 * depth * depth * (random.Uniform() - 0.5);
      const bool is_hole = random.Uniform() < 0.05;
      scene.images.depth.pixels.at<uint16_t>(y, x) =
          is_hole ? uint16_t{0} : static_cast<uint16_t>((depth + noise) / kMetresPerUnit);
    }
  }
  scene.box.left = left, scene.box.right = right, scene.box.top = top, scene.box.bottom = bottom;
  return scene;
}

std::vector<Keypoint> Points() {
  std::vector<Keypoint> points;
  for (int y = 20; y < kHeight - 20; y += 7) {
    for (int x = 20; x < kWidth - 20; x += 7) {
      Keypoint point;
      point.x = static_cast<float>(x), point.y = static_cast<float>(y);
      points.push_back(point);
    }
  }
  return points;
}

/// How right the verdicts are.
struct Shares {
  double dynamic_removed, static_in_box_kept, static_outside_kept;
};

Shares SharesOf(const Scene& scene, const std::vector<Keypoint>& points, const std::vector<Verdict>& verdicts) {
  double person = 0, removed = 0, in_box = 0, in_box_kept = 0, outside = 0, outside_kept = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const int x = static_cast<int>(points[i].x), y = static_cast<int>(points[i].y);
    const bool is_dynamic = verdicts[i] == Verdict::kDynamic;
    if (scene.person.at<uint8_t>(y, x) != 0) {
      ++person, removed += is_dynamic;
    } else if (x >= scene.box.left && x < scene.box.right && y >= scene.box.top && y < scene.box.bottom) {
      ++in_box, in_box_kept += !is_dynamic;
    } else {
      ++outside, outside_kept += !is_dynamic;
    }
  }
  return {removed / person, in_box_kept / in_box, outside_kept / outside};
}

Shares SharesWith(Dynamics dynamics, const Scene& scene) {
  Remover remover(dynamics, MotionTable::Default(), 1.2);
  const std::vector<Keypoint> points = Points();
  const MovingAreas areas = remover.Look(scene.images, {{true, {scene.box}}, scene.images.timestamp});
  return SharesOf(scene, points, areas.Judge(points));
}

TEST(Remover, OffKeepsEverything) {
  const Shares shares = SharesWith(Dynamics::kOff, MakeScene(1.5));
  EXPECT_EQ(shares.dynamic_removed, 0);
  EXPECT_EQ(shares.static_in_box_kept, 1);
}

TEST(Remover, ThePapersRuleTakesTheBoxAndNoMore) {
  const Shares shares = SharesWith(Dynamics::kPaper, MakeScene(1.5));
  EXPECT_EQ(shares.dynamic_removed, 1);
  EXPECT_EQ(shares.static_in_box_kept, 0);
  EXPECT_EQ(shares.static_outside_kept, 1);
}

TEST(Remover, DepthGivesBackWhatIsNotTheBody) {
  for (const double metres : {1.0, 1.4, 1.8, 2.2}) {
    const Shares shares = SharesWith(Dynamics::kFull, MakeScene(metres));
    EXPECT_GT(shares.dynamic_removed, 0.97) << metres;
    EXPECT_GT(shares.static_in_box_kept, 0.5) << metres;
    EXPECT_GT(shares.static_outside_kept, 0.94) << metres;  // the desk where the body touches it
  }
}

TEST(Remover, WhereDepthCannotTellTheBoxCountsAsAWhole) {
  Scene scene = MakeScene(1.5, false);
  const Box& box = scene.box;
  scene.images.depth.pixels(cv::Rect(cv::Point2d(box.left, box.top), cv::Point2d(box.right, box.bottom))).setTo(0);
  EXPECT_EQ(SharesWith(Dynamics::kFull, scene).dynamic_removed, 1);
  scene.images.depth = {};
  EXPECT_EQ(SharesWith(Dynamics::kFull, scene).dynamic_removed, 1);
}

TEST(Remover, TwoBodiesInOverlappingBoxesAreBothFound) {
  Scene near = MakeScene(1.0, false);
  Scene far = MakeScene(2.0, false);
  // The far one stands to the right, half hidden by the near one.
  constexpr int kShift = 110;
  Scene both = near;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = kShift; x < kWidth; ++x) {
      if (near.person.at<uint8_t>(y, x) != 0 || far.person.at<uint8_t>(y, x - kShift) == 0) continue;
      both.person.at<uint8_t>(y, x) = 255;
      both.images.depth.pixels.at<uint16_t>(y, x) = far.images.depth.pixels.at<uint16_t>(y, x - kShift);
    }
  }
  Box far_box = far.box;
  far_box.left += kShift, far_box.right += kShift;
  Remover remover(Dynamics::kFull, MotionTable::Default(), 1.2);
  const MovingAreas areas = remover.Look(both.images, {{true, {far_box, near.box}}, both.images.timestamp});
  const std::vector<Keypoint> points = Points();
  EXPECT_GT(SharesOf(both, points, areas.Judge(points)).dynamic_removed, 0.97);
}

// Work must not grow with the square of the boxes, each of which asks around it for all others: with sums over all of
// them it took minutes.
TEST(Remover, AThousandBoxesOverOnePersonAreNoMoreWorkThanThousandTimesOne) {
  const Scene scene = MakeScene(1.5);
  Random random(3, 1);
  std::vector<Box> boxes;
  for (int i = 0; i < 900; ++i) {
    Box box = scene.box;
    box.left += 40 * random.Uniform() - 20, box.right += 40 * random.Uniform() - 20;
    box.top += 40 * random.Uniform() - 20, box.bottom += 40 * random.Uniform() - 20;
    boxes.push_back(box);
  }
  Remover remover(Dynamics::kFull, MotionTable::Default(), 1.2);
  const std::vector<Keypoint> points = Points();
  const MovingAreas areas = remover.Look(scene.images, {{true, boxes}, scene.images.timestamp});
  EXPECT_EQ(areas.boxes().size(), boxes.size());
  const Shares shares = SharesOf(scene, points, areas.Judge(points));
  EXPECT_GT(shares.dynamic_removed, 0.97);
  EXPECT_GT(shares.static_outside_kept, 0.8);
}

TEST(Remover, ABodyDoesNotJumpToWhatComesBeforeIt) {
  const auto scene_with = [](bool has_panel) {
    Scene scene = MakeScene(9, false);  // nobody before the wall
    const cv::Rect person(200, 60, 90, 340), panel(290, 60, 110, 340);
    scene.images.depth.pixels(person).setTo(1.6 / kMetresPerUnit);
    if (has_panel) scene.images.depth.pixels(panel).setTo(1.25 / kMetresPerUnit);
    scene.person.setTo(0);
    scene.person(person).setTo(255);
    scene.box = {"person", 0.9, 200, 60, 400, 400};
    return scene;
  };
  Remover remover(Dynamics::kFull, MotionTable::Default(), 1.2);
  const std::vector<Keypoint> points = Points();
  for (int i = 0; i < 6; ++i) {
    Scene scene = scene_with(i >= 3);
    scene.images.timestamp = {i * 33000000};
    const MovingAreas areas = remover.Look(scene.images, {{true, {scene.box}}, scene.images.timestamp});
    const Shares shares = SharesOf(scene, points, areas.Judge(points));
    EXPECT_GT(shares.dynamic_removed, 0.97) << i;
    EXPECT_GT(shares.static_in_box_kept, 0.8) << i;
  }
}

TEST(Remover, ABodyThatIsMissedIsFoundWhereItWas) {
  const Scene scene = MakeScene(1.4);
  Remover remover(Dynamics::kFull, MotionTable::Default(), 1.2);
  const std::vector<Keypoint> points = Points();
  const auto look = [&](int frame, const ImageSet& images, std::vector<Box> boxes) {
    ImageSet now = images;
    now.timestamp = {frame * 33000000};
    return SharesOf(scene, points, remover.Look(now, {{true, std::move(boxes)}, now.timestamp}).Judge(points));
  };
  for (int i = 0; i < 3; ++i) look(i, scene.images, {scene.box});
  for (int i = 3; i < 30; ++i) ASSERT_GT(look(i, scene.images, {}).dynamic_removed, 0.95) << i;
  ImageSet empty = scene.images;
  empty.depth.pixels = cv::Mat(kHeight, kWidth, CV_16UC1, cv::Scalar(3.0 / kMetresPerUnit));
  EXPECT_LT(look(30, empty, {}).dynamic_removed, 0.05) << "the body has gone";
}

TEST(Remover, AWholePictureIsNotFoundAgain) {
  Scene scene = MakeScene(1.4);
  scene.box = {"person", 0.9, 0, 0, kWidth, kHeight};
  Remover remover(Dynamics::kFull, MotionTable::Default(), 1.2);
  for (int i = 0; i < 5; ++i) {
    scene.images.timestamp = {i * 33000000};
    remover.Look(scene.images, {{true, {scene.box}}, scene.images.timestamp});
  }
  scene.images.timestamp = {5 * 33000000};
  const std::vector<Verdict> verdicts =
      remover.Look(scene.images, {{true, {}}, scene.images.timestamp}).Judge(Points());
  EXPECT_EQ(std::count(verdicts.begin(), verdicts.end(), Verdict::kDynamic), 0);
}

TEST(Remover, AFaintBoxAloneTakesNothing) {
  Scene scene = MakeScene(1.4);
  scene.box.confidence = 0.15;
  Remover remover(Dynamics::kFull, MotionTable::Default(), 1.2, 0.25);
  const std::vector<Keypoint> points = Points();
  const MovingAreas areas = remover.Look(scene.images, {{true, {scene.box}}, scene.images.timestamp});
  EXPECT_EQ(SharesOf(scene, points, areas.Judge(points)).dynamic_removed, 0);
}

TEST(Remover, APosterOfSomebodyIsKeptHoweverSureTheDetectorIs) {
  Scene scene = MakeScene(1.5, false);
  scene.images.depth.pixels.setTo(static_cast<uint16_t>(2.5 / kMetresPerUnit));
  Remover remover(Dynamics::kFull, MotionTable::Default(), 1.2);
  const std::vector<Keypoint> points = Points();
  const MovingAreas areas = remover.Look(scene.images, {{true, {scene.box}}, scene.images.timestamp});
  const std::vector<Verdict> verdicts = areas.Judge(points);
  EXPECT_EQ(std::count(verdicts.begin(), verdicts.end(), Verdict::kDynamic), 0);
}

TEST(Remover, WhoStoodFreeAndComesToAWallIsNoPoster) {
  Remover remover(Dynamics::kFull, MotionTable::Default(), 1.2);
  const std::vector<Keypoint> points = Points();
  for (int i = 0; i < 8; ++i) {
    Scene scene = MakeScene(std::min(2.1 + 0.15 * i, 2.7), false);
    if (i > 4) scene.images.depth.pixels.setTo(static_cast<uint16_t>(3 / kMetresPerUnit));  // as flat as the wall
    scene.images.timestamp = {i * 100000000};
    const MovingAreas areas = remover.Look(scene.images, {{true, {scene.box}}, scene.images.timestamp});
    EXPECT_GT(SharesOf(scene, points, areas.Judge(points)).dynamic_removed, 0.95) << i;
  }
}

TEST(Remover, WhoWasInViewAMomentAgoIsStillThereBesideAPanelAsFarAway) {
  Scene scene = MakeScene(1.4, false);
  Remover remover(Dynamics::kFull, MotionTable::Default(), 1.2, 0.25);
  const std::vector<Keypoint> points = Points();
  const auto removed = [&](int frame) {
    scene.images.timestamp = {frame * 33000000};
    const SeenAt seen{{true, {scene.box}}, scene.images.timestamp};
    return SharesOf(scene, points, remover.Look(scene.images, seen).Judge(points)).dynamic_removed;
  };
  for (int i = 0; i < 3; ++i) ASSERT_GT(removed(i), 0.95);
  // From here on the detector hardly sees the person, who stands between two panels.
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool is_beside = x < scene.box.left || x >= scene.box.right;
      const double panel = 1.4 + 0.25 * (y - 200) / 190.0;
      if (is_beside) scene.images.depth.pixels.at<uint16_t>(y, x) = static_cast<uint16_t>(panel / kMetresPerUnit);
    }
  }
  scene.box.confidence = 0.15;
  for (int i = 3; i < 12; ++i) EXPECT_GT(removed(i), 0.95) << i;
  EXPECT_LT(removed(25), 0.05) << "later the panels count: the box may be one of them";
}

TEST(Remover, AMapOfPeopleFindsWhomNoBoxShowsWhileItIsNew) {
  Scene scene = MakeScene(1.5, false);
  const std::vector<Keypoint> points = Points();
  Detections seen;
  cv::resize(scene.person, seen.people, {40, 30}, 0, 0, cv::INTER_AREA);
  const auto removed = [&](Dynamics dynamics, double age_s) {
    Remover remover(dynamics, MotionTable::Default(), 1.2);
    Timestamp at = scene.images.timestamp;
    at.ns -= static_cast<int64_t>(age_s * 1e9);
    return SharesOf(scene, points, remover.Look(scene.images, {seen, at}).Judge(points));
  };
  EXPECT_GT(removed(Dynamics::kFull, 0).dynamic_removed, 0.95);
  EXPECT_GT(removed(Dynamics::kFull, 0.07).dynamic_removed, 0.95);
  EXPECT_GT(removed(Dynamics::kFull, 0).static_outside_kept, 0.9);
  EXPECT_EQ(removed(Dynamics::kFull, 0.5).dynamic_removed, 0) << "by now it may be wrong everywhere";
  EXPECT_EQ(removed(Dynamics::kPaper, 0).dynamic_removed, 0) << "the paper knows boxes alone";
  EXPECT_EQ(removed(Dynamics::kOff, 0).dynamic_removed, 0);
}

TEST(Remover, TheUsersMaskCountsInEveryMode) {
  for (const Dynamics dynamics : {Dynamics::kOff, Dynamics::kPaper, Dynamics::kFull}) {
    Scene scene = MakeScene(1.5);
    scene.images.ignored = cv::Mat(kHeight, kWidth, CV_8UC1, cv::Scalar(0));
    scene.images.ignored.colRange(0, kWidth / 2).setTo(1);
    Remover remover(dynamics, MotionTable::Default(), 1.2);
    const MovingAreas areas = remover.Look(scene.images, {{true, {}}, scene.images.timestamp});
    for (const Keypoint& point : Points()) {
      EXPECT_EQ(areas.Judge(point), point.x < kWidth / 2.0f ? Verdict::kDynamic : Verdict::kStatic);
      EXPECT_EQ(areas.Ignores(point), point.x < kWidth / 2.0f);
    }
  }
}

TEST(Remover, APreparedPictureIsJudgedAlike) {
  const Scene near = MakeScene(1.2), far = MakeScene(1.8);
  const std::vector<Keypoint> points = Points();
  const SeenAt seen{{true, {near.box}}, near.images.timestamp};
  Remover plain(Dynamics::kFull, MotionTable::Default(), 1.2), prepared = plain, misled = plain;
  const auto expected = plain.Look(near.images, seen).Judge(points);
  prepared.Prepare(near.images);
  EXPECT_EQ(prepared.Look(near.images, seen).Judge(points), expected);
  ImageSet earlier = far.images;
  earlier.timestamp.ns -= 1'000'000'000;
  misled.Prepare(earlier);  // of a frame that was dropped then
  EXPECT_EQ(misled.Look(near.images, seen).Judge(points), expected);
}

TEST(Remover, NoWallIsMeasuredInABoxNorUnderAMask) {
  Scene scene = MakeScene(1.5);
  const auto covered = [&](Dynamics dynamics) {
    Remover remover(dynamics, MotionTable::Default(), 1.2);
    return remover.Look(scene.images, {{true, {scene.box}}, scene.images.timestamp}).Covered({kWidth, kHeight});
  };
  const auto marked = [](const cv::Mat& cells, double x, double y) {
    return cells.at<uint8_t>(static_cast<int>(y) * cells.rows / kHeight, static_cast<int>(x) * cells.cols / kWidth) !=
           0;
  };
  const double middle_x = (scene.box.left + scene.box.right) / 2, middle_y = (scene.box.top + scene.box.bottom) / 2;
  EXPECT_TRUE(covered(Dynamics::kOff).empty());
  const cv::Mat whole = covered(Dynamics::kPaper), body = covered(Dynamics::kFull);
  for (const cv::Mat& cells : {whole, body}) {
    EXPECT_TRUE(marked(cells, middle_x, middle_y));
    EXPECT_FALSE(marked(cells, 1, 1));
  }
  EXPECT_TRUE(marked(whole, scene.box.left + 1, scene.box.top + 1));
  EXPECT_GT(cv::countNonZero(whole), cv::countNonZero(body));
  scene.images.ignored = cv::Mat(kHeight, kWidth, CV_8UC1, cv::Scalar(0));
  scene.images.ignored.rowRange(0, 8).setTo(1);
  for (const Dynamics dynamics : {Dynamics::kOff, Dynamics::kPaper, Dynamics::kFull}) {
    const cv::Mat cells = covered(dynamics);
    EXPECT_TRUE(marked(cells, 1, 1));
    EXPECT_FALSE(marked(cells, 1, kHeight - 2));
    EXPECT_EQ(marked(cells, middle_x, middle_y), dynamics != Dynamics::kOff);
  }
}

TEST(Remover, WhatStandsBeforeSomebodyIsNotCovered) {
  const Scene scene = MakeScene(1.5);
  Box table = scene.box;
  table.name = "dining table";
  Remover remover(Dynamics::kPaper, MotionTable::Default(), 1.2);
  const auto areas = remover.Look(scene.images, {{true, {scene.box, table}}, scene.images.timestamp});
  EXPECT_EQ(cv::countNonZero(areas.Covered({kWidth, kHeight})), 0);
}

TEST(Kept, KeepsTheOrder) {
  Features features;
  for (int i = 0; i < 5; ++i) {
    features.keypoints.emplace_back();
    features.keypoints.back().x = static_cast<float>(i);
    features.descriptors.emplace_back();
  }
  const Features kept = Kept(features, [](size_t index) { return index % 2 == 0; });
  ASSERT_EQ(kept.keypoints.size(), 3u);
  ASSERT_EQ(kept.descriptors.size(), 3u);
  EXPECT_EQ(kept.keypoints[1].x, 2);
  EXPECT_EQ(kept.keypoints[2].x, 4);
}

}  // namespace
}  // namespace yorb
