// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/limits.h"

#include "core/base/machine_memory.h"

#include <algorithm>
#include <csignal>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace esm {

namespace {

constexpr rlim_t kSecondsToStart = 1;
constexpr rlim_t kBytesPerSecond = 200'000; // its slowest readers do ten times as many

void limit(int what, rlim_t soft)
{
  rlimit bounds{};
  getrlimit(static_cast<__rlimit_resource>(what), &bounds);
  bounds.rlim_cur = std::min(soft, bounds.rlim_max);
  setrlimit(static_cast<__rlimit_resource>(what), &bounds);
}

#ifdef ESM_SANITIZED
constexpr rlim_t kSlowness = 30; // of code that a sanitizer watches

void limitMemory(std::uint64_t) {} // the sanitizers reserve terabytes of addresses
#else
constexpr rlim_t kSlowness = 1;
constexpr rlim_t kMemoryToStart = rlim_t{256} << 20; // libraries and their tables take 100 MB of addresses
constexpr rlim_t kMemoryPerByte = 64;                // assimp was seen to take forty

void limitMemory(std::uint64_t opened)
{
  limit(RLIMIT_AS, std::min(rlim_t{machineMemory()} / 4 * 3, kMemoryToStart + kMemoryPerByte * opened));
}
#endif

} // namespace

bool lockDown(pid_t parent)
{
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  prctl(PR_SET_DUMPABLE, 0); // a core limit of 0 is no limit where cores go to a program
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  allowFor(0);
  return getppid() == parent; // it may have died before it could be watched
}

void allowFor(std::uint64_t bytes)
{
  static rlim_t opened = 0;
  opened += bytes;
  limitMemory(opened);
  limit(RLIMIT_CPU, kSlowness * (kSecondsToStart + opened / kBytesPerSecond));
}

} // namespace esm
