// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/build_pack.h"

#include <algorithm>

#include "training/class_table.h"
#include "training/pack.h"
#include "training/read_picture.h"
#include "training/voc_labels.h"

namespace yorb {
namespace {

constexpr double kDoubtFrom = 0.2, kDoubtTo = 0.4;  // of a teacher's confidence: neither believed nor dismissed
constexpr double kSameThing = 0.5;                  // IoU of a doubtful box with a true one of its class

Result<std::vector<LabelBox>> ReadLabels(const std::string& path, const ClassTable& classes) {
  return path.ends_with(".xml") ? ReadVocLabels(path, classes) : ReadYoloLabels(path, classes.size());
}

Result<PackItem> ReadItem(const LabelledFile& file, const BuildPackOptions& options, const ClassTable& classes) {
  Result<cv::Mat> pixels = ReadSmallPicture(file.picture, options.long_side_px);
  if (!pixels) return pixels.error();
  Result<std::vector<LabelBox>> boxes = ReadLabels(file.labels, classes);
  if (!boxes) return boxes.error();
  const LabelRule rule = RuleFor(file.name, options.rules);
  PackItem item{*pixels, *boxes, rule.judged, rule.is_squashed};
  if (options.teacher.empty()) return item;
  const auto doubtful =
      ReadDoubtfulBoxes(options.teacher + "/" + file.name + ".txt", classes.size(), kDoubtFrom, kDoubtTo);
  if (!doubtful) return doubtful.error();
  for (const LabelBox& box : *doubtful) {
    const bool is_known = std::any_of(boxes->begin(), boxes->end(), [&](const LabelBox& sure) {
      return sure.class_index == box.class_index && IoU(sure, box) > kSameThing;
    });
    if (!is_known) item.boxes.push_back(box);
  }
  return item;
}

}  // namespace

Result<PackCounts> BuildPack(const std::vector<LabelledFile>& files, const std::string& path,
                             const BuildPackOptions& options, const std::function<void(size_t)>& progress) {
  const Result<ClassTable> classes = ReadClassTable(options.class_list);
  if (!classes) return classes.error();
  if (classes->size() > kMostPackedClasses)
    return BadInput(options.class_list + ": a pack holds at most " + std::to_string(kMostPackedClasses) +
                    " classes, and these are " + std::to_string(classes->size()));
  Result<std::unique_ptr<PackWriter>> writer = PackWriter::Create(path, classes->names);
  if (!writer) return writer.error();
  PackCounts counts;
  for (const LabelledFile& file : files) {
    const Result<PackItem> item = ReadItem(file, options, *classes);
    if (!item) return item.error();
    if (const Status added = (*writer)->Add(*item); !added) return added.error();
    const auto num_doubtful =
        std::count_if(item->boxes.begin(), item->boxes.end(), [](const auto& b) { return b.is_doubtful; });
    counts.num_doubtful += static_cast<size_t>(num_doubtful);
    counts.num_boxes += item->boxes.size() - static_cast<size_t>(num_doubtful);
    progress(++counts.num_pictures);
  }
  if (const Status finished = (*writer)->Finish(); !finished) return finished.error();
  return counts;
}

}  // namespace yorb
