// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/people_trainer.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "core/random.h"
#include "training/people_cells.h"
#include "training/schedule.h"

namespace yorb {
namespace {

constexpr int64_t kStepsAReport = 100;
constexpr int64_t kMeasuredAtOnce = 32;

/// The pictures in an order by chance.
torch::Tensor ShuffledOrder(int64_t count, uint64_t seed, int epoch) {
  std::vector<int64_t> order(static_cast<size_t>(count));
  std::iota(order.begin(), order.end(), int64_t{0});
  Random random(seed, static_cast<uint64_t>(epoch));
  for (size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.Below(static_cast<uint32_t>(i))]);
  return torch::tensor(order);
}

torch::Tensor LogitsOf(PeopleHead& head, const FeatureSet& set, const torch::Tensor& pictures) {
  const auto take = [&](const torch::Tensor& all) { return all.index_select(0, pictures).to(torch::kFloat32); };
  return head(take(set.fine), take(set.coarse)).squeeze(1);
}

/// The mean over the cells that have a label.
torch::Tensor LossOf(const torch::Tensor& logits, const torch::Tensor& labels) {
  const torch::Tensor weights = (labels != kUnlabelledCell).to(torch::kFloat32);
  namespace F = torch::nn::functional;
  const torch::Tensor sum = F::binary_cross_entropy_with_logits(
      logits, labels.clamp(0, 1), F::BinaryCrossEntropyWithLogitsFuncOptions().weight(weights).reduction(torch::kSum));
  return sum / weights.sum().clamp_min(1);
}

double Ratio(double part, double whole) { return whole > 0 ? part / whole : 0; }

}  // namespace

CellScores MeasureCells(PeopleHead head, const FeatureSet& set) {
  const torch::NoGradGuard no_grad;
  double num_hits = 0, num_called = 0, num_true = 0;
  for (int64_t first = 0; first < set.size(); first += kMeasuredAtOnce) {
    const torch::Tensor pictures = torch::arange(first, std::min(first + kMeasuredAtOnce, set.size()));
    const torch::Tensor labels = set.labels.index_select(0, pictures);
    const torch::Tensor is_true = labels > 0.5;
    const torch::Tensor is_called = (LogitsOf(head, set, pictures) > 0) & (labels != kUnlabelledCell);
    num_hits += (is_true & is_called).sum().item<double>();
    num_called += is_called.sum().item<double>();
    num_true += is_true.sum().item<double>();
  }
  return {Ratio(num_hits, num_called + num_true - num_hits), Ratio(num_hits, num_called), Ratio(num_hits, num_true)};
}

Status TrainPeopleHead(PeopleHead head, const FeatureSet& set, const PeopleTrainerOptions& options,
                       const std::function<void(const PeopleReport&)>& report,
                       const std::function<bool()>& should_stop) {
  const int64_t batch = std::min(options.batch_size, set.size()), steps_an_epoch = set.size() / batch;
  PeopleReport now{.num_steps = steps_an_epoch * options.epochs};
  ScheduleOptions times{.num_steps = now.num_steps, .num_warmup_steps = now.num_steps / 5};
  times.last_rate = 0;
  const Schedule schedule(times, 0);
  torch::optim::AdamW optimizer(head->parameters(),
                                torch::optim::AdamWOptions(options.rate).weight_decay(options.weight_decay));
  auto& settings = static_cast<torch::optim::AdamWOptions&>(optimizer.param_groups()[0].options());
  double sum = 0;
  int64_t num_summed = 0;
  for (now.epoch = 1; now.epoch <= options.epochs; ++now.epoch) {
    const torch::Tensor order = ShuffledOrder(set.size(), options.seed, now.epoch);
    for (int64_t i = 0; i < steps_an_epoch; ++i) {
      if (should_stop()) return Stopped();
      const torch::Tensor pictures = order.slice(0, i * batch, (i + 1) * batch);
      settings.lr(options.rate * schedule.Rate(now.step++));
      const torch::Tensor loss = LossOf(LogitsOf(head, set, pictures), set.labels.index_select(0, pictures));
      optimizer.zero_grad();
      loss.backward();
      optimizer.step();
      sum += loss.item<double>();
      now.is_end_of_epoch = i + 1 == steps_an_epoch;
      if (++num_summed < kStepsAReport && !now.is_end_of_epoch) continue;
      now.loss = std::exchange(sum, 0.0) / static_cast<double>(std::exchange(num_summed, int64_t{0}));
      report(now);
    }
  }
  return Status::Ok();
}

}  // namespace yorb
