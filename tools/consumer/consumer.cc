// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// The smallest program around Slam: one grey picture in, the report out.
#include <cstdio>
#include <opencv2/core.hpp>

#include "system/slam.h"

int main() {
  yorb::Rig rig;
  rig.camera.fx = rig.camera.fy = 525;
  rig.camera.cx = 319.5;
  rig.camera.cy = 239.5;
  rig.camera.width = 640;
  rig.camera.height = 480;
  yorb::Config config;
  config.mode = "inline";

  auto slam = yorb::Slam::Create(config, rig);
  if (!slam) {
    std::fprintf(stderr, "%s\n", slam.error().message.c_str());
    return 1;
  }
  yorb::ImageSet images;
  images.timestamp = *yorb::ParseTimestamp("1305031102.175304");
  images.grey = cv::Mat(480, 640, CV_8UC1, cv::Scalar(127));
  const auto taken = (*slam)->Push(images);
  (*slam)->Finish();
  const auto report = (*slam)->Report();
  std::printf("consumer: %zu picture, %zu poses\n", report.frames.size(), report.trajectory().size());
  return taken && *taken && report.frames.size() == 1 && report.trajectory().empty() ? 0 : 1;
}
