// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "camera/sensor_dialects.h"

#include <algorithm>
#include <string>
#include <vector>

#include "camera/dialect_parts.h"
#include "core/text.h"

namespace yorb {
namespace {

/// Our keys, and depth_scale in the place of depth_factor: units in a metre (Open3D: 1000) or metres of a unit
/// (librealsense: .001). No sensor's unit is longer than a metre, so that the two cannot be mixed up.
void ReadDepth(KeyReader& reader, Rig& rig) {
  ReadDepthKeys(reader, rig);
  if (rig.depth_factor > 0 || !reader.table().Has("depth_scale")) return;
  const double scale = reader.Positive("depth_scale");
  if (scale > 0) rig.depth_factor = scale >= 1 ? scale : 1 / scale;
}

/// The model of a lens without case, blanks, underscores and the name of its enumeration; librealsense's numbers are
/// words.
std::string ModelOf(KeyReader& reader) {
  static const std::vector<std::string> numbered{"none",   "modifiedbrownconrady", "inversebrownconrady",
                                                 "ftheta", "brownconrady",         "kannalabrandt4"};
  std::string word = LowerCase(reader.Word("model", ""));
  const auto is_filler = [](char c) { return c == ' ' || c == '_' || c == '-'; };
  word.erase(std::remove_if(word.begin(), word.end(), is_filler), word.end());
  word.erase(0, word.rfind('.') == std::string::npos ? 0 : word.rfind('.') + 1);
  const auto number = ParseInteger(word);
  if (!number || *number < 0 || *number >= static_cast<long long>(numbered.size())) return word;
  return numbered[static_cast<size_t>(*number)];
}

}  // namespace

bool IsOpen3d(const KeyTable& table) { return table.Has("intrinsic_matrix"); }

Rig ReadOpen3d(KeyReader& reader) {
  const std::string key = "intrinsic_matrix";
  Rig rig;
  rig.camera = ReadMatrix(reader, key);
  Pinhole& camera = rig.camera;
  camera.width = reader.Pixels("width");
  camera.height = reader.Pixels("height");
  CheckPinhole(reader, camera, {key, key, key, key});
  ReadDepth(reader, rig);
  return rig;
}

bool IsRealSense(const KeyTable& table) { return table.Has("ppx") || table.Has("ppy"); }

Rig ReadRealSense(KeyReader& reader) {
  const PinholeKeys keys{"fx", "fy", "ppx", "ppy"};
  Rig rig;
  rig.camera = ReadPinhole(reader, keys);
  Pinhole& camera = rig.camera;
  camera.width = reader.Pixels("width");
  camera.height = reader.Pixels("height");
  std::vector<double> coefficients = reader.Numbers("coeffs");
  const bool are_zero = std::all_of(coefficients.begin(), coefficients.end(), [](double c) { return c == 0; });
  const std::string model = ModelOf(reader);
  if (IsOneOf(model, {"ftheta", "kannalabrandt4"})) {
    reader.Refuse("model", "is " + model + ": " + kFishEye);
  } else if (!are_zero && model != "brownconrady") {
    reader.Refuse(reader.table().FirstOf({"model", "coeffs"}),
                  "does not say Brown-Conrady, the only lens of librealsense's that is read with coeffs other than 0 "
                  "(an inverse or modified one is another); undistort the pictures first");
  }
  SetDistortion(reader, "coeffs", are_zero ? std::vector<double>() : coefficients, camera);
  CheckPinhole(reader, camera, keys);
  ReadDepth(reader, rig);
  return rig;
}

}  // namespace yorb
