// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/svg.h"

#include <cmath>

#include "core/text.h"

namespace yorb {
namespace {

std::string Attribute(const char* name, double value) {
  return std::string(" ") + name + "=\"" + SvgNumber(value) + '"';
}

std::string Spaced(const std::string& style) { return style.empty() ? style : ' ' + style; }

}  // namespace

std::string EscapeXml(std::string_view text) {
  std::string escaped;
  escaped.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t') escaped += c;
    }
  }
  return escaped;
}

std::string SvgNumber(double value) {
  if (!std::isfinite(value)) return "0";
  std::string text = FormatFixed(value, 2);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

void SvgCanvas::Line(SvgPoint from, SvgPoint to, const std::string& style) {
  body_ += "<line" + Attribute("x1", from.x) + Attribute("y1", from.y) + Attribute("x2", to.x) + Attribute("y2", to.y) +
           Spaced(style) + "/>\n";
}

void SvgCanvas::Rect(SvgPoint corner, double width, double height, const std::string& style) {
  body_ += "<rect" + Attribute("x", corner.x) + Attribute("y", corner.y) + Attribute("width", width) +
           Attribute("height", height) + Spaced(style) + "/>\n";
}

void SvgCanvas::Circle(SvgPoint centre, double radius, const std::string& style) {
  body_ += "<circle" + Attribute("cx", centre.x) + Attribute("cy", centre.y) + Attribute("r", radius) + Spaced(style) +
           "/>\n";
}

void SvgCanvas::Polyline(const std::vector<SvgPoint>& points, const std::string& style) {
  body_ += "<polyline points=\"";
  for (const SvgPoint& point : points) body_ += SvgNumber(point.x) + ',' + SvgNumber(point.y) + ' ';
  body_ += '"' + Spaced(style) + "/>\n";
}

void SvgCanvas::Text(SvgPoint at, std::string_view text, SvgAnchor anchor, const std::string& style) {
  constexpr const char* kWords[] = {"start", "middle", "end"};
  body_ += "<text" + Attribute("x", at.x) + Attribute("y", at.y) + " text-anchor=\"" +
           kWords[static_cast<size_t>(anchor)] + '"' + Spaced(style) + '>' + EscapeXml(text) + "</text>\n";
}

std::string SvgCanvas::Document(double width, double height) const {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\"" + Attribute("width", width) + Attribute("height", height) +
         " viewBox=\"0 0 " + SvgNumber(width) + ' ' + SvgNumber(height) +
         "\" font-family=\"'Helvetica Neue', Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif\">\n" +
         body_ + "</svg>\n";
}

}  // namespace yorb
