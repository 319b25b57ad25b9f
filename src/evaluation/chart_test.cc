// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/chart.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/random.h"
#include "evaluation/chart_axis.h"
#include "evaluation/chart_png.h"
#include "evaluation/chart_thin.h"
#include "evaluation/svg.h"

/// Fontconfig, which librsvg reads its fonts with, keeps what it has read until the program ends.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\n"; }

namespace yorb {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
const double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(ChartAxis, TicksAreRoundFewAndInside) {
  Random random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    const double low = random.Gaussian() * std::pow(10, random.Uniform(-3, 6));
    const AxisRange range{low, low + std::pow(10, random.Uniform(-3, 6))};
    const int most = 2 + static_cast<int>(random.Below(12));
    const std::vector<double> ticks = NiceTicks(range, most);
    ASSERT_LE(ticks.size(), static_cast<size_t>(most));
    ASSERT_GE(ticks.size(), most >= 5 ? 2u : 0u) << range.low << " " << range.high;
    const double slack = 1e-6 * range.Length();
    for (const double tick : ticks) ASSERT_TRUE(tick >= range.low - slack && tick <= range.high + slack);
    if (ticks.size() < 2) continue;
    const double step = ticks[1] - ticks[0], mantissa = step / std::pow(10, std::floor(std::log10(step) + 1e-6));
    ASSERT_LT(std::min({std::abs(mantissa - 1), std::abs(mantissa - 2), std::abs(mantissa - 5)}), 1e-3) << step;
  }
}

TEST(ChartAxis, LabelsTellTicksApart) {
  EXPECT_THAT(TickLabels({-0.2, 0, 0.2}), ElementsAre("-0.2", "0.0", "0.2"));
  EXPECT_THAT(TickLabels({0, 5, 10}), ElementsAre("0", "5", "10"));
  EXPECT_THAT(TickLabels({0.02, 0.04}), ElementsAre("0.02", "0.04"));
  EXPECT_THAT(TickLabels({0, 2e8, 4e8}), ElementsAre("0", "2e8", "4e8"));
  EXPECT_THAT(TickLabels({0, 2e-8}), ElementsAre("0", "2e-8"));
}

TEST(ChartAxis, OddRangesStayUsable) {
  EXPECT_GT(RangeOf({}, 0.1).Length(), 0);
  EXPECT_GT(RangeOf({kNan, kNan}, 0.1).Length(), 0);
  EXPECT_GT(RangeOf({3, 3}, 0.1).Length(), 0);
  EXPECT_GT(RangeOf({1e300, 1e300}, 0.1).Length(), 0);
  const AxisRange range = RangeOf({1, kNan, 3}, 0.5);
  EXPECT_DOUBLE_EQ(range.low, 0);
  EXPECT_DOUBLE_EQ(range.high, 4);
}

TEST(ChartThin, ACurveKeepsItsPeaks) {
  std::vector<SvgPoint> noise;
  Random random(2);
  for (int i = 0; i < 200000; ++i) noise.push_back({i * 0.004, 100 * random.Uniform()});
  noise[123456].y = 400;
  const std::vector<SvgPoint> kept = ThinLine(noise);
  EXPECT_LT(kept.size(), 7000u);
  EXPECT_TRUE(std::any_of(kept.begin(), kept.end(), [](const SvgPoint& point) { return point.y == 400; }));
  EXPECT_EQ(kept.front().x, noise.front().x);
  EXPECT_EQ(kept.back().x, noise.back().x);
}

TEST(ChartThin, APathStaysWithinAFractionOfAPixel) {
  std::vector<SvgPoint> circle;
  for (int i = 0; i <= 100000; ++i) circle.push_back({300 * std::cos(i * 1e-3), 300 * std::sin(i * 1e-3)});
  const std::vector<SvgPoint> kept = ThinLine(circle);
  EXPECT_LE(kept.size(), 6002u);
  for (size_t i = 1; i < kept.size(); ++i) {
    const SvgPoint middle{0.5 * (kept[i].x + kept[i - 1].x), 0.5 * (kept[i].y + kept[i - 1].y)};
    ASSERT_NEAR(std::hypot(middle.x, middle.y), 300, 0.5);
  }
  EXPECT_EQ(kept.back().y, circle.back().y);
}

