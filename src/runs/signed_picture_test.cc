// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/signed_picture.h"

#include <gtest/gtest.h>

#include "pictures/test_folder.h"

namespace yorb {
namespace {

TEST(SignedPicture, IsTheSamePictureAndKnownAgain) {
  const TestFolder folder;
  for (const char* name : {"a.png", "a.jpg"}) {
    const std::string plain = *EncodePictureFor(name, TestColour(1)), file = SignedPicture(plain, "source");
    EXPECT_NE(file, plain);
    folder.Write("plain_" + std::string(name), plain);
    folder.Write(name, file);
    const StoredPicture read = ReadPictureFile(folder.Path(name));
    ASSERT_EQ(read.fault, "") << name;
    EXPECT_EQ(cv::norm(read.pixels, ReadPictureFile(folder.Path("plain_" + std::string(name))).pixels, cv::NORM_INF),
              0);
    EXPECT_TRUE(IsSignedPicture(file, "source")) << name;
    EXPECT_FALSE(IsSignedPicture(file, "another source"));
    EXPECT_FALSE(IsSignedPicture(plain, "source"));
  }
}

TEST(SignedPicture, AnyChangeMakesItSomebodyElses) {
  for (const char* name : {"a.png", "a.jpg"}) {
    const std::string file = SignedPicture(*EncodePictureFor(name, TestColour(1, 20, 15)), "source");
    for (size_t i = 0; i < file.size(); ++i) {
      std::string changed = file;
      changed[i] = static_cast<char>(changed[i] ^ 1);
      EXPECT_FALSE(IsSignedPicture(changed, "source")) << name << ", byte " << i;
      EXPECT_FALSE(IsSignedPicture(file.substr(0, i), "source")) << name << ", cut at " << i;
    }
  }
  EXPECT_FALSE(IsSignedPicture("", "source"));
  EXPECT_FALSE(IsSignedPicture("somebody's", "source"));
}

}  // namespace
}  // namespace yorb
