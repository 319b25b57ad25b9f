// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/class_names.h"

#include <gtest/gtest.h>

namespace yorb {
namespace {

using Names = std::vector<std::string>;

TEST(ClassNames, DictsAndListsOfPythonAndJsonAreRead) {
  const Names wanted{"tv", "driver's seat", "cup, mug", "扇子"};
  EXPECT_EQ(ParseClassNames(R"({0: 'tv', 1: "driver's seat", 2: 'cup, mug', 3: '扇子'})"), wanted);
  EXPECT_EQ(ParseClassNames(R"(['tv', "driver's seat", 'cup, mug', '扇子'])"), wanted);
  EXPECT_EQ(ParseClassNames(R"(["tv", "driver's seat", "cup, mug", "\u6247\u5b50"])"), wanted);
  EXPECT_EQ(ParseClassNames(R"({"0": "tv", "1": "driver's seat", "2": "cup, mug", "3": "扇子"})"), wanted);
  EXPECT_EQ(ParseClassNames("('tv', 'driver\\'s seat', 'cup, mug', '扇子')"), wanted);
  EXPECT_EQ(ParseClassNames("[ person , potted plant ]"), (Names{"person", "potted plant"}));
  EXPECT_EQ(ParseClassNames("{0: u'tv', 1: b'cup', 2: np.str_('bus'), 3: numpy.str_(\"u\"),}"),
            (Names{"tv", "cup", "bus", "u"}));
  EXPECT_EQ(ParseClassNames("[bus, ub, np.str_]"), (Names{"bus", "ub", "np.str_"}));
}

TEST(ClassNames, WhatIsWrittenIsReadAgainWhateverIsInTheNames) {
  EXPECT_EQ(ClassNamesText({"person", "dining table"}), "{0: 'person', 1: 'dining table'}");
  const Names odd{"driver's seat", "back\\slash", "\"quoted\"", "cup, mug", "{0: 'a'}", "扇子"};
  EXPECT_EQ(ParseClassNames(ClassNamesText(odd)), odd);
}

TEST(ClassNames, NumbersMayStandInAnyOrderButNoneMayBeMissing) {
  EXPECT_EQ(ParseClassNames("{1: 'b', 0: 'a'}"), (Names{"a", "b"}));
  EXPECT_FALSE(ParseClassNames("{0: 'a', 2: 'c'}"));
  EXPECT_FALSE(ParseClassNames("{1: 'a'}"));
  for (const char* text : {"", "person", "{", "[", "{0}", "{0: 'a'", "[]", "{}", "['a'] and more", "['a' 'b']",
                           "[a,,b]", "{0: , 1: 'b'}", R"([{"id": 0, "name": "a"}])", "[a}, b]", "['a"})
    EXPECT_FALSE(ParseClassNames(text)) << text;
}

TEST(ClassNames, CaseBlanksUnderscoresAndHyphensDoNotCount) {
  EXPECT_EQ(FoldClassName("Dining table"), FoldClassName("dining_table"));
  EXPECT_EQ(FoldClassName(" PERSON "), "person");
  EXPECT_NE(FoldClassName("cup"), FoldClassName("cups"));
}

TEST(ClassNames, CocoHasEightyInItsOrder) {
  ASSERT_EQ(CocoNames().size(), 80u);
  EXPECT_EQ(CocoNames()[0], "person");
  EXPECT_EQ(CocoNames()[60], "dining table");
  EXPECT_EQ(CocoNames()[79], "toothbrush");
}

TEST(ClassNames, NumbersAreFoundInAnyText) {
  EXPECT_EQ(NumbersIn("[640, 480]"), (std::vector<double>{640, 480}));
  EXPECT_EQ(NumbersIn("((10,13),(16.5,30))"), (std::vector<double>{10, 13, 16.5, 30}));
  EXPECT_TRUE(NumbersIn("none").empty());
}

}  // namespace
}  // namespace yorb
