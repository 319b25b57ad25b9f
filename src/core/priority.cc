// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/priority.h"

#if defined(__linux__)
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#endif

namespace yorb {

void GiveWay(CanWait can_wait) {
#if defined(__linux__)
  // On Linux a nice value is a thread's own. Six steps are a quarter of the share, twelve a fifteenth; nobody starves.
  constexpr int kMost = 19;
  const int steps = can_wait == CanWait::kWhile ? 12 : 6;
  const auto thread = static_cast<id_t>(syscall(SYS_gettid));
  errno = 0;  // -1 is a nice value, too
  const int nice = getpriority(PRIO_PROCESS, thread);
  if (errno == 0) setpriority(PRIO_PROCESS, thread, std::min(nice + steps, kMost));
#else
  (void)can_wait;
#endif
}

}  // namespace yorb
