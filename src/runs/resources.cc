// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/resources.h"

#include <sys/resource.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <fstream>
#include <string>

#include "core/text.h"

namespace yorb {
namespace {

rusage Usage() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage;
}

double Seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

}  // namespace

double PeakRssMb() {
  // getrusage also counts what the program that started this one held; /proc does not.
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    const auto fields = SplitAtBlanks(line);
    if (fields.size() < 2 || fields[0] != "VmHWM:") continue;
    if (const auto kilobytes = ParseDouble(fields[1])) return *kilobytes / 1024;
  }
  return static_cast<double>(Usage().ru_maxrss) / 1024;
}

void ReturnFreedMemory() {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

double CpuSeconds() {
  const rusage usage = Usage();
  return Seconds(usage.ru_utime) + Seconds(usage.ru_stime);
}

}  // namespace yorb
