// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace yorb {

/// How long others can do without what a thread makes: kMoments where there is time until it is needed, kWhile where
/// nobody waits for it at once.
enum class CanWait { kMoments, kWhile };

/// From now on the calling thread, and those that it starts, give way to the other threads of the program where there
/// are fewer processors than work. Where the system cannot do it for a single thread, nothing happens.
void GiveWay(CanWait can_wait);

}  // namespace yorb
