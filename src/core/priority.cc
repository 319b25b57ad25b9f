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

void GiveWay() {
#if defined(__linux__)
  // On Linux a nice value is a thread's own. Ten steps are a tenth of the share; nobody starves.
  constexpr int kSteps = 10, kMost = 19;
  const auto thread = static_cast<id_t>(syscall(SYS_gettid));
  errno = 0;  // -1 is a nice value, too
  const int nice = getpriority(PRIO_PROCESS, thread);
  if (errno == 0) setpriority(PRIO_PROCESS, thread, std::min(nice + kSteps, kMost));
#endif
}

}  // namespace yorb
