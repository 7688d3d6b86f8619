// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/thread_priority.h"

#include <pthread.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>

namespace esm {

namespace {

constexpr int kRealTimePriority = 15;
constexpr int kRaisedNice = -11;
constexpr unsigned long kTimerSlack = 1000; ///< [ns]

} // namespace

ServoPriority raiseThreadPriority() noexcept
{
  prctl(PR_SET_TIMERSLACK, kTimerSlack); // by default sleeping may take 50 us longer to spare power
  sched_param parameter{};
  parameter.sched_priority = kRealTimePriority;
  if (pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter) == 0) return ServoPriority::RealTime;
  // On Linux this sets the calling thread only.
  if (setpriority(PRIO_PROCESS, 0, kRaisedNice) == 0) return ServoPriority::Raised;
  return ServoPriority::Normal;
}

} // namespace esm
