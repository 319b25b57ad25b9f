// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/svg.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"

namespace yorb {
namespace {

constexpr const char* kReplacement = "\xef\xbf\xbd";  // U+FFFD

std::string Attribute(const char* name, double value) {
  return std::string(" ") + name + "=\"" + SvgNumber(value) + '"';
}

std::string Spaced(const std::string& style) { return style.empty() ? style : ' ' + style; }

/// How many bytes the letter of UTF-8 has that `text` begins with; 0 where it begins with none that XML knows.
size_t LetterLength(std::string_view text) {
  const auto byte = [&](size_t at) { return at < text.size() ? static_cast<unsigned char>(text[at]) : 0u; };
  const unsigned first = byte(0), second = byte(1);
  if (first < 0x80) return 1;
  if (first < 0xc2 || first > 0xf4) return 0;
  const size_t length = first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
  for (size_t at = 1; at < length; ++at) {
    if ((byte(at) & 0xc0) != 0x80) return 0;
  }
  const bool is_overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool is_surrogate = first == 0xed && second >= 0xa0, is_beyond = first == 0xf4 && second >= 0x90;
  const bool is_no_character = first == 0xef && second == 0xbf && byte(2) >= 0xbe;  // U+FFFE, U+FFFF
  return is_overlong || is_surrogate || is_beyond || is_no_character ? 0 : length;
}

void AppendEscaped(char c, std::string& escaped) {
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

}  // namespace

std::string EscapeXml(std::string_view text) {
  std::string escaped;
  escaped.reserve(text.size());
  while (!text.empty()) {
    const size_t length = LetterLength(text);
    if (length == 1) AppendEscaped(text[0], escaped);
    if (length > 1) escaped += text.substr(0, length);
    if (length == 0) escaped += kReplacement;
    text.remove_prefix(std::max<size_t>(length, 1));
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
