// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "camera/calibration_dialects.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "camera/dialect_parts.h"

namespace yorb {
namespace {

constexpr const char* kCamodocalProjection = "projection_parameters.";
constexpr const char* kCamodocalLens = "distortion_parameters.";

void ReadDistortionList(KeyReader& reader, const std::string& key, const std::string& model_key, Pinhole& camera) {
  const std::string model = LowerCase(reader.Word(model_key, ""));
  if (!IsOneOf(model,
               {"", "none", "radtan", "radial-tangential", "plumb_bob", "brown_conrady", "rational_polynomial"})) {
    reader.Refuse(model_key, "is '" + model + "': " + kFishEye);
  }
  std::vector<double> numbers = reader.Numbers(key);
  const bool are_zero = std::all_of(numbers.begin(), numbers.end(), [](double k) { return k == 0; });
  if (model == "none" || are_zero) numbers.clear();
  while (numbers.size() > 8 && numbers.back() == 0) numbers.pop_back();  // OpenCV pads with unused thin-prism zeros
  SetDistortion(reader, key, numbers, camera);
}

/// ROS's numbers are those of the sensor's whole picture; the pictures may be a part of it. Gives whether they are.
bool CropToRegion(KeyReader& reader, Pinhole& camera) {
  const double left = reader.Number("roi.x_offset", 0), top = reader.Number("roi.y_offset", 0);
  const double width = reader.Number("roi.width", 0), height = reader.Number("roi.height", 0);
  const auto are_all = [&](auto holds) { return holds(left) && holds(top) && holds(width) && holds(height); };
  if (are_all([](double n) { return n == 0; })) return false;  // ROS's way to say "the whole picture"
  const bool is_part = are_all([](double n) { return n >= 0 && n == std::floor(n); }) && width > 0 && height > 0 &&
                       left + width <= camera.width && top + height <= camera.height;
  if (!is_part) {
    reader.Refuse(reader.table().FirstOf({"roi.width", "roi.x_offset", "roi.y_offset", "roi.height"}),
                  "and the rest of roi must be a part of the picture of width x height, or all 0 for the whole of it");
    return false;
  }
  camera.cx -= left, camera.cy -= top;
  camera.width = static_cast<int>(width), camera.height = static_cast<int>(height);
  return true;
}

/// VINS's words for our readout_s, which wins.
void ReadVinsShutter(KeyReader& reader, Rig& rig) {
  const KeyTable& table = reader.table();
  if (table.Has("readout_s") || reader.Number("rolling_shutter", 0) == 0) return;
  if (!table.Has("rolling_shutter_tr"))
    return reader.Refuse("rolling_shutter",
                         "is set, and rolling_shutter_tr (seconds from the first row to the last) is not");
  ReadShutter(reader, rig, "rolling_shutter_tr");
}

}  // namespace

bool IsMatrixCalibration(const KeyTable& table) {
  for (const char* name :
       {"camera_matrix", "Camera_Matrix", "cameraMatrix", "K", "k", "distortion_coefficients.data"}) {
    if (table.Has(name) || table.HasPrefix(std::string(name) + ".")) return true;
  }
  return table.Has("image_width");
}

Rig ReadMatrixCalibration(KeyReader& reader) {
  const KeyTable& table = reader.table();
  const std::string matrix = table.FirstOf(
      {"camera_matrix.data", "camera_matrix", "Camera_Matrix.data", "cameraMatrix.data", "K.data", "K", "k"});
  const std::string lens = table.FirstOf({"distortion_coefficients.data", "distortion_coefficients",
                                          "Distortion_Coefficients.data", "distCoeffs.data", "D.data", "D", "d"});
  if (table.Has("fisheye_model") && reader.Number("fisheye_model") != 0) {
    reader.Refuse("fisheye_model", std::string("is set: ") + kFishEye);
  }
  if (!table.Has(lens)) reader.RefuseFile("states no " + lens + " (an empty list where there is no distortion)");
  Rig rig;
  rig.camera = ReadMatrix(reader, matrix);
  Pinhole& camera = rig.camera;
  camera.width = reader.Pixels(table.FirstOf({"image_width", "image_Width", "width"}));
  camera.height = reader.Pixels(table.FirstOf({"image_height", "image_Height", "height"}));
  ReadDistortionList(reader, lens, "distortion_model", camera);
  const bool is_part = CropToRegion(reader, camera);
  CheckPinhole(reader, camera, {matrix, matrix, is_part ? "roi.x_offset" : matrix, is_part ? "roi.y_offset" : matrix});
  ReadDepthKeys(reader, rig);
  rig.name = reader.Word("camera_name", "");
  return rig;
}

Rig ReadIntrinsicsList(KeyReader& reader, const std::string& prefix) {
  const KeyTable& table = reader.table();
  if (table.HasPrefix("cam1.")) {
    reader.RefuseFile("holds more than one camera; put the one that took the colour pictures into a file of its own");
  }
  const std::string model = LowerCase(reader.Word(prefix + "camera_model", "pinhole"));
  if (model != "pinhole") reader.Refuse(prefix + "camera_model", "is '" + model + "': " + kFishEye);
  const std::string key = prefix + "intrinsics";
  const std::vector<double> numbers = reader.Numbers(key);
  Rig rig;
  Pinhole& camera = rig.camera;
  if (numbers.size() != 4) {
    reader.Refuse(key, "must hold fx fy cx cy and holds " + std::to_string(numbers.size()) + " numbers");
  } else {
    camera.fx = numbers[0], camera.fy = numbers[1], camera.cx = numbers[2], camera.cy = numbers[3];
  }
  const std::vector<double> size = reader.Numbers(prefix + "resolution");
  if (size.size() == 2 && size[0] >= 1 && size[1] >= 1 && size[0] < 65536 && size[1] < 65536) {
    camera.width = static_cast<int>(size[0]), camera.height = static_cast<int>(size[1]);
  } else if (!size.empty()) {
    reader.Refuse(prefix + "resolution", "must hold the width and height of the pictures");
  }
  const std::string lens = table.FirstOf(
      {prefix + "distortion_coeffs", prefix + "distortion_coefficients", prefix + "distortion_coefficients.data"});
  if (!table.Has(lens)) reader.RefuseFile("states no " + lens + " (an empty list where there is no distortion)");
  ReadDistortionList(reader, lens, prefix + "distortion_model", camera);
  CheckPinhole(reader, camera, {key, key, key, key});
  ReadDepthKeys(reader, rig);
  if (rig.fps == 0) rig.fps = reader.Positive(prefix + "rate_hz", 0);
  return rig;
}

bool IsCamodocal(const KeyTable& table) {
  return table.HasPrefix(kCamodocalProjection) || table.HasPrefix(kCamodocalLens) || table.Has("model_type") ||
         table.Has("cam0_calib");
}

Rig ReadCamodocal(KeyReader& reader) {
  const std::string projection = kCamodocalProjection, lens = kCamodocalLens;
  if (reader.table().Has("cam0_calib")) reader.Refuse("cam0_calib", "names the camera's file; give that one");
  const std::string model = LowerCase(reader.Word("model_type", "pinhole"));
  if (!IsOneOf(model, {"pinhole", "pinhole_full"})) reader.Refuse("model_type", "is '" + model + "': " + kFishEye);
  if (!reader.table().HasPrefix(lens)) {
    reader.RefuseFile("states no distortion_parameters (k1, k2, p1 and p2; zeros where there is no distortion)");
  }
  const PinholeKeys keys{projection + "fx", projection + "fy", projection + "cx", projection + "cy"};
  std::vector<std::string> known{keys.fx, keys.fy, keys.cx, keys.cy};
  for (const char* name : {"k1", "k2", "k3", "k4", "k5", "k6", "p1", "p2"}) known.push_back(lens + name);
  for (const KeyEntry& entry : reader.table().entries) {
    const bool is_of_these = entry.key.rfind(projection, 0) == 0 || entry.key.rfind(lens, 0) == 0;
    const bool is_known = std::find(known.begin(), known.end(), entry.key) != known.end();
    if (is_of_these && !is_known) RefuseUnknown(reader, entry.key, known);
  }
  Rig rig;
  rig.camera = ReadPinhole(reader, keys);
  Pinhole& camera = rig.camera;
  camera.width = reader.Pixels("image_width");
  camera.height = reader.Pixels("image_height");
  ReadSingleDistortion(reader, lens, camera);
  CheckPinhole(reader, camera, keys);
  ReadDepthKeys(reader, rig);
  ReadVinsShutter(reader, rig);
  rig.name = reader.Word("camera_name", "");
  return rig;
}

}  // namespace yorb