TEST(Chart, TextsAreEscapedAndNumbersFinite) {
  Chart chart;
  chart.title = "a < b & \"c\"";
  chart.series = {{"one", {0, 1, kNan, 2, 3}, {1, kNan, 2, 1e300, -5}}};
  const std::string svg = ChartSvg(chart);
  EXPECT_THAT(svg, HasSubstr("a &lt; b &amp; &quot;c&quot;"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
  EXPECT_EQ(SvgNumber(kNan), "0");
  EXPECT_EQ(SvgNumber(-0.001), "0");
  EXPECT_EQ(SvgNumber(12.5), "12.5");
  EXPECT_EQ(SvgNumber(100), "100");
}

TEST(Svg, EscapedTextIsAlwaysXml) {
  const std::string bad = "\xef\xbf\xbd";  // U+FFFD
  EXPECT_EQ(EscapeXml("a<b>&\"'"), "a&lt;b&gt;&amp;&quot;&#39;");
  EXPECT_EQ(EscapeXml("a\x01\x1f\tb\n\r"), "a\tb\n");
  for (const std::string whole : {"caf\xc3\xa9", "\xe2\x82\xac", "\xf0\x9f\x98\x80", "\xed\x9f\xbf", "\xee\x80\x80",
                                  "\xef\xbf\xbc", "\xf4\x8f\xbf\xbf"}) {
    EXPECT_EQ(EscapeXml(whole), whole);
  }
  EXPECT_EQ(EscapeXml("bad\xff.txt"), "bad" + bad + ".txt");
  EXPECT_EQ(EscapeXml("caf\xe9"), "caf" + bad) << "Latin-1";
  EXPECT_EQ(EscapeXml("\xe2\x82<"), bad + bad + "&lt;") << "a cut letter does not take the next one along";
  for (const char* none : {"\xc0\xaf", "\xe0\x80\xaf", "\xf0\x80\x80\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80",
                           "\xef\xbf\xbe", "\xef\xbf\xbf", "\x80", "\xf8"}) {
    const std::string escaped = EscapeXml(none);
    EXPECT_EQ(escaped.size(), 3 * std::string(none).size()) << "overlong, a surrogate, beyond Unicode or no character";
    EXPECT_EQ(escaped.substr(0, 3), bad);
  }
}

size_t Count(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(Chart, GapsLiftThePen) {
  Chart chart;
  chart.series = {SeriesWithGaps("", {0, 1, 2, 10, 11}, 3, {0, 1, 2, 10, 11}, {1, 1, 1, 1, 1})};
  EXPECT_EQ(Count(ChartSvg(chart), "<polyline"), 2u);
  chart.series = {SeriesWithGaps("", {0, 1, 2, 10, 11}, 30, {0, 1, 2, 10, 11}, {1, 1, 1, 1, 1})};
  EXPECT_EQ(Count(ChartSvg(chart), "<polyline"), 1u);
}

TEST(Chart, EmptyChartsAndManyNamesAreDrawn) {
  EXPECT_THAT(ChartSvg({}), HasSubstr("</svg>"));
  Chart chart;
  for (int i = 0; i < 40; ++i) chart.series.push_back({"estimate number " + std::to_string(i), {0, 1}, {0, double(i)}});
  const std::string svg = ChartSvg(chart);
  for (int i = 0; i < 40; ++i) EXPECT_THAT(svg, HasSubstr(">estimate number " + std::to_string(i) + "<"));
}

TEST(ChartPng, IsAPictureOfTheAskedSize) {
  Chart chart;
  chart.series = {{"one", {0, 1}, {0, 1}}};
  const std::string svg = ChartSvg(chart);
  EXPECT_EQ(SizeOfSvg(svg).width, chart.width_px);
  EXPECT_EQ(SizeOfSvg(svg).height, chart.height_px);
  EXPECT_FALSE(PngFromSvg("no drawing", 1));
  const auto png = PngFromSvg(svg, 2);
  if (!png && png.error().message.find("need") != std::string::npos) GTEST_SKIP() << "skipped: " << png.error().message;
  ASSERT_TRUE(png) << png.error().message;
  ASSERT_EQ(png->substr(0, 8), "\x89PNG\r\n\x1a\n");
  const auto big_endian = [&](size_t at) {
    int value = 0;
    for (size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<unsigned char>((*png)[i]);
    return value;
  };
  EXPECT_EQ(big_endian(16), 2 * chart.width_px);
  EXPECT_EQ(big_endian(20), 2 * chart.height_px);
}

}  // namespace
}  // namespace yorb
