// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// For tests only: a scratch folder for networks and box files.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace yorb {

/// A folder that goes with its owner.
class NetworkFolder {
 public:
  NetworkFolder() {
    static int count = 0;
    root_ = std::filesystem::temp_directory_path() /
            ("yorb_network_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
    std::filesystem::create_directories(root_);
  }
  ~NetworkFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(root_, ignored);
  }
  NetworkFolder(const NetworkFolder&) = delete;
  NetworkFolder& operator=(const NetworkFolder&) = delete;

  std::string Write(const std::string& name, const std::string& content) const {
    std::ofstream(root_ / name, std::ios::binary) << content;
    return (root_ / name).string();
  }

 private:
  std::filesystem::path root_;
};

}  // namespace yorb
