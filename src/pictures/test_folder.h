// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// For tests only: a scratch folder, and pictures in it.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <opencv2/core.hpp>
#include <sstream>
#include <string>

#include "pictures/picture_file.h"

namespace yorb {

/// A folder that goes with its owner.
class TestFolder {
 public:
  TestFolder() {
    static int count = 0;
    root_ = std::filesystem::canonical(std::filesystem::temp_directory_path()) /
            ("yorb_test_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
    std::filesystem::create_directories(root_);
  }
  ~TestFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(root_, ignored);
  }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  std::string Path(const std::string& name = "") const {
    return name.empty() ? root_.string() : (root_ / name).string();
  }

  /// Gives the file's path.
  std::string Write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name, std::ios::binary) << content;
    return Path(name);
  }

  void WritePicture(const std::string& name, const cv::Mat& picture) const {
    const auto bytes = EncodePictureFor(name, picture);
    ASSERT_TRUE(bytes) << bytes.error().message;
    Write(name, *bytes);
  }

  std::string Read(const std::string& name) const {
    std::ifstream stream(root_ / name, std::ios::binary);
    std::ostringstream content;
    content << stream.rdbuf();
    return content.str();
  }

 private:
  std::filesystem::path root_;
};

constexpr int kTestWidth = 64, kTestHeight = 48;

/// A colour picture with something in it.
inline cv::Mat TestColour(int seed, int width = kTestWidth, int height = kTestHeight) {
  cv::Mat picture(height, width, CV_8UC3);
  cv::RNG(static_cast<uint64_t>(seed + 1)).fill(picture, cv::RNG::UNIFORM, 0, 256);
  return picture;
}

inline cv::Mat TestDepth(double units = 1500) { return cv::Mat(kTestHeight, kTestWidth, CV_16UC1, cv::Scalar(units)); }

}  // namespace yorb
