// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/result.h"
#include "detection/engine.h"
#include "detection/onnx_model.h"

namespace yorb {

/// What a network's file says of itself, checked, and the graph.
struct Network {
  OnnxModel model;
  EngineInput input;
  std::vector<std::string> names;  ///< of the classes; empty where nothing says them
  std::string names_source;        ///< "its metadata", a file's name
  std::string names_file;          ///< beside it, where they stand there
  std::vector<float> anchors;      ///< of raw maps, px; empty: the standard ones
  bool has_people = false;         ///< its last output is a map of people
  std::vector<int> stills_px;      ///< longer sides at which it sees single pictures best; none: not known
  std::string task;                ///< "detect", "segment", "obb": as its metadata say; empty: they do not
  int num_keypoint_values = 0;     ///< of a pose network, behind its classes
};

/// Input sizes are whole multiples of it, since the coarsest maps have cells of this size.
constexpr int kCellSize = 32;
constexpr int kLargestSize = 4096;  ///< px: no side of an input is longer

/// A single picture is looked at so many times at most.
constexpr size_t kMostLooks = 8;

/// Reads a network's file. `size`, where it is not empty, is taken for the input, whatever the file says; otherwise the
/// file's own, that of its metadata (`imgsz`) where it is left open, or 640x640. Bad input for what is no network of
/// pictures.
Result<Network> OpenNetwork(const std::string& path, const cv::Size& size);

/// The last that happens to an output, but for changes of its shape: "Sigmoid"; empty where nothing does.
std::string LastOperator(const OnnxModel& model, const std::string& output);

}  // namespace yorb
