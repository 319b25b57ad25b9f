// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "camera/camera_dialects.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/text.h"

namespace yorb {
namespace {

// A virtual baseline such as a Kinect's. For an RGB-D sensor it is a matter of weights, not of scale: it says how the
// error of a depth compares with the error of a pixel.
constexpr double kVirtualBaseline = 0.08;
constexpr double kDefaultCloseFactor = 40;
constexpr double kLongestReadout = 0.2;  // seconds
constexpr double kSameBaseline = 0.05;   // Camera.bf and Stereo.b times fx may differ by so much: both are rounded
constexpr size_t kMisspeltAt = 2;        // a key so many letters away from a known one is taken for that one misspelt

const char* const kFishEye =
    "only pinhole cameras with radial-tangential or rational distortion are read; "
    "undistort the pictures first";

std::string LowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool IsOneOf(const std::string& word, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(), [&](const char* w) { return word == w; });
}

/// Which keys the four numbers came from, for complaints.
struct PinholeKeys {
  std::string fx, fy, cx, cy;
};

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

/// k1 k2 p1 p2 k3 k4 k5 k6 as keys of their own; none of them means no distortion.
void ReadSingleDistortion(KeyReader& reader, const std::string& prefix, Pinhole& camera) {
  const std::vector<std::string> names{"k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"};
  size_t count = 0;
  for (size_t i = 0; i < names.size(); ++i) {
    if (reader.table().Has(prefix + names[i])) count = i + 1;
  }
  if (count > 0) count = count <= 4 ? 4 : count == 5 ? 5 : 8;
  for (size_t i = 0; i < count; ++i) camera.distortion[i] = reader.Number(prefix + names[i]);
}

/// The one key about the shutter, of all formats: none of the others has a word for it.
void ReadShutter(KeyReader& reader, Rig& rig) {
  rig.readout_s = reader.Number("readout_s", 0);
  if (rig.readout_s < 0 || rig.readout_s > kLongestReadout) {
    reader.Refuse("readout_s", "must be between 0 and " + FormatShortest(kLongestReadout) + " seconds");
  }
}

/// What our own format says about depth and time; the calibration formats may hold these keys too.
void ReadDepthKeys(KeyReader& reader, Rig& rig) {
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

/// Refuses a key that is none of `known`, with the nearest of them.
void RefuseUnknown(KeyReader& reader, const std::string& key, const std::vector<std::string>& known) {
  reader.Refuse(key, "is no known key; the nearest is " + NearestWord(key, known));
}

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
  Pinhole& camera = rig.camera;
  camera.fx = reader.Number("fx");
  camera.fy = reader.Number("fy");
  camera.cx = reader.Number("cx");
  camera.cy = reader.Number("cy");
  camera.width = reader.Pixels("width");
  camera.height = reader.Pixels("height");
  if (reader.table().Has("distortion")) {
    SetDistortion(reader, "distortion", reader.Numbers("distortion"), camera);
  } else {
    ReadSingleDistortion(reader, "", camera);
  }
  CheckPinhole(reader, camera, {"fx", "fy", "cx", "cy"});
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
  Pinhole& camera = rig.camera;
  camera.fx = reader.Number(keys.fx);
  camera.fy = reader.Number(keys.fy);
  camera.cx = reader.Number(keys.cx);
  camera.cy = reader.Number(keys.cy);
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

/// ROS camera_info (the file of its calibrator, or a printed message) and OpenCV's calibration files.
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
  const std::vector<double> k = reader.Numbers(matrix);
  Rig rig;
  Pinhole& camera = rig.camera;
  if (k.size() != 9) {
    reader.Refuse(matrix, "must hold the 9 numbers of a 3x3 matrix and holds " + std::to_string(k.size()));
  } else {
    camera.fx = k[0], camera.cx = k[2], camera.fy = k[4], camera.cy = k[5];
    if (k[1] != 0 || k[3] != 0 || k[8] != 1) reader.Refuse(matrix, "must be [fx 0 cx; 0 fy cy; 0 0 1]");
  }
  camera.width = reader.Pixels(table.FirstOf({"image_width", "image_Width", "width"}));
  camera.height = reader.Pixels(table.FirstOf({"image_height", "image_Height", "height"}));
  ReadDistortionList(reader, lens, "distortion_model", camera);
  CheckPinhole(reader, camera, {matrix, matrix, matrix, matrix});
  ReadDepthKeys(reader, rig);
  rig.name = reader.Word("camera_name", "");
  return rig;
}

/// Kalibr's camchain ("cam0.intrinsics") and EuRoC's sensor.yaml ("intrinsics").
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

bool IsOrbSlam(const KeyTable& table) {
  return table.HasPrefix("Camera.") || table.HasPrefix("Camera1.") || table.HasPrefix("ORBextractor.") ||
         table.Has("DepthMapFactor") || table.Has("ThDepth");
}

bool IsMatrixCalibration(const KeyTable& table) {
  for (const char* name :
       {"camera_matrix", "Camera_Matrix", "cameraMatrix", "K", "k", "distortion_coefficients.data"}) {
    if (table.Has(name) || table.HasPrefix(std::string(name) + ".")) return true;
  }
  return table.Has("image_width");
}

}  // namespace

Result<Rig> RigFromKeys(const KeyTable& table) {
  KeyReader reader(table);
  Rig rig;
  if (table.entries.empty()) {
    reader.RefuseFile("holds no keys: it is no camera file");
  } else if (IsOrbSlam(table)) {
    rig = ReadOrbSlam(reader);
  } else if (table.HasPrefix("cam0.")) {
    rig = ReadIntrinsicsList(reader, "cam0.");
  } else if (table.Has("intrinsics") || table.Has("sensor_type")) {
    rig = ReadIntrinsicsList(reader, "");
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
