// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/installed.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace yorb {
namespace {

namespace fs = std::filesystem;

class Installed : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::canonical(fs::temp_directory_path()) / ("yorb_installed_" + std::to_string(::getpid()));
    fs::create_directories(root_);
  }
  void TearDown() override { fs::remove_all(root_); }

  fs::path root_;
};

TEST_F(Installed, AnInstallationIsFoundFromItsBinFolder) {
  fs::create_directories(root_ / "bin");
  fs::create_directories(root_ / "share/yorb/configs");
  EXPECT_EQ(InstalledFolderFrom((root_ / "bin").string(), "configs"), (root_ / "share/yorb/configs").string());
  EXPECT_FALSE(InstalledFolderFrom((root_ / "bin").string(), "models"));
}

TEST_F(Installed, ACheckoutIsFoundFromAnyBuildFolderInIt) {
  fs::create_directories(root_ / "build/some/apps");
  fs::create_directories(root_ / "configs");
  EXPECT_FALSE(InstalledFolderFrom((root_ / "build/some/apps").string(), "configs")) << "somebody else's configs";
  fs::create_directories(root_ / "src");
  std::ofstream(root_ / "src/LAYERS") << "core\n";
  EXPECT_EQ(InstalledFolderFrom((root_ / "build/some/apps").string(), "configs"), (root_ / "configs").string());
}

TEST_F(Installed, AModuleIsFoundInAnInstallationAndInABuildFolderOnly) {
  fs::create_directories(root_ / "bin");
  fs::create_directories(root_ / "build/apps");
  for (const char* folder : {"lib/yorb", "build/lib/yorb"}) {
    fs::create_directories(root_ / folder);
    std::ofstream(root_ / folder / "a.so") << "a";
  }
  EXPECT_EQ(InstalledModuleFrom((root_ / "bin").string(), "a.so"), (root_ / "lib/yorb/a.so").string());
  EXPECT_FALSE(InstalledModuleFrom((root_ / "bin").string(), "b.so"));
  const std::string deeper = (root_ / "build/src/room").string();
  EXPECT_FALSE(InstalledModuleFrom(deeper, "a.so")) << "no build folder of CMake's: somebody else's module";
  std::ofstream(root_ / "build/CMakeCache.txt") << "";
  EXPECT_EQ(InstalledModuleFrom(deeper, "a.so"), (root_ / "build/lib/yorb/a.so").string());
}

TEST_F(Installed, TheCurrentFolderDoesNotCount) {
  fs::create_directories(root_ / "share/yorb/no_such_folder_of_ours");
  const fs::path before = fs::current_path();
  fs::current_path(root_);
  EXPECT_FALSE(InstalledFolder("no_such_folder_of_ours"));
  fs::current_path(before);
}

}  // namespace
}  // namespace yorb
