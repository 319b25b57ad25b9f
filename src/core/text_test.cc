// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <clocale>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <thread>

#include "core/random.h"

namespace yorb {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class TextFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("yorb text " + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string Write(const std::string& content) const {
    const std::string path = (folder_ / "a list.txt").string();
    std::ofstream(path, std::ios::binary) << content;
    return path;
  }

  static std::vector<std::string> Texts(const TextFile& file) {
    std::vector<std::string> texts;
    for (const auto& line : file.lines) texts.push_back(line.text);
    return texts;
  }

  std::filesystem::path folder_;
};

TEST_F(TextFiles, SkipMarksCommentsAndBlanksAndKeepLineNumbers) {
  const auto file = ReadTextFile(Write("\xef\xbb\xbf# a header\r\n\r\n  1 2\t3 \t\r\n   \t\n#\n  # note\nlast"));
  ASSERT_TRUE(file.ok());
  EXPECT_THAT(Texts(*file), ElementsAre("1 2\t3", "last"));
  EXPECT_THAT(file->comments, ElementsAre("# a header", "#", "# note"));
  EXPECT_EQ(file->lines[0].number, 3);
  EXPECT_EQ(file->lines[1].number, 7);
  EXPECT_EQ(file->Where(file->lines[1]), file->path + ", line 7");
}

TEST_F(TextFiles, HaveTheSameLinesWithAndWithoutALastNewline) {
  EXPECT_THAT(Texts(*ReadTextFile(Write("a\nb"))), ElementsAre("a", "b"));
  EXPECT_THAT(Texts(*ReadTextFile(Write("a\nb\n"))), ElementsAre("a", "b"));
  EXPECT_THAT(Texts(*ReadTextFile(Write("a\r\nb\r\n"))), ElementsAre("a", "b"));
}

TEST_F(TextFiles, MayBeEmpty) {
  EXPECT_THAT(ReadTextFile(Write(""))->lines, IsEmpty());
  EXPECT_THAT(ReadTextFile(Write("\xef\xbb\xbf"))->lines, IsEmpty());
}

TEST_F(TextFiles, AreRefusedByNameWhereTheyAreNone) {
  const std::string missing = (folder_ / "missing.txt").string();
  EXPECT_EQ(ReadTextFile(missing).error().message, missing + " does not exist");
  EXPECT_EQ(ReadTextFile(missing).error().kind, Error::Kind::kBadInput);
  EXPECT_THAT(ReadTextFile(folder_.string()).error().message, HasSubstr("is a folder"));
  EXPECT_THAT(ReadTextFile(Write(std::string("1 2\0 3\n", 7))).error().message, HasSubstr("zero bytes"));
}

TEST_F(TextFiles, AreReadWholeFromAPipe) {  // as `--camera <(...)` hands them over
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const std::string many(300'000, 'x');
  std::thread writer([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    for (size_t done = 0; done < many.size();) {
      const ssize_t count = ::write(ends[1], many.data() + done, many.size() - done);
      if (count <= 0) break;
      done += static_cast<size_t>(count);
    }
    ::close(ends[1]);
  });
  EXPECT_EQ(*ReadWholeText("/dev/fd/" + std::to_string(ends[0])), many);
  writer.join();
  ::close(ends[0]);
}

TEST_F(TextFiles, AreNotWaitedForWhereNobodyWrites) {
  const std::string pipe = (folder_ / "pipe").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(*ReadWholeText(pipe), "");
}

TEST(Text, OneLineHasNoControlCharactersAndABearableLength) {
  EXPECT_EQ(OneLine("a\nb\tc\x1b[1m"), "a b c [1m");
  EXPECT_EQ(OneLine("Küche 測定"), "Küche 測定");
  std::string letters;
  for (int i = 0; i < 4000; ++i) letters += "ü";
  for (const std::string& text : {letters, "x" + letters, letters + "x"}) {
    const std::string line = OneLine(text);
    EXPECT_LE(line.size(), 2000u);
    for (const char c : line) EXPECT_TRUE(c == 'x' || c == ' ' || c == '.' || (c & 0x80)) << c;
    EXPECT_EQ(std::count(line.begin(), line.end(), '\xc3'), std::count(line.begin(), line.end(), '\xbc'))
        << "whole letters";
  }
}

TEST(Text, TrimTakesBlanksAndLineEndsFromBothEnds) {
  EXPECT_EQ(Trim(" \t a b\r\n"), "a b");
  EXPECT_EQ(Trim(" \t\r\n"), "");
  EXPECT_EQ(Trim(""), "");
}

TEST(Text, SplitAtBlanksTakesRunsAsOne) {
  EXPECT_THAT(SplitAtBlanks("  a\t\tb  c\r"), ElementsAre("a", "b", "c"));
  EXPECT_THAT(SplitAtBlanks(" \t"), IsEmpty());
  EXPECT_THAT(SplitAtBlanks("one"), ElementsAre("one"));
}

TEST(Text, SplitAtKeepsEmptyFields) {
  EXPECT_THAT(SplitAt("a,,b", ','), ElementsAre("a", "", "b"));
  EXPECT_THAT(SplitAt(" a , b ", ','), ElementsAre("a", "b"));
  EXPECT_THAT(SplitAt("", ','), ElementsAre(""));
  EXPECT_THAT(SplitAt(",", ','), ElementsAre("", ""));
}

TEST(Text, ParseDoubleReadsAWholeFieldAndNothingElse) {
  EXPECT_EQ(ParseDouble("1.5"), 1.5);
  EXPECT_EQ(ParseDouble("+1.5"), 1.5);
  EXPECT_EQ(ParseDouble("-1.5e-3"), -1.5e-3);
  EXPECT_EQ(ParseDouble("1E3"), 1000.0);
  EXPECT_EQ(ParseDouble(".5"), 0.5);
  EXPECT_TRUE(std::isnan(ParseDouble("nan").value_or(0)));
  EXPECT_TRUE(std::isinf(ParseDouble("-inf").value_or(0)));
  for (const char* text : {"", "+", "-", "+-1", "--1", "1,5", "1.5 ", " 1.5", "1.5f", "1e", "0x10", "abc"}) {
    EXPECT_FALSE(ParseDouble(text)) << '"' << text << '"';
  }
}

TEST(Text, NumbersBeyondADoubleAreInfinityOrZero) {
  const std::string zeros(400, '0');
  for (const std::string& text :
       std::vector<std::string>{"1e400", "0.001e400", "1" + zeros, "1" + zeros + ".5e-10", "1e99999999999999999999"}) {
    EXPECT_EQ(ParseDouble(text), HUGE_VAL) << text;
    EXPECT_EQ(ParseDouble("-" + text), -HUGE_VAL) << text;
  }
  for (const std::string& text :
       std::vector<std::string>{"1e-400", "1000e-400", "0." + zeros + "1", "1e-99999999999999999999", "0e400"}) {
    EXPECT_EQ(ParseDouble(text), 0.0) << text;
    EXPECT_EQ(ParseDouble("-" + text), 0.0) << text;
  }
}

TEST(Text, ParseIntegerReadsAWholeFieldAndNothingElse) {
  EXPECT_EQ(ParseInteger("-12"), -12);
  EXPECT_EQ(ParseInteger("+12"), 12);
  EXPECT_EQ(ParseInteger("9223372036854775807"), std::numeric_limits<long long>::max());
  for (const char* text : {"", "+", "+-1", "1.0", "1e3", "9223372036854775808", "12a", " 1"}) {
    EXPECT_FALSE(ParseInteger(text)) << '"' << text << '"';
  }
}

TEST(Text, WholeNumberTakesNoFractions) {
  EXPECT_EQ(WholeNumber(-3.0), -3);
  EXPECT_EQ(WholeNumber(0.0), 0);
  const double infinite = std::numeric_limits<double>::infinity(), none = std::nan("");
  for (const double number : {0.5, 1e9, infinite, -infinite, none}) EXPECT_FALSE(WholeNumber(number)) << number;
}

TEST(Text, ShortestTextReadsBackToTheBit) {
  Random random(5);
  for (int i = 0; i < 10000; ++i) {
    const double value = random.Gaussian() * std::pow(10.0, random.Uniform(-20, 20));
    ASSERT_EQ(ParseDouble(FormatShortest(value)), value);
  }
  EXPECT_EQ(FormatShortest(0.1), "0.1");
}

TEST(Text, FixedTextHasItsDecimals) {
  EXPECT_EQ(FormatFixed(1.5, 3), "1.500");
  EXPECT_EQ(FormatFixed(-0.125, 2), "-0.12");
  EXPECT_EQ(FormatFixed(3, 0), "3");
  EXPECT_EQ(FormatFixed(1e300, 0).size(), 301u);
  EXPECT_EQ(ParseDouble(FormatFixed(1e300, 50)).value_or(0), 1e300);
}

TEST(Text, NumbersDoNotDependOnTheLocale) {
  // Debian's minimal images have no locale with a decimal comma; then this test says the same as the ones above.
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE"}) {
    if (std::setlocale(LC_ALL, name)) break;
  }
  EXPECT_EQ(ParseDouble("1.5"), 1.5);
  EXPECT_EQ(FormatFixed(1.5, 1), "1.5");
  EXPECT_EQ(FormatShortest(1.5), "1.5");
  std::setlocale(LC_ALL, before.c_str());
}

TEST(Text, SmallLettersAreThoseOfAscii) {
  EXPECT_EQ(LowerCase("A.PnG \xc3\x84[]@Z"), "a.png \xc3\x84[]@z");
  EXPECT_EQ(LowerCase(""), "");
}

TEST(Text, SizesAndDigestsHaveOneSpelling) {
  EXPECT_EQ(SizeText(640, 480), "640x480");
  EXPECT_EQ(HexText(0), "0000000000000000");
  EXPECT_EQ(HexText(0xfedcba9876543210), "fedcba9876543210");
}

TEST(Text, NearestWordIsTheOneAUserMeant) {
  EXPECT_EQ(NearestWord("featurs", {"tracking", "features", "mapping"}), "features");
  EXPECT_EQ(NearestWord("mode", {"model", "mode", "nodes"}), "mode");
  EXPECT_EQ(NearestWord("x", {}), "");
}

}  // namespace
}  // namespace yorb
