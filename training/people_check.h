// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "core/result.h"
#include "detection/onnx_model.h"
#include "training/people_head.h"
#include "training/people_onnx.h"

namespace yorb {

/// The two files that are compared.
struct PeopleFiles {
  const OnnxModel& before;
  const OnnxModel& after;  ///< with the head
};

/// Runs both on a picture (BGR, of the input's size) and gives the greatest difference between the map of people and
/// what the head itself says. Failure where that is more than a thousandth, or where another output changed by a bit.
Result<double> CheckPeopleOutput(const PeopleFiles& files, const FeatureTaps& taps, PeopleHead head,
                                 const cv::Mat& picture);

}  // namespace yorb
