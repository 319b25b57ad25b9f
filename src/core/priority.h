// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace yorb {

/// From now on the calling thread, and those that it starts, give way to the other threads of the program where there
/// are fewer processors than work. For work that nobody waits for at once. Where the system cannot do it for a single
/// thread, nothing happens.
void GiveWay();

}  // namespace yorb
