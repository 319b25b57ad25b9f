// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "camera/camera_dialects.h"

#include <algorithm>
#include <cmath>

#include "camera/calibration_dialects.h"
#include "camera/dialect_parts.h"
#include "camera/sensor_dialects.h"
#include "core/text.h"

namespace yorb {
namespace {

constexpr double kSameBaseline = 0.05;  // Camera.bf and Stereo.b times fx may differ by so much: both are rounded

Rig ReadOurs(KeyReader& reader) {
  const std::vector<std::string> known{
      "type",      "name",        "width",      "height",       "fps",          "fx", "fy", "cx", "cy", "distortion",
      "readout_s", "baseline_px", "baseline_m", "close_factor", "depth_factor", "k1", "k2", "p1", "p2", "k3",
      "k4",        "k5",          "k6"};
  const auto is_known = [&](const KeyEntry& entry) {
    return std::find(known.begin(), known.end(), entry.key) != known.end();
  };
  const auto& entries = reader.table().entries;
  if (std::none_of(entries.begin(), entries.end(), is_known)) {
    reader.RefuseFile("is no camera file of a known kind: its first key is " + entries.front().key +
                      ", and there is no fx, Camera.fx, camera_matrix or intrinsics");
  }
  for (const KeyEntry& entry : entries) {
    if (!is_known(entry)) RefuseUnknown(reader, entry.key, known);
  }
  const std::string type = LowerCase(reader.Word("type", "pinhole"));
  if (type != "pinhole") reader.Refuse("type", "is '" + type + "': " + kFishEye);
  Rig rig;
  const PinholeKeys keys{"fx", "fy", "cx", "cy"};
  rig.camera = ReadPinhole(reader, keys);
  Pinhole& camera = rig.camera;
  camera.width = reader.Pixels("width");
  camera.height = reader.Pixels("height");
  if (reader.table().Has("distortion")) {
    SetDistortion(reader, "distortion", reader.Numbers("distortion"), camera);
  } else {
    ReadSingleDistortion(reader, "", camera);
  }
  CheckPinhole(reader, camera, keys);
  ReadDepthKeys(reader, rig);
  rig.name = reader.Word("name", "");
  return rig;
}

/// The camera keys of ORB-SLAM2, ORB-SLAM3 and OpenVSLAM/stella_vslam. Keys of other groups (ORBextractor, Viewer ...)
/// are none of a camera's business and passed over, unless they look like one of these misspelt.
const std::vector<std::string>& OrbSlamKeys() {
  static const std::vector<std::string> keys = [] {
    std::vector<std::string> list{"ThDepth",
                                  "DepthMapFactor",
                                  "depthmap_factor",
                                  "depth_threshold",
                                  "Stereo.b",
                                  "Stereo.ThDepth",
                                  "Stereo.T_c1_c2",
                                  "RGBD.DepthMapFactor",
                                  "Preprocessing.depthmap_factor",
                                  "Camera1.overlappingBegin",
                                  "Camera1.overlappingEnd",
                                  "baseline_px",
                                  "baseline_m",
                                  "close_factor",
                                  "depth_factor",
                                  "readout_s"};
    for (const char* name : {"fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"}) {
      list.push_back(std::string("Camera.") + name);
      list.push_back(std::string("Camera1.") + name);
    }
    for (const char* name : {"type",
                             "model",
                             "setup",
                             "name",
                             "width",
                             "height",
                             "cols",
                             "rows",
                             "fps",
                             "RGB",
                             "color_order",
                             "bf",
                             "focal_x_baseline",
                             "depth_threshold",
                             "depthmap_factor",
                             "newWidth",
                             "newHeight",
                             "imageScale",
                             "true_baseline",
                             "lappingBegin",
                             "lappingEnd",
                             "num_grid_cols",
                             "num_grid_rows"}) {
      list.push_back(std::string("Camera.") + name);
    }
    return list;
  }();
  return keys;
}

void RefuseMisspeltOrbSlamKeys(KeyReader& reader) {
  const auto& known = OrbSlamKeys();
  for (const KeyEntry& entry : reader.table().entries) {
    if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
    const std::string group = entry.key.substr(0, entry.key.find('.') + 1);
    if (IsOneOf(group, {"Camera.", "Camera1.", "Stereo.", "RGBD."})) RefuseUnknown(reader, entry.key, known);
    const bool is_near = std::any_of(known.begin(), known.end(), [&](const std::string& key) {
      return key.size() > 5 && EditDistance(LowerCase(entry.key), LowerCase(key)) <= kMisspeltAt;
    });
    if (is_near && group != "Camera2.") RefuseUnknown(reader, entry.key, known);
  }
}

void ReadOrbSlamDepth(KeyReader& reader, Rig& rig) {
  const KeyTable& table = reader.table();
  const std::string bf = reader.Either({"Camera.bf", "Camera.focal_x_baseline", "baseline_px"});
  const std::string b = reader.Either({"Stereo.b", "baseline_m"});
  const double from_metres = reader.Positive(b, kVirtualBaseline) * rig.camera.fx;
  rig.baseline_px = reader.Positive(bf, from_metres);
  if (table.Has(b) && std::abs(rig.baseline_px - from_metres) > kSameBaseline * from_metres) {
    reader.Refuse(bf, "is not " + b + " times fx");
  }
  rig.close_factor = reader.Positive(
      reader.Either({"ThDepth", "Stereo.ThDepth", "Camera.depth_threshold", "depth_threshold", "close_factor"}),
      kDefaultCloseFactor);
  rig.depth_factor =
      reader.Positive(reader.Either({"DepthMapFactor", "RGBD.DepthMapFactor", "depthmap_factor",
                                     "Preprocessing.depthmap_factor", "Camera.depthmap_factor", "depth_factor"}),
                      0);
}

Rig ReadOrbSlam(KeyReader& reader) {
  const KeyTable& table = reader.table();
  RefuseMisspeltOrbSlamKeys(reader);
  const std::string type_key = reader.Either({"Camera.type", "Camera.model"});
  const std::string type = LowerCase(reader.Word(type_key, "pinhole"));
  if (!IsOneOf(type, {"pinhole", "rectified", "perspective"}))
    reader.Refuse(type_key, "is '" + type + "': " + kFishEye);

  const std::string prefix = table.HasPrefix("Camera1.") ? "Camera1." : "Camera.";
  const PinholeKeys keys{prefix + "fx", prefix + "fy", prefix + "cx", prefix + "cy"};
  Rig rig;
  rig.camera = ReadPinhole(reader, keys);
  Pinhole& camera = rig.camera;
  camera.width = reader.Pixels(reader.Either({"Camera.width", "Camera.cols"}));
  camera.height = reader.Pixels(reader.Either({"Camera.height", "Camera.rows"}));
  if (type != "rectified") ReadSingleDistortion(reader, prefix, camera);
  CheckPinhole(reader, camera, keys);
  ReadOrbSlamDepth(reader, rig);
  ReadShutter(reader, rig);
  rig.fps = std::max(0.0, reader.Number("Camera.fps", 0));  // ORB-SLAM, too, takes 0 for "not known"
  rig.name = reader.Word("Camera.name", "");
  return rig;
}

bool IsOrbSlam(const KeyTable& table) {
  return table.HasPrefix("Camera.") || table.HasPrefix("Camera1.") || table.HasPrefix("ORBextractor.") ||
         table.Has("DepthMapFactor") || table.Has("ThDepth");
}

}  // namespace

Result<Rig> RigFromKeys(const KeyTable& table) {
  KeyReader reader(table);
  Rig rig;
  if (table.entries.empty()) {
    reader.RefuseFile("holds no keys: it is no camera file");
  } else if (IsOrbSlam(table)) {
    rig = ReadOrbSlam(reader);
  } else if (IsCamodocal(table)) {
    rig = ReadCamodocal(reader);
  } else if (table.HasPrefix("cam0.")) {
    rig = ReadIntrinsicsList(reader, "cam0.");
  } else if (table.Has("intrinsics") || table.Has("sensor_type")) {
    rig = ReadIntrinsicsList(reader, "");
  } else if (IsOpen3d(table)) {
    rig = ReadOpen3d(reader);
  } else if (IsRealSense(table)) {
    rig = ReadRealSense(reader);
  } else if (IsMatrixCalibration(table)) {
    rig = ReadMatrixCalibration(reader);
  } else {
    rig = ReadOurs(reader);
  }
  if (reader.error()) return *reader.error();
  if ((rig.camera.width == 0) != (rig.camera.height == 0)) {
    return BadInput(table.path + " states only one of the picture's width and height");
  }
  return rig;
}

}  // namespace yorb
