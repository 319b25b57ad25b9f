// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "training/class_table.h"
#include "training/network.h"

namespace yorb {

/// A network as the bytes of an ONNX file: input "images" (1, 3, H, W), RGB in [0, 1]; outputs the logits of the three
/// heads, (1, 3 * (5 + classes), H / stride, W / stride), named "stride8", "stride16" and "stride32". Batch norms and
/// ImageNet's mean and deviation are folded into the convolutions. The metadata `names`, `stride`, `anchors` (pixels,
/// one list of three width-height pairs a head) and `imgsz` (height, width) say the rest,
/// `stills_px`, where there are any, as `stills` the longer sides at which single pictures are best looked at.
std::string ExportOnnx(Network network, const ClassTable& table, const cv::Size& size,
                       const std::vector<int>& stills_px = {});

}  // namespace yorb
