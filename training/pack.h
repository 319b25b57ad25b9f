// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "core/result.h"
#include "training/label_rules.h"
#include "training/labels.h"

namespace yorb {

/// A picture on its way into a pack.
struct PackItem {
  cv::Mat pixels;  ///< CV_8UC3, BGR
  std::vector<LabelBox> boxes;
  ClassBits judged;
  bool is_squashed = false;
};

/// A picture of a pack; `pixels` points into the mapped file.
struct PackedPicture {
  cv::Mat pixels;
  std::vector<LabelBox> boxes;
  ClassBits judged;
  bool is_squashed = false;
};

/// Pictures, small enough for training, and their labels in one file, so that an epoch reads neither thousands of
/// files nor JPEGs. The file is of this machine's byte order: a cache, not an exchange format.
class PackWriter {
 public:
  /// Failure when the file cannot be made.
  static Result<std::unique_ptr<PackWriter>> Create(const std::string& path, std::vector<std::string> class_names);
  ~PackWriter();

  /// Writes one picture.
  Status Add(const PackItem& item);

  /// Writes the index; before that the file is no pack.
  Status Finish();

 private:
  struct State;
  explicit PackWriter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// A pack, mapped into memory. Any thread may read it.
class Pack {
 public:
  /// Bad input when the file is missing, is no pack, or was not written to its end.
  static Result<std::shared_ptr<const Pack>> Open(const std::string& path);
  ~Pack();

  size_t size() const;
  const std::vector<std::string>& class_names() const;
  PackedPicture Get(size_t index) const;

 private:
  struct State;
  explicit Pack(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace yorb
