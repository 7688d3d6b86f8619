// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "cli/interrupt_watch.h"

#include <array>
#include <csignal>
#include <pthread.h>
#include <unistd.h>
#include <utility>

namespace esm::cli {

namespace {

constexpr std::array kEnding = {SIGINT, SIGTERM, SIGHUP};
constexpr int kWake = SIGUSR1; ///< to the watching thread alone: its work is done

sigset_t endingSignals()
{
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : kEnding) {
    struct sigaction action = {};
    if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler != SIG_IGN) sigaddset(&set, signal);
  }
  return set;
}

} // namespace

InterruptWatch::InterruptWatch(std::function<void()> cleanUp) : m_cleanUp(std::move(cleanUp))
{
  sigset_t blocked = endingSignals();
  sigaddset(&blocked, kWake); // the thread inherits it, whoever sends it early
  sigset_t before;
  pthread_sigmask(SIG_BLOCK, &blocked, &before);
  m_thread = std::jthread([this](const std::stop_token& stop) { wait(stop); });
  if (sigismember(&before, kWake) == 1) return;
  sigset_t wake;
  sigemptyset(&wake);
  sigaddset(&wake, kWake);
  pthread_sigmask(SIG_UNBLOCK, &wake, nullptr);
}

InterruptWatch::~InterruptWatch()
{
  m_thread.request_stop();
  pthread_kill(m_thread.native_handle(), kWake);
  m_thread.join();
  const sigset_t watched = endingSignals();
  pthread_sigmask(SIG_UNBLOCK, &watched, nullptr); // one that came at the last moment ends the program now
}

void InterruptWatch::wait(const std::stop_token& stop)
{
  sigset_t awaited = endingSignals();
  sigaddset(&awaited, kWake);
  int signal = 0;
  if (sigwait(&awaited, &signal) != 0 || stop.stop_requested()) return;
  const std::lock_guard lock(m_mutex); // never released: nobody goes on writing
  m_cleanUp();
  sigset_t own;
  sigemptyset(&own);
  sigaddset(&own, signal);
  std::signal(signal, SIG_DFL);
  pthread_sigmask(SIG_UNBLOCK, &own, nullptr);
  kill(getpid(), signal);
}

} // namespace esm::cli
