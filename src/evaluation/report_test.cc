// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "evaluation/test_trajectories.h"

namespace yorb {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

RunReport SomeReport() {
  RunReport report;
  report.title = "desk <1> & more";
  report.reference = SmoothWalk(1000, 10);
  report.trajectory = Disturbed(SmoothWalk(300, 33), 0.005, SomeMotion(1), 4);
  for (size_t i = 0; i < report.trajectory.size(); i += 20) report.keyframes.push_back(report.trajectory[i]);
  for (size_t i = 0; i < 300; ++i) {
    const bool is_lost = i > 100 && i < 120;
    report.frames.push_back(
        {report.trajectory[i].timestamp, is_lost ? "lost" : "tracking", is_lost ? 0 : 500, 400, 9.5});
  }
  report.stages = {{"extract", 6.21, 8.15, 14.2, 300}, {"track", 3, 4, 5, 300}};
  report.coverage = 0.9367;
  report.key_figures = {{"Keyframes", "15"}};
  report.config_digest = "0123abcd";
  report.version = "9.8.7";
  report.notes = {"2 pictures were skipped."};
  return report;
}

TEST(Report, SaysWhatItWasGiven) {
  const std::string html = ReportHtml(SomeReport());
  for (const char* text :
       {"<!DOCTYPE html>", "desk &lt;1&gt; &amp; more", "93.7 %", "Keyframes", "ATE RMSE, SE(3)", "extract", "8.15",
        "0123abcd", "9.8.7", "2 pictures were skipped.", ">lost<", ">reference<", ">keyframes<", "</html>"}) {
    EXPECT_THAT(html, HasSubstr(text));
  }
}

TEST(Report, NeedsNothingFromOutside) {
  std::string html = ReportHtml(SomeReport());
  const std::string name_space = "http://www.w3.org/2000/svg";  // a name, nothing that is fetched
  for (size_t at = html.find(name_space); at != std::string::npos; at = html.find(name_space))
    html.erase(at, name_space.size());
  for (const char* text : {"http:", "https:", "src=", "href=", "url(", "<script", "@import", "nan"}) {
    EXPECT_THAT(html, Not(HasSubstr(text)));
  }
}

TEST(Report, WhatIsNotKnownIsNotDrawn) {
  EXPECT_THAT(ReportHtml({}), HasSubstr("No pose"));
  RunReport report = SomeReport();
  report.reference.clear();
  report.stages.clear();
  report.notes.clear();
  const std::string html = ReportHtml(report);
  for (const char* text : {"ATE", "reference", "<table>", "Notes"}) EXPECT_THAT(html, Not(HasSubstr(text)));
  EXPECT_THAT(html, HasSubstr(">estimate<"));
  report.reference = SmoothWalk(100, 10, 1000000);  // of another day
  EXPECT_THAT(ReportHtml(report), Not(HasSubstr("ATE")));
}

TEST(Report, GivenFiguresAreNotSaidTwice) {
  RunReport report = SomeReport();
  report.key_figures = {{"Coverage", "93.7 % (281 of 300)"}, {"ATE RMSE", "8 mm"}};
  const std::string html = ReportHtml(report);
  EXPECT_THAT(html, HasSubstr("281 of 300"));
  EXPECT_THAT(html, Not(HasSubstr("<b>93.7 %</b>")));
  EXPECT_THAT(html, Not(HasSubstr("SE(3)</span>")));
}

TEST(Report, AnHourOfFramesStaysReadable) {
  RunReport report;
  report.trajectory = SmoothWalk(108000, 33);
  for (const StampedPose& pose : report.trajectory)
    report.frames.push_back({pose.timestamp, "tracking", 500, 400, 9.5});
  EXPECT_LT(ReportHtml(report).size(), 3000000u);
}

}  // namespace
}  // namespace yorb
