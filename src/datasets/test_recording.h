// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// For tests only: small recordings in TUM's layout.
#pragma once

#include <string>

#include "core/text.h"
#include "pictures/test_folder.h"

namespace yorb {

const char* const kTestCamera =
    "fx: 50\nfy: 50\ncx: 31.5\ncy: 23.5\nwidth: 64\nheight: 48\ndepth_factor: 1000\nname: test\n";

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
