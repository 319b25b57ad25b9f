// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "places/vocabulary_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/files.h"
#include "core/text.h"
#include "places/test_descriptors.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class VocabularyIo : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / (std::string("yorb_vocabulary_") + info->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string PathOf(const std::string& name) const { return (folder_ / name).string(); }

  std::string Write(const std::string& name, const std::string& content) const {
    std::ofstream(PathOf(name), std::ios::binary) << content;
    return PathOf(name);
  }

  static std::string BytesOf(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << stream.rdbuf();
    return bytes.str();
  }

  /// The complaint about a file of this content; empty where it is read.
  std::string ComplaintOf(const std::string& content) const {
    const auto read = ReadVocabulary(Write("spoilt.txt", content));
    if (read) return "";
    EXPECT_THAT(read.error().message, HasSubstr("spoilt.txt"));
    EXPECT_EQ(read.error().kind, Error::Kind::kBadInput);
    return read.error().message;
  }

  fs::path folder_;
};

std::string RowOf(uint32_t parent, bool is_word, const Descriptor& centre, float weight) {
  unsigned char bytes[32];
  std::memcpy(bytes, centre.data(), sizeof bytes);
  std::string row = std::to_string(parent) + (is_word ? " 1" : " 0");
  for (const unsigned char byte : bytes) row += " " + std::to_string(byte);
  return row + " " + FormatShortest(weight);
}

/// The vocabulary as DBoW2 writes it, depth first in groups: the children of a node, then what is below each of them.
void AddRows(const VocabularyTree& tree, const std::vector<size_t>& first_child, const std::vector<size_t>& word_of,
             size_t node, uint32_t number, std::vector<std::string>& rows) {
  const size_t count = tree.num_children[node];
  std::vector<uint32_t> numbers;
  for (size_t child = first_child[node]; child < first_child[node] + count; ++child) {
    const bool is_word = tree.num_children[child] == 0;
    rows.push_back(RowOf(number, is_word, tree.centres[child], is_word ? tree.word_weights[word_of[child]] : 0));
    numbers.push_back(static_cast<uint32_t>(rows.size()));
  }
  for (size_t i = 0; i < count; ++i) AddRows(tree, first_child, word_of, first_child[node] + i, numbers[i], rows);
}

std::vector<std::string> RowsOf(const Vocabulary& vocabulary) {
  const VocabularyTree& tree = vocabulary.tree();
  std::vector<size_t> first_child, word_of;
  size_t next = 1, word = 0;
  for (const uint8_t count : tree.num_children) {
    first_child.push_back(next);
    word_of.push_back(count == 0 ? word++ : 0);
    next += count;
  }
  std::vector<std::string> rows;
  AddRows(tree, first_child, word_of, 0, 0, rows);
  return rows;
}

std::string TextOf(const Vocabulary& vocabulary, const std::vector<std::string>& rows, const std::string& end = "\n") {
  std::string text = std::to_string(vocabulary.branching()) + " " + std::to_string(vocabulary.levels()) + " 0 0" + end;
  for (const std::string& row : rows) text += row + end;
  return text;
}

TEST_F(VocabularyIo, OwnFormatComesBackToTheBit) {
  const VocabularyPtr vocabulary = SmallVocabulary();
  ASSERT_TRUE(WriteVocabulary(*vocabulary, PathOf("a.yvoc")));
  const auto read = ReadVocabulary(PathOf("a.yvoc"));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ((*read)->digest(), vocabulary->digest());
  EXPECT_EQ((*read)->tree().centres, vocabulary->tree().centres);
  EXPECT_EQ((*read)->tree().word_weights, vocabulary->tree().word_weights);
}

TEST_F(VocabularyIo, EveryCutAndEveryFlippedByteIsRefused) {
  ASSERT_TRUE(WriteVocabulary(*SmallVocabulary(), PathOf("a.yvoc")));
  const std::string bytes = BytesOf(PathOf("a.yvoc"));
  Random random(1);
  for (size_t at = 0; at < bytes.size(); at += at < 64 ? 1 : 499) {
    std::string flipped = bytes;
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << random.Below(8)));
    EXPECT_NE(ComplaintOf(flipped), "") << "byte " << at;
    EXPECT_NE(ComplaintOf(bytes.substr(0, at)), "") << "cut to " << at;
  }
  EXPECT_THAT(ComplaintOf(bytes + "x"), HasSubstr("damaged"));
  std::string newer = bytes;
  newer[8] = 2;
  EXPECT_THAT(ComplaintOf(newer), HasSubstr("format 2"));
}

