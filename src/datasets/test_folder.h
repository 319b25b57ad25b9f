// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// For tests only: a scratch folder, and small recordings in TUM's layout in it.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <sstream>
#include <string>

#include "core/text.h"

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

  void Write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name, std::ios::binary) << content;
  }

  void WritePicture(const std::string& name, const cv::Mat& picture) const {
    std::filesystem::create_directories((root_ / name).parent_path());
    ASSERT_TRUE(cv::imwrite(Path(name), picture)) << name;
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
const char* const kTestCamera =
    "fx: 50\nfy: 50\ncx: 31.5\ncy: 23.5\nwidth: 64\nheight: 48\ndepth_factor: 1000\nname: test\n";

/// A colour picture with something in it.
inline cv::Mat TestColour(int seed, int width = kTestWidth, int height = kTestHeight) {
  cv::Mat picture(height, width, CV_8UC3);
  cv::RNG(static_cast<uint64_t>(seed + 1)).fill(picture, cv::RNG::UNIFORM, 0, 256);
  return picture;
}

inline cv::Mat TestDepth(double units = 1500) { return cv::Mat(kTestHeight, kTestWidth, CV_16UC1, cv::Scalar(units)); }

inline std::string Stamp(int frame) { return FormatFixed(1000 + frame / 30.0, 6); }

/// `count` frames at 30 Hz in folder `name`: rgb/K.png and depth/K.png, depth 5 ms after colour, and camera.yaml.
inline void WriteRecording(const TestFolder& folder, const std::string& name, int count) {
  std::string rgb, depth;
  for (int k = 0; k < count; ++k) {
    const std::string file = std::to_string(k) + ".png";
    folder.WritePicture(name + "/rgb/" + file, TestColour(k));
    folder.WritePicture(name + "/depth/" + file, TestDepth());
    rgb += Stamp(k) + " rgb/" + file + "\n";
    depth += FormatFixed(1000.005 + k / 30.0, 6) + " depth/" + file + "\n";
  }
  folder.Write(name + "/rgb.txt", "# colour\n" + rgb);
  folder.Write(name + "/depth.txt", "# depth\n" + depth);
  folder.Write(name + "/camera.yaml", kTestCamera);
}

}  // namespace yorb
