// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/pose_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "optimize/pose_graph_oracle.h"
#include "optimize/relative_pose.h"
#include "optimize/test_pose_graphs.h"

namespace yorb {
namespace {

void ExpectSameBits(const Rigid3& a, const Rigid3& b) {
  EXPECT_EQ(a.rotation.coeffs(), b.rotation.coeffs());
  EXPECT_EQ(a.translation, b.translation);
}

TEST(RelativePose, HasTheNumericDerivatives) {
  Random random(1);
  const double h = 1e-6;
  for (const double size : {1e-9, 1e-4, 2e-3, 0.1, 1.0, 1.7}) {
    for (int trial = 0; trial < 20; ++trial) {
      const Rigid3 from = RandomPose(random, 3, 5), to = RandomPose(random, 3, 5);
      const Rigid3 measured = to * from.Inverse() * RandomPose(random, size, size);
      const RelativePoseJacobians j = LinearizeRelativePose(from, to, measured);
      EXPECT_EQ(j.error, RelativePoseError(from, to, measured));
      for (int k = 0; k < 6; ++k) {
        const Rigid3 up = Rigid3::FromStep(h * Vector6d::Unit(k)), down = Rigid3::FromStep(-h * Vector6d::Unit(k));
        const Vector6d by_from =
            RelativePoseError(up * from, to, measured) - RelativePoseError(down * from, to, measured);
        const Vector6d by_to =
            RelativePoseError(from, up * to, measured) - RelativePoseError(from, down * to, measured);
        EXPECT_LT((j.by_from.col(k) - by_from / (2 * h)).norm(), 1e-6) << size;
        EXPECT_LT((j.by_to.col(k) - by_to / (2 * h)).norm(), 1e-6) << size;
      }
    }
  }
}

TEST(RelativePose, HasNoErrorWhereThePosesAreAsMeasured) {
  Random random(2);
  const Rigid3 from = RandomPose(random, 3, 5), motion = RandomPose(random, 3, 5);
  EXPECT_LT(RelativePoseError(from, motion * from, motion).norm(), 1e-12);
}

TEST(AdjustPoseGraph, BringsACircleWithADriftingGuessBackToTruth) {
  CircleOptions options;
  options.start_drift = 0.002;
  const CircleGraph circle = MakeCircle(options);
  EXPECT_GT(GreatestError(circle.graph.poses, circle.truth), 0.5);
  PoseGraphOptions few;
  few.max_iterations = 5;
  const PoseGraphResult result = AdjustPoseGraph(circle.graph, few);
  EXPECT_LT(GreatestError(result.poses, circle.truth), 1e-6);
  EXPECT_LT(result.final_cost, 1e-9 * result.initial_cost);
}

TEST(AdjustPoseGraph, SpreadsTheDriftOfALoopOverItsEdges) {
  for (const bool is_robust : {false, true}) {
    CircleOptions options;
    options.drift = 0.001;
    options.neighbours = 3;
    CircleGraph circle = MakeCircle(options);
    circle.graph.edges.back().is_robust = is_robust;
    const double before = GreatestError(circle.graph.poses, circle.truth);
    const PoseGraphResult result = AdjustPoseGraph(circle.graph);
    EXPECT_LT(GreatestError(result.poses, circle.truth), 0.15 * before);
    const Rigid3 gap = result.poses.back() * result.poses.front().Inverse();
    const Rigid3 true_gap = circle.truth.back() * circle.truth.front().Inverse();
    EXPECT_LT((gap.translation - true_gap.translation).norm(), 0.01);
  }
}

TEST(AdjustPoseGraph, GivesWayToNoFalseLoopThatIsRobust) {
  CircleOptions options;
  options.neighbours = 3;
  CircleGraph circle = MakeCircle(options);
  circle.graph.edges.push_back({10, 60, Rigid3(), 1, true});  // metres off
  const double robust = GreatestError(AdjustPoseGraph(circle.graph).poses, circle.truth);
  circle.graph.edges.back().is_robust = false;
  const double plain = GreatestError(AdjustPoseGraph(circle.graph).poses, circle.truth);
  EXPECT_LT(robust, 0.1 * plain);
}

TEST(AdjustPoseGraph, ReachesTheCostOfCeres) {
  for (const bool is_robust : {false, true}) {
    CircleOptions options;
    options.poses = 60, options.neighbours = 4;
    options.drift = 0.003, options.noise = 0.01;
    CircleGraph circle = MakeCircle(options);
    circle.graph.edges.push_back({7, 40, circle.truth[41] * circle.truth[7].Inverse(), 2, is_robust});
    circle.graph.is_fixed[30] = true;
    PoseGraphOptions to_the_end;
    to_the_end.relative_tolerance = 1e-12;
    const PoseGraphResult result = AdjustPoseGraph(circle.graph, to_the_end);
    const CeresPoseGraphResult oracle = CeresAdjustPoseGraph(circle.graph, to_the_end, 1e-14);
    EXPECT_LT(result.final_cost, 0.9 * result.initial_cost);
    EXPECT_NEAR(result.final_cost, oracle.cost, 1e-7 * oracle.cost);
    EXPECT_LT(GreatestError(result.poses, oracle.poses), 1e-4);
  }
}

TEST(AdjustPoseGraph, LeavesFixedAndLonelyPosesToTheBit) {
  CircleOptions options;
  options.start_drift = 0.002;
  CircleGraph circle = MakeCircle(options);
  PoseGraph& graph = circle.graph;
  graph.is_fixed[50] = true;  // not where it should be, and yet
  graph.poses.push_back(graph.poses[3]);
  graph.is_fixed.push_back(false);
  const PoseGraphResult result = AdjustPoseGraph(graph);
  for (const size_t k : {size_t{0}, size_t{50}, graph.poses.size() - 1}) {
    ExpectSameBits(result.poses[k], graph.poses[k]);
  }
  EXPECT_GT((result.poses[70].translation - graph.poses[70].translation).norm(), 1e-3);
}

TEST(AdjustPoseGraph, PassesOverEdgesThatSayNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CircleOptions options;
  options.drift = 0.001;
  CircleGraph circle = MakeCircle(options);
  const PoseGraphResult expected = AdjustPoseGraph(circle.graph);
  const Rigid3 broken(Eigen::Quaterniond::Identity(), {nan, 0, 0});
  circle.graph.edges.push_back({3, 3, Rigid3(), 1});
  circle.graph.edges.push_back({3, 9, Rigid3(), 0});
  circle.graph.edges.push_back({3, 9, Rigid3(), nan});
  circle.graph.edges.push_back({3, 9, broken, 1});
  circle.graph.poses.push_back(broken);
  circle.graph.is_fixed.push_back(false);
  circle.graph.edges.push_back({3, 100, Rigid3(), 1});
  const PoseGraphResult result = AdjustPoseGraph(circle.graph);
  for (size_t k = 0; k < expected.poses.size(); ++k) ExpectSameBits(result.poses[k], expected.poses[k]);
}

TEST(AdjustPoseGraph, HoldsTogetherWhatFloats) {
  CircleOptions options;
  options.start_drift = 0.002;
  CircleGraph circle = MakeCircle(options);
  circle.graph.is_fixed[0] = false;
  const PoseGraphResult result = AdjustPoseGraph(circle.graph);
  EXPECT_LT(result.final_cost, 1e-6 * result.initial_cost);
  EXPECT_TRUE(result.poses[99].IsFinite());
}

TEST(AdjustPoseGraph, StopsWhenToldWithTheBestSoFar) {
  CircleOptions options;
  options.start_drift = 0.002;
  const CircleGraph circle = MakeCircle(options);
  double last_cost = std::numeric_limits<double>::infinity();
  for (int patience = 0; patience < 3; ++patience) {
    int num_asked = 0;
    const PoseGraphResult result = AdjustPoseGraph(circle.graph, {}, [&] { return ++num_asked > patience; });
    EXPECT_TRUE(result.was_stopped);
    EXPECT_EQ(result.iterations, patience);
    EXPECT_LT(result.final_cost, last_cost);
    last_cost = result.final_cost;
  }
}

TEST(AdjustPoseGraph, HasNothingToDoForNoEdge) {
  PoseGraph graph;
  EXPECT_TRUE(AdjustPoseGraph(graph).poses.empty());
  graph.poses.emplace_back();
  graph.is_fixed.push_back(false);
  EXPECT_EQ(AdjustPoseGraph(graph).final_cost, 0);
}

}  // namespace
}  // namespace yorb
