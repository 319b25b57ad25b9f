// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <torch/torch.h>

namespace yorb {

/// Whether libtorch convolves in bfloat16 on such devices in this thread ("autocast").
bool IsHalfWidth(torch::DeviceType device);
void SetHalfWidth(torch::DeviceType device, bool is_half);

/// Half width for as long as this lives, or full width.
class HalfWidth {
 public:
  HalfWidth(torch::DeviceType device, bool is_half) : device_(device), was_half_(IsHalfWidth(device)) {
    SetHalfWidth(device_, is_half);
  }
  ~HalfWidth() { SetHalfWidth(device_, was_half_); }
  HalfWidth(const HalfWidth&) = delete;
  HalfWidth& operator=(const HalfWidth&) = delete;

 private:
  torch::DeviceType device_;
  bool was_half_;
};

}  // namespace yorb
