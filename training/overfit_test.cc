// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>

#include "pictures/test_folder.h"
#include "training/curves.h"
#include "training/test_shapes.h"
#include "training/trainer.h"

namespace yorb {
namespace {

const ClassTable kTable{{"disc", "square"}, {"", ""}};

struct Fixture {
  TestFolder folder;
  std::shared_ptr<const Composer> pictures;
  TrainerOptions options;
  LoaderOptions loader;

  Fixture(int num_pictures, int64_t num_steps) {
    const auto pack = MakeShapePack(folder.Path("shapes.pack"), num_pictures, 1);
    pictures = std::make_shared<Composer>(std::vector<std::shared_ptr<const Pack>>{pack}, kTable);
    options.out = folder.Path();
    options.schedule.num_steps = num_steps;
    options.schedule.num_warmup_steps = 5;
    options.schedule.phases = {{1, {{128, 96}}}};
    loader.batch_size = 8;
    loader.is_augmented = false;
  }

  Loader MakeLoader() const {
    const cv::Size size = options.schedule.phases.back().sizes.front();
    return Loader(pictures, {}, kTable, loader, [size](int64_t) { return size; });
  }
};

TEST(Training, LearnsThirtyTwoPicturesByHeart) {
  torch::set_num_threads(1);
  torch::manual_seed(1);
  const Fixture fixture(32, 160);
  OptimizerOptions optimizer;
  optimizer.rate = 0.004;
  optimizer.backbone_part = 1;
  optimizer.averaging = 0.95;
  TrainState state(MakeLayout("yolo-mo-n", 2), kTable, optimizer);
  const double before = Evaluate(state.average, *fixture.pictures, {128, 96}, torch::kCPU).map50;
  Trainer trainer(state, fixture.MakeLoader(), {{"shapes", fixture.pictures}}, fixture.options);
  int num_reports = 0;
  ASSERT_TRUE(trainer.Run([&](const TrainReport&) { ++num_reports; }, [] { return false; }).ok());
  const double after = Evaluate(state.average, *fixture.pictures, {128, 96}, torch::kCPU).map50;
  EXPECT_LT(before, 0.1);
  EXPECT_GT(after, 0.9);
  EXPECT_EQ(num_reports, 8);
  const auto curves = CurvesSvg(fixture.options.out);
  ASSERT_TRUE(curves.ok()) << curves.error().message;
  EXPECT_NE(curves->find("objectness"), std::string::npos);
  EXPECT_NE(curves->find("shapes"), std::string::npos);
}

/// The sum of all weights' magnitudes, to tell two states apart.
double Fingerprint(TrainState& state) {
  double sum = 0;
  for (const torch::Tensor& parameter : state.network->parameters()) sum += parameter.abs().sum().item<double>();
  for (const torch::Tensor& parameter : state.average->parameters()) sum += parameter.abs().sum().item<double>();
  return sum;
}

TEST(Training, ResumedTrainingGoesOnAsIfItHadNotStopped) {
  torch::set_num_threads(1);
  const Fixture whole(8, 6), parts(8, 6);
  const auto run = [](const Fixture& fixture, TrainState& state, int64_t last) {
    Trainer trainer(state, fixture.MakeLoader(), {}, fixture.options);
    return trainer.Run([](const TrainReport&) {}, [&] { return state.step >= last; }).ok();
  };
  const Layout layout = MakeLayout("yolo-mo-n", 2);
  torch::manual_seed(2);
  TrainState once(layout, kTable, {});
  ASSERT_TRUE(run(whole, once, 6));
  torch::manual_seed(2);
  TrainState first(layout, kTable, {});
  ASSERT_TRUE(run(parts, first, 3));
  TrainState second(layout, kTable, {});
  ASSERT_TRUE(LoadCheckpoint(parts.options.out + "/last.pt", second).ok());
  EXPECT_EQ(second.step, 3);
  ASSERT_TRUE(run(parts, second, 6));
  EXPECT_NEAR(Fingerprint(once), Fingerprint(second), 1e-3);
  EXPECT_GT(std::abs(Fingerprint(once) - Fingerprint(first)), 1e-2);
}

TEST(Training, WeightsAreAveragedAndBegunFrom) {
  const ClassTable table{{"disc", "square"}, {"", ""}};
  std::vector<std::string> paths;
  std::vector<torch::Tensor> biases;
  for (int i = 0; i < 3; ++i) {
    torch::manual_seed(i);
    TrainState state(MakeLayout("yolo-mo-n", 2), table, {});
    const torch::NoGradGuard no_grad;
    state.average->heads[0]->bias.normal_();
    biases.push_back(state.average->heads[0]->bias.clone());
    paths.push_back(testing::TempDir() + "/mean" + std::to_string(i) + ".pt");
    ASSERT_TRUE(SaveCheckpoint(paths.back(), state));
  }
  TrainState state(MakeLayout("yolo-mo-n", 2), table, {});
  ASSERT_TRUE(BeginFrom(paths[0], state));
  EXPECT_TRUE(torch::equal(state.network->heads[0]->bias, biases[0]));
  EXPECT_TRUE(torch::equal(state.average->heads[0]->bias, biases[0]));
  ASSERT_TRUE(AverageWith({paths[1], paths[2]}, state));
  EXPECT_TRUE(torch::allclose(state.average->heads[0]->bias, (biases[0] + biases[1] + biases[2]) / 3));
  EXPECT_FALSE(AverageWith({paths[0] + ".missing"}, state));
}

TEST(Training, ForeignCheckpointsAreRefused) {
  const TestFolder folder;
  const std::string path = folder.Path("foreign.pt");
  TrainState state(MakeLayout("yolo-mo-n", 2), kTable, {});
  ASSERT_TRUE(SaveCheckpoint(path, state).ok());
  TrainState other(MakeLayout("yolo-mo-n", 1), {{"disc"}, {""}}, {});
  EXPECT_FALSE(LoadCheckpoint(path, other).ok());
  const auto kind = ReadCheckpointKind(path);
  ASSERT_TRUE(kind.ok());
  EXPECT_EQ(kind->layout, "yolo-mo-n");
  EXPECT_EQ(kind->table.names, kTable.names);
  std::ofstream(path) << "no checkpoint";
  EXPECT_FALSE(ReadCheckpointKind(path).ok());
}

TEST(Schedule, WarmsUpAndFallsAsACosine) {
  ScheduleOptions options;
  options.num_steps = 1000;
  options.num_warmup_steps = 100;
  options.phases = *ParseSizePhases("64x64:0.5,128x96+96x128");
  const Schedule schedule(options, 0);
  EXPECT_NEAR(schedule.Rate(0), 0.01, 1e-3);
  EXPECT_GT(schedule.Rate(100), 0.95);
  EXPECT_NEAR(schedule.Rate(500), 0.51, 1e-6);
  EXPECT_NEAR(schedule.Rate(1000), 0.02, 1e-9);
  EXPECT_EQ(schedule.SizeAt(499), cv::Size(64, 64));
  EXPECT_EQ(schedule.SizeAt(500), cv::Size(128, 96));
  EXPECT_EQ(schedule.SizeAt(501), cv::Size(96, 128));
  for (const char* bad : {"320", "320x250", "64x64:0.5,64x64:0.4", "0x32", "64x64:2"})
    EXPECT_FALSE(ParseSizePhases(bad).ok()) << bad;
}

}  // namespace
}  // namespace yorb
