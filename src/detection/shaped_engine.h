// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <vector>

#include "core/result.h"
#include "detection/detector.h"
#include "detection/engine.h"
#include "detection/head_layout.h"
#include "detection/network.h"

namespace yorb {

/// A network ready to run at one size, and how its outputs are read there.
struct ShapedEngine {
  EngineInput input;
  std::unique_ptr<Engine> engine;
  HeadLayout layout;
  std::vector<TensorView> blank_outputs;  ///< for a picture of nothing; valid until the engine runs again

  cv::Size size() const { return {input.width, input.height}; }
};

/// Chooses an engine for the network at the size of its input and recognises the layout. Bad input names the file.
Result<ShapedEngine> MakeShapedEngine(const Network& network, const DetectionOptions& options);

/// Runs an engine; an output without an axis for the pictures, (K, 6), is given with one.
Result<std::vector<TensorView>> RunOn(Engine& engine, const cv::Mat& picture);

/// What the outputs of an engine say of themselves.
HeadFacts FactsOf(const std::vector<TensorView>& outputs, const Network& network);

/// The input for a picture whose longer side is to be `long_side_px`, or the next multiple of 32 beyond: the other side
/// follows the picture's shape, so that hardly any of the input is empty.
cv::Size InputSizeFor(const cv::Size& picture, int long_side_px);

}  // namespace yorb
