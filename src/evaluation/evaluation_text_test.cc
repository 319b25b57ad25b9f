// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/evaluation_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "evaluation/test_trajectories.h"

namespace yorb {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;

Evaluation SomeEvaluation(const std::string& name, size_t num_poses, double noise) {
  ReadTrajectory truth, found;
  truth.poses = SmoothWalk(1000, 10);
  found.path = name;
  found.poses = Disturbed(SmoothWalk(num_poses, 30), noise, SomeMotion(1), 5);
  EvalOptions options;
  options.num_frames = 2 * num_poses;
  return Evaluate(truth, found, options).value();
}

TEST(EvaluationText, JsonHasTheKeysThatScriptsRead) {
  const Evaluation evaluation = SomeEvaluation("a.txt", 200, 0.01);
  const Json json = Json::parse(EvaluationJson({evaluation}, {}));
  for (const char* error : {"/ate", "/rpe/translation", "/rpe/rotation_deg"}) {
    for (const char* key : {"rmse", "mean", "median", "std", "min", "max"}) {
      EXPECT_TRUE(json.at(Json::json_pointer(error)).at(key).is_number()) << error << key;
    }
  }
  EXPECT_EQ(json.at("ate").at("rmse"), evaluation.ate.summary.rmse) << "every digit";
  EXPECT_EQ(json.at("pairs"), 200);
  EXPECT_EQ(json.at("rpe").at("pairs"), evaluation.rpe.translation.size());
  EXPECT_EQ(json.at("rpe").at("unit"), "s");
  EXPECT_EQ(json.at("rpe").at("delta"), 1.0);
  EXPECT_EQ(json.at("coverage"), 0.5);
  EXPECT_EQ(json.at("scale"), 1.0);
  EXPECT_EQ(json.at("align"), "se3");
  EXPECT_EQ(json.at("rotation").size(), 3u);
  EXPECT_EQ(json.at("rotation").at(2).size(), 3u);
  EXPECT_EQ(json.at("translation").size(), 3u);
}

TEST(EvaluationText, NothingToSayIsNull) {
  Evaluation evaluation = SomeEvaluation("a.txt", 20, 0.01);  // no pair is 1 s apart
  evaluation.coverage.reset();
  const Json json = Json::parse(EvaluationJson({evaluation}, {}));
  EXPECT_TRUE(json.at("rpe").at("translation").at("rmse").is_null());
  EXPECT_TRUE(json.at("rpe").at("rotation_deg").at("max").is_null());
  EXPECT_EQ(json.at("rpe").at("pairs"), 0);
  EXPECT_TRUE(json.at("coverage").is_null());
  EXPECT_TRUE(json.at("ate").at("rmse").is_number());
}

TEST(EvaluationText, SeveralGiveMeanAndDeviation) {
  const std::vector<Evaluation> both = {SomeEvaluation("a.txt", 200, 0.01), SomeEvaluation("b\xff.txt", 200, 0.03)};
  const Json json = Json::parse(EvaluationJson(both, {}));
  ASSERT_EQ(json.at("estimates").size(), 2u);
  EXPECT_EQ(json.at("estimates").at(0).at("file"), "a.txt");
  const double a = both[0].ate.summary.rmse, b = both[1].ate.summary.rmse;
  EXPECT_DOUBLE_EQ(json.at("mean").at("ate_rmse"), (a + b) / 2);
  EXPECT_NEAR(json.at("std").at("ate_rmse"), (b - a) / 2, 1e-12);
  const std::string table = EvaluationText(both, {});
  for (const char* word : {"a.txt", "mean", "s.d.", "ATE RMSE [m]", "coverage"}) EXPECT_THAT(table, HasSubstr(word));
}

TEST(EvaluationText, CsvHasALineAPairAndQuotesNames) {
  const Evaluation evaluation = SomeEvaluation("odd, \"name\".txt", 50, 0.01);
  const std::string csv = EvaluationCsv({evaluation}, SmoothWalk(1000, 10));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 51);
  EXPECT_THAT(csv, HasSubstr("timestamp,reference_timestamp,error_m,"));
  EXPECT_THAT(csv, HasSubstr("\n1300000000.030000,1300000000.030000,0.0"));
  EXPECT_THAT(csv, HasSubstr(",\"odd, \"\"name\"\".txt\"\n"));
}

TEST(EvaluationText, ThePlotStaysSmallForLongRuns) {
  ReadTrajectory truth, found;
  truth.poses = SmoothWalk(60000, 10);
  found.path = "long.txt";
  found.poses = Disturbed(truth.poses, 0.02, SomeMotion(1), 2);
  const std::string svg = EvaluationSvg({Evaluate(truth, found, {}).value()}, truth.poses);
  EXPECT_LT(svg.size(), 1500000u);
  EXPECT_GT(svg.size(), 50000u);
  EXPECT_THAT(svg, ::testing::Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace yorb
