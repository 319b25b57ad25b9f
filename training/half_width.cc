// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/half_width.h"

#include <ATen/autocast_mode.h>
#include <torch/version.h>

namespace yorb {

// libtorch 2.4 gave these functions a device.
#if TORCH_VERSION_MAJOR > 2 || (TORCH_VERSION_MAJOR == 2 && TORCH_VERSION_MINOR >= 4)
bool IsHalfWidth(torch::DeviceType device) { return at::autocast::is_autocast_enabled(device); }

void SetHalfWidth(torch::DeviceType device, bool is_half) {
  at::autocast::set_autocast_enabled(device, is_half);
  at::autocast::set_autocast_dtype(device, at::kBFloat16);
}
#else
bool IsHalfWidth(torch::DeviceType device) {
  return device == torch::kCPU ? at::autocast::is_cpu_enabled() : at::autocast::is_enabled();
}

void SetHalfWidth(torch::DeviceType device, bool is_half) {
  if (device == torch::kCPU) {
    at::autocast::set_cpu_enabled(is_half);
    at::autocast::set_autocast_cpu_dtype(at::kBFloat16);
  } else {
    at::autocast::set_enabled(is_half);
    at::autocast::set_autocast_gpu_dtype(at::kBFloat16);
  }
}
#endif

}  // namespace yorb
