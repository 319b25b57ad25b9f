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
  int moments = 0, lowered = 0, inherited = 0;
  std::thread([&] {
    GiveWay(CanWait::kMoments);
    moments = NiceOfThisThread();
  }).join();
  std::thread([&] {
    GiveWay(CanWait::kWhile);
    lowered = NiceOfThisThread();
    std::thread([&] { inherited = NiceOfThisThread(); }).join();
  }).join();
  if (before < 7) {
    EXPECT_LT(before, moments);
    EXPECT_LT(moments, lowered);
  }
  EXPECT_EQ(inherited, lowered);
  EXPECT_EQ(NiceOfThisThread(), before);
}
#endif

TEST(Priority, GivingWayAgainAndAgainIsFine) {
  std::thread([] {
    for (int i = 0; i < 5; ++i) GiveWay(CanWait::kWhile);
  }).join();
}

}  // namespace
}  // namespace yorb
