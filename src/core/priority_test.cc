// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/priority.h"

#include <gtest/gtest.h>

#include <thread>

#if defined(__linux__)
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace yorb {
namespace {

#if defined(__linux__)
int NiceOfThisThread() { return getpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid))); }

TEST(Priority, OnlyTheThreadThatGivesWayAndThoseOfItDo) {
  const int before = NiceOfThisThread();
  int lowered = 0, inherited = 0;
  std::thread([&] {
    GiveWay();
    lowered = NiceOfThisThread();
    std::thread([&] { inherited = NiceOfThisThread(); }).join();
  }).join();
  EXPECT_EQ(lowered, before > 9 ? 19 : before + 10);
  EXPECT_EQ(inherited, lowered);
  EXPECT_EQ(NiceOfThisThread(), before);
}
#endif

TEST(Priority, GivingWayAgainAndAgainIsFine) {
  std::thread([] {
    for (int i = 0; i < 5; ++i) GiveWay();
  }).join();
}

}  // namespace
}  // namespace yorb
