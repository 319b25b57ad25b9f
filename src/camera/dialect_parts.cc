// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "camera/dialect_parts.h"

#include <algorithm>
#include <utility>

#include "core/text.h"

namespace yorb {
namespace {

constexpr double kLongestReadout = 0.2;  // seconds

/// Our own keys where a file of another kind has them misspelt, or in a group, where they are not read.
void RefuseMisplacedDepthKeys(KeyReader& reader) {
  const std::vector<std::string> ours{"depth_factor", "baseline_px", "baseline_m", "close_factor", "readout_s"};
  for (const KeyEntry& entry : reader.table().entries) {
    const std::string last = entry.key.substr(entry.key.rfind('.') + 1);
    const bool is_ours = std::find(ours.begin(), ours.end(), last) != ours.end();
    if (is_ours && last != entry.key)
      reader.Refuse(entry.key, "is not read there; write " + last + " at the top level");
    const bool is_near = std::any_of(ours.begin(), ours.end(), [&](const std::string& key) {
      return EditDistance(LowerCase(entry.key), key) <= kMisspeltAt;
    });
    if (is_near && !is_ours) RefuseUnknown(reader, entry.key, ours);
  }
}

}  // namespace

bool IsOneOf(const std::string& word, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(), [&](const char* w) { return word == w; });
}

Pinhole ReadPinhole(KeyReader& reader, const PinholeKeys& keys) {
  Pinhole camera;
  camera.fx = reader.Number(keys.fx);
  camera.fy = reader.Number(keys.fy);
  camera.cx = reader.Number(keys.cx);
  camera.cy = reader.Number(keys.cy);
  return camera;
}

Pinhole ReadMatrix(KeyReader& reader, const std::string& key) {
  std::vector<double> k = reader.Numbers(key);
  Pinhole camera;
  if (k.size() != 9) {
    reader.Refuse(key, "must hold the 9 numbers of a 3x3 matrix and holds " + std::to_string(k.size()));
    return camera;
  }
  const bool goes_by_columns = k[2] == 0 && k[5] == 0;
  if (goes_by_columns) std::swap(k[2], k[6]), std::swap(k[5], k[7]);
  camera.fx = k[0], camera.cx = k[2], camera.fy = k[4], camera.cy = k[5];
  if (k[1] != 0 || k[3] != 0 || k[6] != 0 || k[7] != 0 || k[8] != 1) {
    reader.Refuse(key, "must be [fx 0 cx; 0 fy cy; 0 0 1], by rows or by columns");
  }
  return camera;
}

void CheckPinhole(KeyReader& reader, const Pinhole& camera, const PinholeKeys& keys) {
  if (reader.error()) return;
  if (camera.fx <= 0)
    reader.Refuse(keys.fx, "gives a focal length of " + FormatShortest(camera.fx) + ", it must be > 0");
  if (camera.fy < 0) {
    reader.Refuse(keys.fy,
                  "gives a negative fy: the pictures' rows would run upwards, and |fy| would mirror the world; "
                  "turn the pictures upside down and give fy > 0 with cy = height - 1 - cy");
  }
  if (camera.fy == 0) reader.Refuse(keys.fy, "gives a focal length of 0, it must be > 0");
  const auto inside = [](double centre, int size) { return centre > -0.5 && (size == 0 || centre < size - 0.5); };
  if (!inside(camera.cx, camera.width)) {
    reader.Refuse(keys.cx, "puts the principal point outside of the picture (cx " + FormatShortest(camera.cx) +
                               ", width " + std::to_string(camera.width) + ")");
  }
  if (!inside(camera.cy, camera.height)) {
    reader.Refuse(keys.cy, "puts the principal point outside of the picture (cy " + FormatShortest(camera.cy) +
                               ", height " + std::to_string(camera.height) + ")");
  }
}

void SetDistortion(KeyReader& reader, const std::string& key, const std::vector<double>& numbers, Pinhole& camera) {
  if (!IsOneOf(std::to_string(numbers.size()), {"0", "4", "5", "8"})) {
    return reader.Refuse(key, "holds " + std::to_string(numbers.size()) +
                                  " distortion numbers; 0, 4 (k1 k2 p1 p2), 5 (and k3) or 8 (and k4 k5 k6) are read");
  }
  std::copy(numbers.begin(), numbers.end(), camera.distortion.begin());
}

void ReadSingleDistortion(KeyReader& reader, const std::string& prefix, Pinhole& camera) {
  const std::vector<std::string> names{"k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"};
  size_t count = 0;
  for (size_t i = 0; i < names.size(); ++i) {
    if (reader.table().Has(prefix + names[i])) count = i + 1;
  }
  if (count > 0) count = count <= 4 ? 4 : count == 5 ? 5 : 8;
  for (size_t i = 0; i < count; ++i) camera.distortion[i] = reader.Number(prefix + names[i]);
}

void ReadShutter(KeyReader& reader, Rig& rig, const std::string& key) {
  rig.readout_s = reader.Number(key, 0);
  if (rig.readout_s < 0 || rig.readout_s > kLongestReadout) {
    reader.Refuse(key, "must be between 0 and " + FormatShortest(kLongestReadout) + " seconds");
  }
}

void ReadDepthKeys(KeyReader& reader, Rig& rig) {
  RefuseMisplacedDepthKeys(reader);
  const double baseline = reader.Positive("baseline_m", kVirtualBaseline);
  if (reader.table().Has("baseline_px") && reader.table().Has("baseline_m")) {
    reader.Refuse("baseline_px", "and baseline_m are both given; one is enough");
  }
  rig.baseline_px = reader.Positive("baseline_px", baseline * rig.camera.fx);
  rig.close_factor = reader.Positive("close_factor", kDefaultCloseFactor);
  rig.depth_factor = reader.Positive("depth_factor", 0);
  rig.fps = reader.Positive("fps", 0);
  ReadShutter(reader, rig);
}

void RefuseUnknown(KeyReader& reader, const std::string& key, const std::vector<std::string>& known) {
  reader.Refuse(key, "is no known key; the nearest is " + NearestWord(key, known));
}

}  // namespace yorb
