// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/random.h"
#include "map/map.h"
#include "tracking/fix.h"
#include "tracking/tracking_options.h"

namespace yorb {

/// A pose by descriptors alone and PnP with RANSAC, refined on its inliers. Nothing where too few agree.
std::optional<Fix> FixByAppearance(const Frame& frame, const std::vector<KnownPoint>& points, Random random);

/// Finds a frame by appearance among keyframes, the newest first: descriptors, PnP by RANSAC, then a guided search for
/// the landmarks that the pose says must be there. Nothing where no keyframe gives `min_inliers_after_loss`.
std::optional<Fix> Relocalize(const Frame& frame, const Map& map, const TrackingOptions& options, Random random);

/// The same against one keyframe, with `min_inliers`.
std::optional<Fix> RelocalizeAgainst(const Frame& frame, const Map& map, const Keyframe& keyframe,
                                     const TrackingOptions& options, size_t min_inliers, Random random);

}  // namespace yorb
