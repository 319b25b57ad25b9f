// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "camera/key_table.h"
#include "camera/rig.h"

namespace yorb {

// The files that calibration tools write. Each reader keeps its complaint in `reader`.

/// ROS camera_info (the file of its calibrator, or a printed message) and OpenCV's calibration files.
bool IsMatrixCalibration(const KeyTable& table);
Rig ReadMatrixCalibration(KeyReader& reader);

/// Kalibr's camchain ("cam0.intrinsics") and EuRoC's sensor.yaml ("intrinsics").
Rig ReadIntrinsicsList(KeyReader& reader, const std::string& prefix);

/// camodocal's files, which VINS reads.
bool IsCamodocal(const KeyTable& table);
Rig ReadCamodocal(KeyReader& reader);

}  // namespace yorb
