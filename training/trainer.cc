// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/trainer.h"

#include <ATen/autocast_mode.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/stopwatch.h"
#include "core/text.h"
#include "training/batch_stream.h"
#include "training/half_width.h"

namespace yorb {
namespace {

constexpr int64_t kReportSteps = 20;
constexpr double kMostGradient = 10;

/// Adds a line to a CSV file, under its heading where the file is new.
Status AppendLine(const std::string& path, const std::string& heading, const std::vector<std::string>& fields) {
  const bool is_new = !std::filesystem::exists(path);
  std::ofstream file(path, std::ios::app);
  if (is_new) file << heading << '\n';
  for (size_t i = 0; i < fields.size(); ++i) file << (i == 0 ? "" : ",") << fields[i];
  file << '\n';
  file.flush();
  return file ? Status::Ok() : Failure(path + ": cannot be written; is the disk full?");
}

void Add(const Loss& loss, TrainReport& sum) {
  sum.box += loss.box;
  sum.objectness += loss.objectness;
  sum.classes += loss.classes;
  sum.teacher += loss.teacher;
  ++sum.num_steps;
}

/// Sums to means.
TrainReport Mean(TrainReport sum) {
  const double count = static_cast<double>(std::max<int64_t>(1, sum.num_steps));  // fewer than usual after a resumption
  sum.box /= count;
  sum.objectness /= count;
  sum.classes /= count;
  sum.teacher /= count;
  return sum;
}

std::array<torch::Tensor, 3> Forward(Network& network, const torch::Tensor& input, bool is_half_wide) {
  const HalfWidth width(input.device().type(), is_half_wide);
  const auto maps = network(input);
  if (is_half_wide) at::autocast::clear_cache();  // weights in bfloat16, which the next step outdates
  return maps;
}

}  // namespace

Trainer::Trainer(TrainState& state, Loader loader, std::vector<WatchedSet> watched, const TrainerOptions& options)
    : state_(state),
      loader_(std::move(loader)),
      watched_(std::move(watched)),
      options_(options),
      schedule_(options.schedule, state.seconds) {}

Loss Trainer::LossOf(const Batch& batch) {
  const torch::Tensor input = ToInput(batch.pictures, options_.device);
  const auto maps = Forward(state_.network, input, options_.is_half_wide);
  const Layout& layout = state_.network->layout;
  Loss loss = DetectionLoss(maps, batch, layout, options_.loss);
  if (!options_.teacher) return loss;
  std::array<torch::Tensor, 3> taught;
  {
    const torch::NoGradGuard no_grad;
    taught = Forward(options_.teacher->network, input, options_.is_half_wide);
  }
  const torch::Tensor term =
      options_.teacher_weight * DistillationLoss(maps, taught, batch, layout, *options_.teacher, options_.loss);
  loss.teacher = term.item<double>() / static_cast<double>(batch.pictures.size(0));
  loss.total = loss.total + term;
  return loss;
}

Loss Trainer::Step(const Batch& batch, double rate) {
  state_.network->train();
  SetRate(state_, rate);
  const Loss loss = LossOf(batch);
  state_.optimizer->zero_grad();
  loss.total.backward();
  torch::nn::utils::clip_grad_norm_(state_.network->parameters(), kMostGradient);
  state_.optimizer->step();
  UpdateAverage(state_);
  ++state_.step;
  return loss;
}

Status Trainer::Report(const TrainReport& r) {
  std::vector<std::string> fields{std::to_string(r.step)};
  for (const double value : {r.progress, r.seconds, r.pictures_per_second}) fields.push_back(FormatFixed(value, 4));
  fields.push_back(std::to_string(r.size.width).append("x").append(std::to_string(r.size.height)));
  for (const double value : {r.rate, r.box, r.objectness, r.classes, r.teacher})
    fields.push_back(FormatFixed(value, 6));
  return AppendLine(options_.out + "/train.csv",
                    "step,progress,seconds,pictures_per_second,size,rate,box,objectness,classes,teacher", fields);
}

Status Trainer::EvaluateAll() {
  const cv::Size size = options_.schedule.phases.back().sizes.front();
  for (const WatchedSet& set : watched_) {
    const Evaluation scores = Evaluate(state_.average, *set.pictures, size, options_.device);
    double person = 0;
    for (const ClassScore& score : scores.classes) {
      if (state_.table.names[static_cast<size_t>(score.class_index)] == "person") person = score.ap50;
    }
    const std::vector<std::string> fields{std::to_string(state_.step),
                                          FormatFixed(schedule_.Progress(state_.step), 4),
                                          set.name,
                                          FormatFixed(scores.map50, 4),
                                          FormatFixed(scores.map, 4),
                                          FormatFixed(person, 4)};
    const Status written = AppendLine(options_.out + "/scores.csv", "step,progress,set,map50,map,person_ap50", fields);
    if (!written) return written;
  }
  return Status::Ok();
}

Status Trainer::Run(const std::function<void(const TrainReport&)>& report, const std::function<bool()>& should_stop) {
  const std::string checkpoint = options_.out + "/last.pt";
  BatchStream batches(loader_, state_.step, options_.num_loading_threads);
  Stopwatch since_report, since_save, since_evaluation;
  TrainReport sum;
  while (schedule_.Progress(state_.step) < 1 && !should_stop()) {
    const Batch batch = batches.Next();
    const double rate = schedule_.Rate(state_.step);
    Add(Step(batch, rate), sum);
    state_.seconds = schedule_.Seconds();
    if (state_.step % kReportSteps == 0) {
      sum = Mean(sum);
      sum.step = state_.step;
      sum.progress = schedule_.Progress(state_.step);
      sum.seconds = state_.seconds;
      sum.pictures_per_second = static_cast<double>(sum.num_steps * batch.pictures.size(0)) / since_report.seconds();
      sum.size = cv::Size(static_cast<int>(batch.pictures.size(2)), static_cast<int>(batch.pictures.size(1)));
      sum.rate = rate * state_.options.rate;
      report(sum);
      if (const Status done = Report(sum); !done) return done;
      sum = TrainReport();
      since_report = Stopwatch();
    }
    if (since_save.seconds() > options_.save_every_s) {
      if (const Status done = SaveCheckpoint(checkpoint, state_); !done) return done;
      since_save = Stopwatch();
    }
    if (since_evaluation.seconds() > options_.evaluate_every_s) {
      if (const Status done = EvaluateAll(); !done) return done;
      since_evaluation = Stopwatch();
      since_report = Stopwatch();
    }
  }
  if (const Status done = SaveCheckpoint(checkpoint, state_); !done) return done;
  return EvaluateAll();
}

}  // namespace yorb
