// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace yorb {

/// The most memory that this program has held so far, in units of 2^20 bytes.
double PeakRssMb();

/// Processor time of all threads of this program so far, in seconds.
double CpuSeconds();

/// Gives the system back what was freed and the C library has kept: after work that took much more than what stays.
void ReturnFreedMemory();

}  // namespace yorb
