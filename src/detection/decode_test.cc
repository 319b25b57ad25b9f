// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/decode.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"

namespace yorb {
namespace {

/// Numbers with a shape.
struct Tensor {
  std::vector<int64_t> dims;
  std::vector<float> numbers;

  explicit Tensor(std::vector<int64_t> shape) : dims(std::move(shape)) {
    int64_t size = 1;
    for (const int64_t dim : dims) size *= dim;
    numbers.assign(static_cast<size_t>(size), 0.f);
  }
  TensorView View() const { return {numbers.data(), dims, DenseStrides(dims)}; }
};

HeadLayout LayoutOf(const std::vector<Tensor>& tensors, int num_names, int width = 64, int height = 64) {
  HeadFacts facts{{}, width, height, num_names, 0};
  for (const Tensor& tensor : tensors) facts.shapes.push_back(tensor.dims);
  return *RecogniseLayout(facts);
}

Result<std::vector<RawBox>> TryToDecode(const std::vector<Tensor>& tensors, int num_names, const DecodeOptions& options,
                                        int width = 64, int height = 64) {
  std::vector<TensorView> views;
  for (const Tensor& tensor : tensors) views.push_back(tensor.View());
  return DecodeBoxes(views, LayoutOf(tensors, num_names, width, height), options);
}

std::vector<RawBox> Decode(const std::vector<Tensor>& tensors, int num_names, const DecodeOptions& options,
                           int width = 64, int height = 64) {
  const auto boxes = TryToDecode(tensors, num_names, options, width, height);
  EXPECT_TRUE(boxes) << boxes.error().message;
  return boxes ? *boxes : std::vector<RawBox>();
}

std::string Complaint(const Tensor& tensor, const DecodeOptions& options = {}) {
  const auto boxes = TryToDecode({tensor}, 2, options);
  return boxes ? "" : boxes.error().message;
}

void ExpectBox(const RawBox& box, const RawBox& wanted) {
  EXPECT_EQ(box.label, wanted.label);
  EXPECT_NEAR(box.confidence, wanted.confidence, 1e-5);
  EXPECT_NEAR(box.left, wanted.left, 1e-3);
  EXPECT_NEAR(box.top, wanted.top, 1e-3);
  EXPECT_NEAR(box.right, wanted.right, 1e-3);
  EXPECT_NEAR(box.bottom, wanted.bottom, 1e-3);
}

TEST(Decode, YoloFiveMultipliesObjectnessAndClass) {
  Tensor rows({1, 252, 7});
  const float row[] = {30, 20, 10, 8, 0.8f, 0.1f, 0.5f};
  std::copy(row, row + 7, rows.numbers.begin() + 7 * 100);
  const auto boxes = Decode({rows}, 2, {});
  ASSERT_EQ(boxes.size(), 1u);
  ExpectBox(boxes[0], {25, 16, 35, 24, 0.4f, 1});
}

TEST(Decode, YoloEightHasItsBoxesInColumns) {
  Tensor columns({1, 6, 84});
  const float column[] = {30, 20, 10, 8, 0.7f, 0.6f};
  for (size_t k = 0; k < 6; ++k) columns.numbers[k * 84 + 50] = column[k];
  DecodeOptions options;
  auto boxes = Decode({columns}, 2, options);
  ASSERT_EQ(boxes.size(), 1u);
  ExpectBox(boxes[0], {25, 16, 35, 24, 0.7f, 0});
  options.takes_all_classes = true;
  boxes = Decode({columns}, 2, options);
  ASSERT_EQ(boxes.size(), 2u);
  ExpectBox(boxes[1], {25, 16, 35, 24, 0.6f, 1});
}

TEST(Decode, EndToEndHasCornersScoreAndClass) {
  Tensor rows({1, 300, 6});
  const float good[] = {1, 2, 11, 22, 0.9f, 3}, unknown[] = {1, 2, 11, 22, 0.9f, 12}, weak[] = {1, 2, 11, 22, 0.1f, 3};
  std::copy(good, good + 6, rows.numbers.begin());
  std::copy(unknown, unknown + 6, rows.numbers.begin() + 6);
  std::copy(weak, weak + 6, rows.numbers.begin() + 12);
  const auto boxes = Decode({rows}, 10, {});
  ASSERT_EQ(boxes.size(), 1u);
  ExpectBox(boxes[0], {1, 2, 11, 22, 0.9f, 3});
}

TEST(Decode, ClassNumbersAreWhole) {
  Tensor rows({1, 300, 6});
  rows.numbers[5] = 3;
  EXPECT_TRUE(HaveClassNumbers(rows.View()));
  rows.numbers[11] = 0.4f;  // a score
  EXPECT_FALSE(HaveClassNumbers(rows.View()));
}

TEST(Decode, PlacesThatAreNoNumbersAreLeftOut) {
  Tensor rows({1, 252, 7});
  const float nowhere[] = {30, INFINITY, 10, 8, 0.8f, 0.1f, 0.9f}, none[] = {NAN, 20, 10, 8, 0.8f, 0.1f, 0.9f};
  std::copy(nowhere, nowhere + 7, rows.numbers.begin());
  std::copy(none, none + 7, rows.numbers.begin() + 7);
  EXPECT_TRUE(Decode({rows}, 2, {}).empty());
}

constexpr const char *kNoNumbers = "no numbers", *kNoProbabilities = "no probabilities";

TEST(Decode, ObjectnessThatIsNoProbabilityIsRefused) {
  for (const auto& [score, complaint] :
       {std::pair(NAN, kNoNumbers), std::pair(-6.f, kNoProbabilities), std::pair(1.02f, kNoProbabilities)}) {
    Tensor rows({1, 252, 7});
    rows.numbers[7 * 100 + 4] = score;
    EXPECT_THAT(Complaint(rows), testing::HasSubstr(complaint)) << score;
  }
  Tensor rows({1, 252, 7});
  const float row[] = {30, 20, 10, 8, 0.9f, -7, -6};  // the classes alone are logits
  std::copy(row, row + 7, rows.numbers.begin() + 7 * 100);
  EXPECT_THAT(Complaint(rows), testing::HasSubstr(kNoProbabilities));
}

TEST(Decode, ClassScoresThatAreNoProbabilitiesAreRefused) {
  DecodeOptions all;
  all.takes_all_classes = true;
  const auto expect = [&](float person, float cup, const char* complaint) {
    Tensor columns({1, 6, 84});
    columns.numbers[4 * 84 + 50] = person, columns.numbers[5 * 84 + 50] = cup;
    EXPECT_THAT(Complaint(columns), testing::HasSubstr(complaint)) << person << " " << cup;
    EXPECT_THAT(Complaint(columns, all), testing::HasSubstr(complaint)) << person << " " << cup;
    columns.numbers[50] = NAN;  // no place, either
    EXPECT_THAT(Complaint(columns), testing::HasSubstr(complaint)) << person << " " << cup;
  };
  expect(NAN, NAN, kNoNumbers);
  expect(-6, -5, kNoProbabilities);
  expect(254, 0, kNoProbabilities);
}

TEST(Decode, EndToEndConfidencesThatAreNoProbabilitiesAreRefused) {
  for (const auto& [score, complaint] :
       {std::pair(NAN, kNoNumbers), std::pair(-6.f, kNoProbabilities), std::pair(254.f, kNoProbabilities)}) {
    Tensor rows({1, 300, 6});
    rows.numbers[6 * 7 + 4] = score;
    EXPECT_THAT(Complaint(rows), testing::HasSubstr(complaint)) << score;
  }
  Tensor filled({1, 300, 6});
  std::fill(filled.numbers.begin() + 60, filled.numbers.end(), -1.f);
  EXPECT_EQ(Complaint(filled), "") << "some exports fill up with -1";
  Tensor none({1, 300, 6});
  std::fill(none.numbers.begin(), none.numbers.end(), NAN);
  EXPECT_TRUE(HaveClassNumbers(none.View())) << "that they are no numbers says more";
}

TEST(Decode, EndToEndRowsThatBeginWithCentresAreRefused) {
  Tensor rows({1, 300, 6});
  const float centre[] = {12, 20, 8, 8, .9f, 1}, corners[] = {8, 16, 16, 24, .8f, 1};
  std::copy(centre, centre + 6, rows.numbers.begin() + 30);
  EXPECT_THAT(Complaint(rows), testing::HasSubstr("no corners"));
  std::copy(corners, corners + 6, rows.numbers.begin() + 60);
  EXPECT_EQ(Complaint(rows), "") << "one odd box among others";
}

TEST(Decode, RowsOfCellsAreReadAsColumnsAre) {
  Tensor rows({1, 84, 7});
  const float row[] = {30, 20, 10, 8, .1f, .2f, .7f};
  std::copy(row, row + 7, rows.numbers.begin() + 7 * 40);
  const auto boxes = Decode({rows}, 3, {});
  ASSERT_EQ(boxes.size(), 1u);
  ExpectBox(boxes[0], {25, 16, 35, 24, .7f, 2});
}

TEST(Decode, ScoresALittleBesideTheirRangeAreFine) {
  Tensor columns({1, 6, 84});
  const float column[] = {30, 20, 10, 8, 1.0000001f, 0.6f};
  for (size_t k = 0; k < 6; ++k) columns.numbers[k * 84 + 50] = column[k];
  columns.numbers[4 * 84] = columns.numbers[5 * 84] = -0.004f;
  const auto boxes = Decode({columns}, 2, {});
  ASSERT_EQ(boxes.size(), 1u);
  EXPECT_EQ(boxes[0].confidence, 1);
}

TEST(Decode, BoxesWithinOnePixelLookLikeFractions) {
  const RawBox fraction{.1f, -.05f, .4f, 1.02f, .9f, 0}, box{8, 16, 16, 24, .9f, 0}, empty{0, 0, 0, 0, .9f, 0};
  EXPECT_TRUE(LookLikeFractions({fraction, empty}));
  EXPECT_FALSE(LookLikeFractions({fraction, box}));
  EXPECT_FALSE(LookLikeFractions({{-.5f, 0, 1.2f, 1, .9f, 0}})) << "wider than the picture";
  EXPECT_FALSE(LookLikeFractions({empty}));
  EXPECT_FALSE(LookLikeFractions({}));
}

/// Raw maps of 2 classes for 64x32 px, filled by chance; index(anchor, value, y, x).
std::vector<Tensor> RandomMaps() {
  Random random(5);
  std::vector<Tensor> maps;
  for (const int64_t stride : {8, 16, 32}) {
    maps.emplace_back(std::vector<int64_t>{1, 21, 32 / stride, 64 / stride});
    for (float& number : maps.back().numbers) number = static_cast<float>(random.Uniform(-4, 3));
  }
  return maps;
}

/// The formula of YOLOv5's head, cell by cell, as it is published.
std::vector<RawBox> SlowDecode(const std::vector<Tensor>& maps, double confidence) {
  const auto sigmoid = [](double x) { return 1 / (1 + std::exp(-x)); };
  std::vector<RawBox> boxes;
  for (size_t m = 0; m < maps.size(); ++m) {
    const int64_t stride = 8 << m, height = maps[m].dims[2], width = maps[m].dims[3];
    for (int64_t a = 0; a < 3; ++a) {
      for (int64_t i = 0; i < width * height; ++i) {
        const auto value = [&](int64_t k) {
          return sigmoid(maps[m].numbers[static_cast<size_t>((a * 7 + k) * width * height + i)]);
        };
        const double x = (value(0) * 2 - .5 + static_cast<double>(i % width)) * static_cast<double>(stride);
        const double y = (value(1) * 2 - .5 + static_cast<double>(i / width)) * static_cast<double>(stride);
        const double w = std::pow(value(2) * 2, 2) * StandardAnchors()[m * 6 + static_cast<size_t>(a) * 2];
        const double h = std::pow(value(3) * 2, 2) * StandardAnchors()[m * 6 + static_cast<size_t>(a) * 2 + 1];
        const int label = value(6) > value(5) ? 1 : 0;
        const double score = value(4) * value(5 + label);
        if (score < confidence) continue;
        boxes.push_back({static_cast<float>(x - w / 2), static_cast<float>(y - h / 2), static_cast<float>(x + w / 2),
                         static_cast<float>(y + h / 2), static_cast<float>(score), label});
      }
    }
  }
  return boxes;
}

TEST(Decode, RawMapsOfAnyShapeAndOrderGiveTheSameAsTheFormula) {
  const std::vector<Tensor> maps = RandomMaps();
  DecodeOptions options;
  options.anchors = StandardAnchors();
  options.is_logits = true;
  const std::vector<RawBox> wanted = SlowDecode(maps, options.confidence);
  ASSERT_GT(wanted.size(), 10u);
  std::vector<Tensor> sigmoids = maps, anchors_first, values_last;
  for (Tensor& map : sigmoids) {
    for (float& number : map.numbers) number = 1 / (1 + std::exp(-number));
  }
  for (const Tensor& map : maps) {
    const int64_t height = map.dims[2], width = map.dims[3];
    anchors_first.push_back(map);
    anchors_first.back().dims = {1, 3, 7, height, width};
    values_last.emplace_back(std::vector<int64_t>{1, 3, height, width, 7});
    for (int64_t a = 0; a < 3; ++a) {
      for (int64_t k = 0; k < 7; ++k) {
        for (int64_t i = 0; i < height * width; ++i)
          values_last.back().numbers[static_cast<size_t>((a * height * width + i) * 7 + k)] =
              map.numbers[static_cast<size_t>((a * 7 + k) * height * width + i)];
      }
    }
  }
  const auto expect = [&](const std::vector<Tensor>& tensors, bool is_logits) {
    options.is_logits = is_logits;
    const auto boxes = Decode(tensors, 2, options, 64, 32);
    ASSERT_EQ(boxes.size(), wanted.size());
    for (size_t i = 0; i < boxes.size(); ++i) ExpectBox(boxes[i], wanted[i]);
  };
  expect(maps, true);
  std::vector<Tensor> broken = maps;
  broken[1].numbers[4 * 8] = NAN;  // an objectness
  EXPECT_FALSE(TryToDecode(broken, 2, options, 64, 32));
  expect({maps[2], maps[0], maps[1]}, true);
  expect(sigmoids, false);
  expect(anchors_first, true);
  expect(values_last, true);
  const auto are_logits = [&](const std::vector<Tensor>& tensors) {
    std::vector<TensorView> views;
    for (const Tensor& tensor : tensors) views.push_back(tensor.View());
    return LookLikeLogits(views, LayoutOf(tensors, 2, 64, 32));
  };
  EXPECT_TRUE(are_logits(maps));
  EXPECT_FALSE(are_logits(sigmoids));
}

}  // namespace
}  // namespace yorb
