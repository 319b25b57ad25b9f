// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/group_boxes.h"

#include <gtest/gtest.h>

namespace yorb {
namespace {

LabelBox Box(float cx, float cy, float width, float height, int16_t class_index = 0) {
  return {cx, cy, width, height, class_index, 0};
}

TEST(DoubtGroups, ABoxAroundSeveralOfItsKindIsAGroup) {
  std::vector<LabelBox> boxes{Box(.5f, .5f, .8f, .4f), Box(.3f, .5f, .1f, .3f), Box(.6f, .5f, .1f, .3f)};
  DoubtGroups(boxes);
  EXPECT_TRUE(boxes[0].is_doubtful);
  EXPECT_FALSE(boxes[1].is_doubtful);
  EXPECT_FALSE(boxes[2].is_doubtful);
}

TEST(DoubtGroups, OneWithinAnotherIsNoGroup) {
  std::vector<LabelBox> child{Box(.5f, .5f, .4f, .8f), Box(.5f, .6f, .2f, .3f)};
  std::vector<LabelBox> twins{Box(.5f, .5f, .4f, .8f), Box(.5f, .5f, .38f, .76f), Box(.5f, .5f, .39f, .78f)};
  std::vector<LabelBox> others{Box(.5f, .5f, .8f, .4f), Box(.3f, .5f, .1f, .3f, 1), Box(.6f, .5f, .1f, .3f, 1)};
  std::vector<LabelBox> beside{Box(.3f, .5f, .4f, .4f), Box(.5f, .5f, .2f, .3f), Box(.6f, .5f, .1f, .3f)};
  for (auto* boxes : {&child, &twins, &others, &beside}) {
    DoubtGroups(*boxes);
    for (const LabelBox& box : *boxes) EXPECT_FALSE(box.is_doubtful);
  }
}

}  // namespace
}  // namespace yorb
