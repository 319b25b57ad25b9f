// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/iou.h"

#include <gtest/gtest.h>

namespace yorb {
namespace {

struct Area {
  double left, top, right, bottom;
};

TEST(IoU, IsSharedOverCoveredArea) {
  const Area square{0, 0, 10, 10};
  EXPECT_DOUBLE_EQ(IoU(square, square), 1);
  EXPECT_DOUBLE_EQ(IoU(square, Area{5, 0, 15, 10}), 50.0 / 150);
  EXPECT_DOUBLE_EQ(IoU(Area{5, 0, 15, 10}, square), 50.0 / 150);
  EXPECT_DOUBLE_EQ(IoU(square, Area{10, 0, 20, 10}), 0) << "side by side";
  EXPECT_DOUBLE_EQ(IoU(Area{0, 0, 0, 0}, Area{0, 0, 0, 0}), 0);
}

}  // namespace
}  // namespace yorb
