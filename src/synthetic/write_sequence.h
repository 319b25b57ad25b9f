// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "core/result.h"
#include "synthetic/sequence.h"

namespace yorb {

/// How a sequence is put on disk.
struct WriteOptions {
  std::string folder;
  bool is_lossless = false;  ///< colour as PNG (larger and slower) instead of JPEG
  int jpeg_quality = 95;     ///< 1..100
  int num_threads = 1;       ///< the files do not depend on it
};

/// What the caller hears and may say meanwhile; both are called on the caller's thread.
struct WriteHooks {
  std::function<void(size_t num_done, size_t num_frames)> on_progress = [](size_t, size_t) {};
  std::function<bool()> should_stop = [] { return false; };
};

/// Makes the folder (with its parents) ready before any work is done, and notes in `rendered.txt` what is going to be
/// in it. A sequence that was rendered there before is removed; bad input when the folder holds anything else, or
/// cannot be written.
Status PrepareFolder(const std::string& folder, const std::string& description);

/// Writes the sequence into a folder that PrepareFolder made ready, in TUM layout: rgb/ rgb.txt depth/ depth.txt
/// groundtruth.txt (one exact pose a frame) camera.yaml people.txt (boxes of what is visible of the people) mask/
/// (whose pixel is whose). Gives the number of frames written, fewer than all after `should_stop`; the lists come last
/// and hold just these.
Result<size_t> WriteSequence(const SyntheticSequence& sequence, const WriteOptions& options,
                             const WriteHooks& hooks = {});

}  // namespace yorb
