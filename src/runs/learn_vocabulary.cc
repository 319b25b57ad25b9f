// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/learn_vocabulary.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/log.h"
#include "core/parallel.h"
#include "runs/picture_source.h"

namespace yorb {
namespace {

using Sources = std::vector<std::unique_ptr<PictureSource>>;
using Described = std::vector<std::vector<Descriptor>>;

Result<Sources> OpenAll(const std::vector<std::string>& paths) {
  Sources sources;
  for (const std::string& path : paths) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) return BadInput(path + " does not exist");
    auto source = OpenPictureSource(path);
    if (!source) return source.error();
    sources.push_back(*std::move(source));
  }
  return sources;
}

size_t NumLeftOf(const Sources& sources) {
  size_t sum = 0;
  for (const auto& source : sources) {
    if (source->HasNext() && source->NumLeft() == 0) return 0;
    sum += source->NumLeft();
  }
  return sum;
}

cv::Mat GreyOf(const cv::Mat& pixels) {
  if (pixels.channels() == 1) return pixels;
  cv::Mat grey;
  cv::cvtColor(pixels, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

/// Reads pictures and keeps the descriptors of so many at most: whenever there are more, every second one goes, and
/// from then on half as many are taken.
class Collector {
 public:
  Collector(Sources sources, const LearningOptions& options, const LearningHooks& hooks)
      : sources_(std::move(sources)), options_(options), hooks_(hooks), num_all_(NumLeftOf(sources_)) {}

  /// Of all pictures that can be read, or of those until it was told to stop.
  Described Collect() {
    constexpr size_t kBatch = 64;
    std::vector<cv::Mat> batch;
    for (const auto& source : sources_) {
      while (source->HasNext()) {
        if (hooks_.should_stop && hooks_.should_stop()) return {};
        if (cv::Mat grey = Read(*source); !grey.empty()) batch.push_back(std::move(grey));
        if (batch.size() == kBatch) Describe(std::exchange(batch, {}));
      }
    }
    Describe(batch);
    return std::move(described_);
  }

 private:
  /// The next picture in grey; an empty one where it is passed over or cannot be read.
  cv::Mat Read(PictureSource& source) {
    const auto picture = source.Next();
    const bool is_wanted = num_read_++ % stride_ == 0;
    if (!picture) LogWarning("picture-skipped", picture.error().message + "; it is left out");
    return picture && is_wanted ? GreyOf(picture->pixels) : cv::Mat();
  }

  void Describe(const std::vector<cv::Mat>& batch) {
    const auto num_parts = static_cast<size_t>(std::max(1, options_.training.num_threads));
    const size_t first = described_.size();
    described_.resize(first + batch.size());
    ParallelFor(num_parts, options_.training.num_threads, [&](size_t part) {
      OrbExtractor extractor(options_.features);
      for (size_t i = part; i < batch.size(); i += num_parts)
        described_[first + i] = extractor.Extract(batch[i]).descriptors;
    });
    while (described_.size() > std::max<size_t>(1, options_.most_pictures)) ThinOut();
    if (hooks_.on_pictures) hooks_.on_pictures(num_read_, num_all_);
  }

  void ThinOut() {
    for (size_t i = 0; 2 * i < described_.size(); ++i) std::swap(described_[i], described_[2 * i]);
    described_.resize((described_.size() + 1) / 2);
    stride_ *= 2;
  }

  Sources sources_;
  const LearningOptions& options_;
  const LearningHooks& hooks_;
  size_t num_all_ = 0, num_read_ = 0, stride_ = 1;
  Described described_;
};

}  // namespace

Result<LearntVocabulary> LearnVocabulary(const std::vector<std::string>& paths, const LearningOptions& options,
                                         const LearningHooks& hooks) {
  auto sources = OpenAll(paths);
  if (!sources) return sources.error();
  const Described described = Collector(*std::move(sources), options, hooks).Collect();
  if (hooks.should_stop && hooks.should_stop()) return Failure("the training was stopped");
  auto vocabulary = TrainVocabulary(described, options.training, {hooks.on_training, hooks.should_stop});
  if (!vocabulary) return vocabulary.error();
  LearntVocabulary learnt;
  learnt.vocabulary = *std::move(vocabulary);
  learnt.num_pictures = described.size();
  for (const auto& picture : described) learnt.num_points += picture.size();
  return learnt;
}

}  // namespace yorb