TEST_F(VocabularyIo, TextOfDbow2GivesTheSameVocabulary) {
  const VocabularyPtr vocabulary = SmallVocabulary();
  const auto rows = RowsOf(*vocabulary);
  for (const std::string end : {"\n", "\r\n", " \r\n\n"}) {
    const auto read = ReadVocabulary(Write("voc.txt", TextOf(*vocabulary, rows, end)));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ((*read)->digest(), vocabulary->digest());
  }
  EXPECT_EQ(ComplaintOf("\xef\xbb\xbf" + TextOf(*vocabulary, rows) + "# the end\n"), "");
}

TEST_F(VocabularyIo, BadLinesAreNamedByTheirNumber) {
  const VocabularyPtr vocabulary = SmallVocabulary();
  const auto rows = RowsOf(*vocabulary);
  const auto spoilt = [&](size_t line, const std::string& row) {
    auto changed = rows;
    changed[line - 2] = row;
    return ComplaintOf(TextOf(*vocabulary, changed));
  };
  const std::string good = rows[28];
  EXPECT_EQ(spoilt(30, good), "");
  EXPECT_THAT(spoilt(30, good.substr(0, good.size() / 2)), HasSubstr("line 30"));
  EXPECT_THAT(spoilt(30, good + " 7"), HasSubstr("line 30"));
  EXPECT_THAT(spoilt(30, "x" + good), HasSubstr("line 30"));
  EXPECT_THAT(spoilt(30, "9999" + good), HasSubstr("line 30"));
  EXPECT_THAT(spoilt(30, "-1" + good), HasSubstr("line 30"));
  EXPECT_THAT(spoilt(30, RowOf(0, true, {}, 1)), HasSubstr("line 30"));  // the root's seventh child
  EXPECT_THAT(spoilt(30, RowOf(1, false, {}, 1) + "e999"), HasSubstr("line 30"));
  EXPECT_THAT(spoilt(2, RowOf(0, true, {}, 1)), HasSubstr("is a word and has no children"));
  auto deep = rows;
  deep.push_back(RowOf(static_cast<uint32_t>(rows.size()), true, {}, 1));
  EXPECT_THAT(ComplaintOf(TextOf(*vocabulary, deep)), HasSubstr("line " + std::to_string(rows.size() + 2)));
}

TEST_F(VocabularyIo, ATextCutAtALineEndIsRefused) {
  const VocabularyPtr vocabulary = SmallVocabulary();
  const auto rows = RowsOf(*vocabulary);
  for (const size_t kept : {size_t{0}, size_t{3}, size_t{6}, size_t{20}, rows.size() / 2}) {
    const std::vector<std::string> part(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(kept));
    EXPECT_THAT(ComplaintOf(TextOf(*vocabulary, part)), HasSubstr("cut")) << kept;
  }
}

TEST_F(VocabularyIo, OtherFilesAreRefused) {
  EXPECT_THAT(ComplaintOf(""), HasSubstr("empty"));
  EXPECT_THAT(ComplaintOf("k=10 L=2\n"), HasSubstr("line 1"));
  EXPECT_THAT(ComplaintOf("%YAML:1.0\nvocabulary:\n"), HasSubstr("line 1"));
  EXPECT_THAT(ComplaintOf("10 6 0 0 0\n"), HasSubstr("line 1"));
  EXPECT_THAT(ComplaintOf("1000000 6 0 0\n"), HasSubstr("line 1"));
  EXPECT_THAT(ComplaintOf(std::string("\xff\xd8\0\0\0", 5)), HasSubstr("zero bytes"));
  EXPECT_FALSE(ReadVocabulary(PathOf("missing.txt")));
  EXPECT_FALSE(ReadVocabulary(folder_.string()));
}

TEST_F(VocabularyIo, WhatCannotBeWrittenIsAFailure) {
  const Status written = WriteVocabulary(*SmallVocabulary(), "/dev/null/a.yvoc");
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, HasSubstr("/dev/null"));
}

}  // namespace
}  // namespace yorb
