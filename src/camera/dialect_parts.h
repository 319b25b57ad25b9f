// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "camera/key_table.h"
#include "camera/rig.h"

namespace yorb {

// What several dialects of camera files share: the parts that their readers are made of.

/// A virtual baseline such as a Kinect's, in metres. For an RGB-D sensor it is a matter of weights, not of scale: it
/// says how the error of a depth compares with the error of a pixel.
inline constexpr double kVirtualBaseline = 0.08;
inline constexpr double kDefaultCloseFactor = 40;

/// A key so many letters away from a known one is taken for that one misspelt.
inline constexpr size_t kMisspeltAt = 2;

/// The remedy where a lens is of another kind.
inline constexpr const char* kFishEye =
    "only pinhole cameras with radial-tangential or rational distortion are read; "
    "undistort the pictures first";

bool IsOneOf(const std::string& word, std::initializer_list<const char*> words);

/// Which keys the four numbers came from, for complaints.
struct PinholeKeys {
  std::string fx, fy, cx, cy;
};

/// The four numbers under their keys; the rest of the camera stays as it is made.
Pinhole ReadPinhole(KeyReader& reader, const PinholeKeys& keys);

/// The same from the nine numbers of a camera matrix, by rows or, as Open3D writes it, by columns.
Pinhole ReadMatrix(KeyReader& reader, const std::string& key);

/// Refuses focal lengths and principal points that no picture has.
void CheckPinhole(KeyReader& reader, const Pinhole& camera, const PinholeKeys& keys);

/// 0, 4, 5 or 8 numbers in OpenCV's order; refused by `key` otherwise.
void SetDistortion(KeyReader& reader, const std::string& key, const std::vector<double>& numbers, Pinhole& camera);

/// k1 k2 p1 p2 k3 k4 k5 k6 as keys of their own; none of them means no distortion.
void ReadSingleDistortion(KeyReader& reader, const std::string& prefix, Pinhole& camera);

/// How long a rolling shutter takes: our key goes with all formats, since most of them have no word for it.
void ReadShutter(KeyReader& reader, Rig& rig, const std::string& key = "readout_s");

/// What our own format says about depth and time; the calibration formats may hold these keys too: one that is
/// misspelt, or stands within a group, is refused.
void ReadDepthKeys(KeyReader& reader, Rig& rig);

/// Refuses a key that is none of `known`, with the nearest of them.
void RefuseUnknown(KeyReader& reader, const std::string& key, const std::vector<std::string>& known);

}  // namespace yorb
