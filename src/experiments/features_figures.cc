// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/features_figures.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/text.h"
#include "evaluation/chart.h"
#include "experiments/features_light.h"
#include "experiments/features_spread.h"
#include "features/descriptor.h"
#include "features/quadtree.h"
#include "pictures/png.h"

namespace yorb {
namespace {

const cv::Scalar kGreen(80, 200, 60), kRed(40, 40, 230), kOrange(0, 140, 255), kWhite(255, 255, 255);

cv::Mat Coloured(const cv::Mat& grey) {
  cv::Mat colour;
  cv::cvtColor(grey, colour, cv::COLOR_GRAY2BGR);
  return colour;
}

void Label(cv::Mat& picture, const std::string& text) {
  cv::rectangle(picture, cv::Rect(0, 0, std::min(picture.cols, 14 + 9 * static_cast<int>(text.size())), 24),
                cv::Scalar(30, 30, 30), cv::FILLED);
  cv::putText(picture, text, {6, 17}, cv::FONT_HERSHEY_SIMPLEX, 0.5, kWhite, 1, cv::LINE_AA);
}

cv::Mat WithPoints(const cv::Mat& grey, const std::vector<Keypoint>& points, const std::string& label) {
  cv::Mat picture = Coloured(grey);
  for (const Keypoint& k : points) {
    cv::circle(picture, cv::Point(cvRound(k.x), cvRound(k.y)), 2, kGreen, 1, cv::LINE_AA);
  }
  Label(picture, label);
  return picture;
}

/// Pictures in rows, all of one size.
cv::Mat Sheet(const std::vector<std::vector<cv::Mat>>& rows) {
  std::vector<cv::Mat> strips;
  for (const auto& row : rows) {
    cv::Mat strip;
    cv::hconcat(row, strip);
    strips.push_back(strip);
  }
  cv::Mat sheet;
  cv::vconcat(strips, sheet);
  return sheet;
}

Result<FileToWrite> Png(const std::string& path, const cv::Mat& picture) {
  auto bytes = EncodePng(picture);
  if (!bytes) return Failure(path + ": " + bytes.error().message);
  return FileToWrite{path, *std::move(bytes)};
}

FrontEnd Named(const std::vector<FrontEnd>& front_ends, const std::string& name) {
  return *std::find_if(front_ends.begin(), front_ends.end(), [&](const FrontEnd& f) { return f.name == name; });
}

/// Which of the strongest corners of the picture itself a distribution keeps: redder is stronger; a box marks one of
/// the strongest that was dropped.
cv::Mat KeptPicture(const cv::Mat& grey, const std::vector<Corner>& corners, const std::vector<Corner>& kept,
                    const std::string& name) {
  cv::Mat picture = Coloured(grey);
  std::vector<Corner> strongest = corners;
  std::sort(strongest.begin(), strongest.end(),
            [](const Corner& a, const Corner& b) { return a.response > b.response; });
  if (strongest.empty()) return picture;
  const float top = strongest.front().response;
  const auto is_kept = [&](const Corner& c) {
    return std::any_of(kept.begin(), kept.end(), [&](const Corner& k) { return k.x == c.x && k.y == c.y; });
  };
  for (const Corner& c : kept) {
    const double paleness = 255 * (1 - c.response / top);
    cv::circle(picture, {c.x, c.y}, 3, cv::Scalar(paleness, paleness, 255), cv::FILLED, cv::LINE_AA);
  }
  strongest.resize(std::min(strongest.size(), kept.size()));
  int dropped = 0;
  for (const Corner& c : strongest) {
    if (is_kept(c)) continue;
    ++dropped;
    cv::rectangle(picture, cv::Rect(c.x - 5, c.y - 5, 11, 11), kRed, 1);
  }
  Label(picture,
        name + ": " + std::to_string(dropped) + " of the " + std::to_string(strongest.size()) + " strongest dropped");
  return picture;
}

cv::Mat Figure3(const cv::Mat& grey, const FeatureOptions& ours) {
  const int wanted = static_cast<int>(std::lround(ours.wanted * (1 - 1 / ours.scale_factor)));
  CornerDetector detector;
  const GreyView view{grey.data, grey.cols, grey.rows, static_cast<ptrdiff_t>(grey.step[0])};
  const std::vector<Corner> corners = detector.Detect(view, CornersOf(ours), wanted, BestInstructions());
  const CornerArea area{kFeatureBorder, kFeatureBorder, grey.cols - kFeatureBorder, grey.rows - kFeatureBorder};
  Quadtree original, improved;
  return Sheet({{KeptPicture(grey, corners, original.KeepBestOfEach(corners, area, wanted), "full quadtree"),
                 KeptPicture(grey, corners, improved.KeepSinglesAndBest(corners, area, wanted), "improved")}});
}

std::vector<Keypoint> FirstCornersOf(const cv::Mat& grey, const FeatureOptions& options) {
  CornerDetector detector;
  const GreyView view{grey.data, grey.cols, grey.rows, static_cast<ptrdiff_t>(grey.step[0])};
  std::vector<Keypoint> points;
  for (const Corner& c : detector.DetectFirst(view, CornersOf(options), BestInstructions())) {
    points.push_back({static_cast<float>(c.x), static_cast<float>(c.y), 0.f, c.response, 0});
  }
  return points;
}

cv::Mat Figure5(const cv::Mat& grey, const FeatureOptions& ours) {
  std::vector<std::vector<cv::Mat>> rows(2);
  for (const double factor : {0.6, 1.0, 1.4}) {
    const cv::Mat relit = Relit(grey, Scaled(factor));
    const std::string light = FormatFixed(100 * factor, 0) + " %: ";
    const auto original = FirstCornersOf(relit, OriginalOptions(ours, 40, 30)), improved = FirstCornersOf(relit, ours);
    rows[0].push_back(WithPoints(relit, original, "original, " + light + std::to_string(original.size())));
    rows[1].push_back(WithPoints(relit, improved, "improved, " + light + std::to_string(improved.size())));
  }
  return Sheet(rows);
}

cv::Mat Figure6(const cv::Mat& grey, const std::vector<FrontEnd>& front_ends) {
  std::vector<cv::Mat> row;
  for (const std::string& name : {front_end::kOriginal, front_end::kImproved}) {
    const std::vector<Keypoint> points = Named(front_ends, name).extract(grey).keypoints;
    row.push_back(WithPoints(grey, points,
                             name + ": " + std::to_string(points.size()) + " points, dispersion " +
                                 FormatFixed(Dispersion(points, grey.size()), 1)));
    for (int third = 1; third < 3; ++third) {
      cv::line(row.back(), {0, grey.rows * third / 3}, {grey.cols, grey.rows * third / 3}, kOrange);
      cv::line(row.back(), {grey.cols * third / 3, 0}, {grey.cols * third / 3, grey.rows}, kOrange);
    }
  }
  return Sheet({row});
}

/// The second picture of Figure 7, and how far the matches with it are off.
struct Partner {
  cv::Mat grey;
  std::function<MatchErrors(const Features&, const Features&, const std::vector<std::pair<size_t, size_t>>&)> errors;
};

Result<Partner> PartnerOf(const PictureSet& set, size_t i, const ImageSet& images) {
  constexpr size_t kGap = 10;
  if (set.HasMotion() && i + kGap < set.size() && !images.depth.empty()) {
    const auto from = TruePose(set.truth, set.dataset->TimeOf(i)),
               to = TruePose(set.truth, set.dataset->TimeOf(i + kGap));
    const auto other = LoadPicture(set, i + kGap);
    if (!other) return other.error();
    if (from && to && !other->grey.empty()) {
      const Rigid3 b_from_a = to->Inverse() * *from;
      return Partner{other->grey, [=, &set, &images](const Features& a, const Features& b, const auto& matches) {
                       return ErrorsByMotion(a, b, matches, set.dataset->rig(), images.depth, b_from_a);
                     }};
    }
  }
  return Partner{Relit(images.grey, Scaled(0.6)), [](const Features& a, const Features& b, const auto& matches) {
                   return ErrorsInPlace(a, b, matches);
                 }};
}

cv::Mat Figure7(const cv::Mat& grey, const Partner& partner, const std::vector<FrontEnd>& front_ends) {
  std::vector<std::vector<cv::Mat>> rows;
  for (const std::string& name : {front_end::kOriginal, front_end::kImproved}) {
    const FrontEnd front_end = Named(front_ends, name);
    const Features a = front_end.extract(grey), b = front_end.extract(partner.grey);
    const auto matches = MutualNearest(a.descriptors, b.descriptors);
    const std::vector<int> verdicts = Verdicts(a, matches, partner.errors(a, b, matches));
    cv::Mat pair;
    cv::hconcat(Coloured(grey), Coloured(partner.grey), pair);
    for (const int drawn : {1, 0}) {  // wrong ones last, on top
      for (size_t k = 0; k < matches.size(); ++k) {
        if (verdicts[k] != drawn) continue;
        const Keypoint &p = a.keypoints[matches[k].first], &q = b.keypoints[matches[k].second];
        cv::line(pair, cv::Point(cvRound(p.x), cvRound(p.y)), cv::Point(cvRound(q.x) + grey.cols, cvRound(q.y)),
                 drawn == 1 ? kGreen : kRed, 1, cv::LINE_AA);
      }
    }
    const auto right = std::count(verdicts.begin(), verdicts.end(), 1);
    Label(pair, name + ": " + std::to_string(right) + " right (green), " +
                    std::to_string(std::count(verdicts.begin(), verdicts.end(), 0)) + " wrong (red)");
    rows.push_back({pair});
  }
  return Sheet(rows);
}

std::string BrightnessChart(const cv::Mat& grey, const FeatureOptions& ours) {
  Chart chart;
  chart.title = "Corners of the first threshold under other light";
  chart.x_label = "brightness, %";
  chart.y_label = "% of the corners at 100 %";
  chart.is_from_zero = true;
  const std::map<std::string, std::string> names = {{front_end::kOriginal, "original, fixed 40"},
                                                    {front_end::kImproved, "improved, equation (3)"},
                                                    {front_end::kCvFast, "cv::FAST, fixed 20"}};
  for (const CornerCounter& counter : CornerCounters(ours)) {
    ChartSeries series;
    series.name = names.at(counter.name);
    const double base = static_cast<double>(std::max<size_t>(1, counter.count(grey)));
    for (int percent = 40; percent <= 160; percent += 10) {
      series.x.push_back(percent);
      series.y.push_back(100 * static_cast<double>(counter.count(Relit(grey, Scaled(percent / 100.0)))) / base);
    }
    chart.series.push_back(std::move(series));
  }
  return ChartSvg(chart);
}

}  // namespace

Result<std::vector<FileToWrite>> FeatureFigures(const PictureSet& set, const FeatureOptions& ours,
                                                const std::string& folder) {
  const size_t middle = set.size() / 2;
  const auto images = LoadPicture(set, middle);
  if (!images) return images.error();
  std::vector<FileToWrite> files;
  if (images->grey.empty()) return files;
  const auto partner = PartnerOf(set, middle, *images);
  if (!partner) return partner.error();
  const std::vector<FrontEnd> front_ends = FrontEnds(ours);
  const std::string start = (std::filesystem::path(folder) / set.name).string();
  const std::pair<const char*, cv::Mat> figures[] = {
      {"_figure3_kept.png", Figure3(images->grey, ours)},
      {"_figure5_light.png", Figure5(images->grey, ours)},
      {"_figure6_spread.png", Figure6(images->grey, front_ends)},
      {"_figure7_matches.png", Figure7(images->grey, *partner, front_ends)}};
  for (const auto& [name, picture] : figures) {
    auto file = Png(start + name, picture);
    if (!file) return file.error();
    files.push_back(*std::move(file));
  }
  files.push_back({start + "_brightness.svg", BrightnessChart(images->grey, ours)});
  return files;
}

}  // namespace yorb
