// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/half_width.h"

#include <ATen/autocast_mode.h>
#include <torch/version.h>

namespace yorb {

// libtorch 2.4 gave these functions a device.
#if TORCH_VERSION_MAJOR > 2 || (TORCH_VERSION_MAJOR == 2 && TORCH_VERSION_MINOR >= 4)
bool IsHalfWidth() { return at::autocast::is_autocast_enabled(at::kCPU); }

void SetHalfWidth(bool is_half) {
  at::autocast::set_autocast_enabled(at::kCPU, is_half);
  at::autocast::set_autocast_dtype(at::kCPU, at::kBFloat16);
}
#else
bool IsHalfWidth() { return at::autocast::is_cpu_enabled(); }

void SetHalfWidth(bool is_half) {
  at::autocast::set_cpu_enabled(is_half);
  at::autocast::set_autocast_cpu_dtype(at::kBFloat16);
}
#endif

}  // namespace yorb
