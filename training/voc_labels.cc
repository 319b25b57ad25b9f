// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/voc_labels.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "core/text.h"

namespace yorb {
namespace {

/// What stands between <name> and </name>, for each time that it does; the element must not hold another of its kind.
std::vector<std::string_view> Elements(std::string_view xml, const std::string& name) {
  const std::string open = std::string("<").append(name), close = std::string("</").append(name).append(">");
  std::vector<std::string_view> found;
  for (size_t at = xml.find(open); at != std::string_view::npos; at = xml.find(open, at + 1)) {
    const size_t begin = xml.find('>', at);
    const char after = at + open.size() < xml.size() ? xml[at + open.size()] : '\0';
    if (begin == std::string_view::npos || (after != '>' && after != ' ')) continue;  // "<objects>" is no "<object>"
    const size_t end = xml.find(close, begin);
    if (end == std::string_view::npos) break;
    found.push_back(xml.substr(begin + 1, end - begin - 1));
    at = end;
  }
  return found;
}

std::optional<double> Number(std::string_view xml, const std::string& name) {
  const auto found = Elements(xml, name);
  return found.empty() ? std::nullopt : ParseDouble(Trim(found.front()));
}

/// The five characters that XML writes as words.
std::string Unescape(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, char>, 5> kWords{
      {{"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}}};
  std::string plain;
  while (!text.empty()) {
    const auto word =
        std::find_if(kWords.begin(), kWords.end(), [&](const auto& w) { return text.starts_with(w.first); });
    plain += word != kWords.end() ? word->second : text.front();
    text.remove_prefix(word != kWords.end() ? word->first.size() : 1);
  }
  return plain;
}

struct PictureSize {
  double width = 0, height = 0;
};

/// One object's box, or what is wrong with it.
Result<LabelBox> ReadObject(std::string_view object, const PictureSize& size, const ClassTable& classes) {
  const auto names = Elements(object, "name"), boxes = Elements(object, "bndbox");
  if (names.empty() || boxes.empty()) return BadInput("an object lacks its name or its bndbox");
  const std::string name = Unescape(Trim(names.front()));
  const std::optional<int> number = classes.Find(name);
  if (!number) return BadInput("the class '" + OneLine(name) + "' is not in the list of classes; add it there");
  const auto left = Number(boxes.front(), "xmin"), top = Number(boxes.front(), "ymin");
  const auto right = Number(boxes.front(), "xmax"), bottom = Number(boxes.front(), "ymax");
  if (!left || !top || !right || !bottom) return BadInput("a bndbox lacks one of xmin, ymin, xmax and ymax");
  const auto part = [](double value, double whole) { return static_cast<float>(std::clamp(value / whole, 0.0, 1.0)); };
  const float x0 = part(*left, size.width), x1 = part(*right, size.width);
  const float y0 = part(*top, size.height), y1 = part(*bottom, size.height);
  LabelBox box{(x0 + x1) / 2, (y0 + y1) / 2, x1 - x0, y1 - y0, static_cast<int16_t>(*number), 0};
  box.is_doubtful = Number(object, "difficult").value_or(0) != 0;
  return box;
}

}  // namespace

Result<std::vector<LabelBox>> ReadVocLabels(const std::string& path, const ClassTable& classes) {
  const Result<std::string> xml = ReadWholeText(path);
  if (!xml) return xml.error();
  const auto sizes = Elements(*xml, "size");
  PictureSize size;
  if (!sizes.empty()) size = {Number(sizes.front(), "width").value_or(0), Number(sizes.front(), "height").value_or(0)};
  if (size.width <= 0 || size.height <= 0)
    return BadInput(path +
                    ": no size with width and height in it, as Pascal VOC labels have; save it anew in LabelImg");
  std::vector<LabelBox> boxes;
  for (const std::string_view object : Elements(*xml, "object")) {
    const Result<LabelBox> box = ReadObject(object, size, classes);
    if (!box) return BadInput(path + ": " + box.error().message);
    if (box->width > 0 && box->height > 0) boxes.push_back(*box);
  }
  return boxes;
}

}  // namespace yorb
