// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/batch_stream.h"

#include <gtest/gtest.h>

#include "pictures/test_folder.h"
#include "training/test_shapes.h"

namespace yorb {
namespace {

TEST(BatchStream, GivesTheBatchesOfTheStepsInOrderHoweverManyMakeThem) {
  const TestFolder folder;
  const ClassTable table{{"disc", "square"}, {"", ""}};
  const auto pack = MakeShapePack(folder.Path("shapes.pack"), 12, 1);
  const auto pictures = std::make_shared<Composer>(std::vector<std::shared_ptr<const Pack>>{pack}, table);
  LoaderOptions options;
  options.batch_size = 5;  // so that a batch reaches into the next round through the pictures
  Loader loader(pictures, {}, table, options, [](int64_t step) { return cv::Size(step % 2 == 0 ? 96 : 128, 64); });
  constexpr int64_t kFirst = 4;
  for (const int num_threads : {1, 2, 3, 5}) {
    BatchStream stream(loader, kFirst, num_threads);
    for (int64_t step = kFirst; step < kFirst + 7; ++step) {
      const Batch batch = stream.Next(), wanted = loader.Make(step);
      EXPECT_TRUE(torch::equal(batch.pictures, wanted.pictures)) << num_threads << " threads, step " << step;
      ASSERT_EQ(batch.targets.size(), wanted.targets.size());
      for (size_t i = 0; i < batch.targets.size(); ++i)
        EXPECT_EQ(batch.targets[i].box.left, wanted.targets[i].box.left);
    }
  }
}

}  // namespace
}  // namespace yorb
