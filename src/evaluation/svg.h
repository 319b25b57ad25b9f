// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace yorb {

/// A point of a drawing in pixels, y downwards.
struct SvgPoint {
  double x = 0, y = 0;
};

/// `text` fit for XML and HTML: & < > " ' escaped, control characters left out, what is no UTF-8 replaced by U+FFFD.
std::string EscapeXml(std::string_view text);

/// A pixel coordinate with at most two decimals and a point in every locale; not finite gives 0.
std::string SvgNumber(double value);

/// How a text stands to its point.
enum class SvgAnchor { kStart, kMiddle, kEnd };

/// The elements of an SVG drawing, written in the order of the calls. Colours are attributes, so that a style sheet
/// around the drawing may override them by class name ("ink", "grid", "paper", "faint").
class SvgCanvas {
 public:
  void Line(SvgPoint from, SvgPoint to, const std::string& style);
  void Rect(SvgPoint corner, double width, double height, const std::string& style);
  void Circle(SvgPoint centre, double radius, const std::string& style);
  void Polyline(const std::vector<SvgPoint>& points, const std::string& style);
  void Text(SvgPoint at, std::string_view text, SvgAnchor anchor, const std::string& style);

  /// Any markup, such as a group's beginning.
  void Raw(std::string_view markup) { body_ += markup; }

  /// The drawing as a whole SVG file of this size; a scalable one inside an HTML page.
  std::string Document(double width, double height) const;

  const std::string& body() const { return body_; }

 private:
  std::string body_;
};

}  // namespace yorb
