// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/exit_guard.h"

#include "haptics/zero_reports.h"

#include <array>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <utility>

#include <sys/eventfd.h>
#include <unistd.h>

namespace esm {

namespace {

constexpr std::array kPolite{SIGINT, SIGTERM, SIGHUP};
constexpr std::array kDeadly{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
constexpr int kLongestWait = 100; ///< [ms]
constexpr int kDriverTime = 20;   ///< for a driver's thread to send what the servo left to it [ms]

std::atomic<bool> s_requested{false};
std::atomic<int> s_signal{0}, s_liveServos{0}, s_descriptor{-1};
std::terminate_handler s_formerTerminate = nullptr;
static_assert(std::atomic<int>::is_always_lock_free); // a handler may touch nothing else

struct LastBreath {
  void (*sendZero)(void*) noexcept = nullptr;
  void* context = nullptr;
};
thread_local LastBreath t_lastBreath;

struct Words {
  std::atomic<void (*)(void*) noexcept> say{nullptr};
  std::atomic<void*> context{nullptr}; ///< null: nothing to say
  std::atomic<bool> taken{false};
  std::atomic<int> speaking{0};
};
std::array<Words, 8> s_words;
thread_local bool t_dying = false;

void speakLastWords() noexcept
{
  for (Words& words : s_words) {
    words.speaking.fetch_add(1);
    if (void* context = words.context.load()) words.say.load()(context);
    words.speaking.fetch_sub(1);
  }
}

void request(int signal) noexcept
{
  s_signal.store(signal, std::memory_order_relaxed);
  s_requested.store(true, std::memory_order_release);
  const std::uint64_t one = 1;
  if (const int descriptor = s_descriptor.load(std::memory_order_relaxed); descriptor >= 0) [[maybe_unused]]
    const auto written = write(descriptor, &one, sizeof one);
}

/// On the thread that is dying: the servo threads are alive, unless it is one of them.
void silenceAll() noexcept
{
  if (std::exchange(t_dying, true)) return; // it died again, of its last words
  request(0);
  speakLastWords();
  const LastBreath& own = t_lastBreath;
  if (own.sendZero != nullptr)
    for (int i = 0; i < kZeroReports; ++i) own.sendZero(own.context);
  const int mine = own.sendZero != nullptr ? 1 : 0;
  const std::timespec millisecond{0, 1000000};
  if (s_liveServos.load(std::memory_order_acquire) == 0) return;
  for (int i = 0; i < kLongestWait && s_liveServos.load(std::memory_order_acquire) > mine; ++i)
    nanosleep(&millisecond, nullptr);
  for (int i = 0; i < kDriverTime; ++i) nanosleep(&millisecond, nullptr);
  speakLastWords(); // whatever the servos' last ticks have brought to the devices
}

/// exit() may be called by any thread while force flows. Handlers run in reverse order: registered with the
/// first servo, this one comes before the bus is taken down, which was opened earlier.
void silenceAtExit() noexcept
{
  static const int registered = std::atexit(silenceAll);
  static_cast<void>(registered);
}

void onPolite(int signal)
{
  request(signal);
}

void onDeadly(int signal)
{
  silenceAll();
  raise(signal); // SA_RESETHAND: now it does what it does to any program
}

[[noreturn]] void onTerminate()
{
  silenceAll();
  if (s_formerTerminate != nullptr) s_formerTerminate();
  std::abort();
}

void handle(int signal, void (*handler)(int))
{
  struct sigaction former {};
  if (sigaction(signal, nullptr, &former) != 0) return;
  if ((former.sa_flags & SA_SIGINFO) != 0 || former.sa_handler != SIG_DFL) return;
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(signal, &action, nullptr);
}

void release(int signal, void (*handler)(int))
{
  struct sigaction present {};
  if (sigaction(signal, nullptr, &present) != 0 || present.sa_handler != handler) return;
  std::signal(signal, SIG_DFL);
}

} // namespace

ExitGuard::ExitGuard()
{
  s_descriptor.store(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK), std::memory_order_relaxed);
  for (const int signal : kPolite) handle(signal, onPolite);
  for (const int signal : kDeadly) handle(signal, onDeadly);
  s_formerTerminate = std::set_terminate(onTerminate);
}

ExitGuard::~ExitGuard()
{
  std::set_terminate(s_formerTerminate);
  for (const int signal : kPolite) release(signal, onPolite);
  for (const int signal : kDeadly) release(signal, onDeadly);
  if (const int descriptor = s_descriptor.exchange(-1); descriptor >= 0) close(descriptor);
  s_requested.store(false);
  s_signal.store(0);
}

bool ExitGuard::requested() noexcept
{
  return s_requested.load(std::memory_order_acquire);
}

int ExitGuard::signal() noexcept
{
  return s_signal.load(std::memory_order_relaxed);
}

int ExitGuard::descriptor() noexcept
{
  return s_descriptor.load(std::memory_order_relaxed);
}

LiveServo::LiveServo(void (*sendZero)(void*) noexcept, void* context) noexcept
{
  silenceAtExit();
  t_lastBreath = {sendZero, context};
  s_liveServos.fetch_add(1, std::memory_order_acq_rel);
}

LiveServo::~LiveServo()
{
  t_lastBreath = {};
  s_liveServos.fetch_sub(1, std::memory_order_acq_rel);
}

LastWords::LastWords(void (*say)(void*) noexcept, void* context) noexcept : m_place(-1)
{
  for (int i = 0; i < static_cast<int>(s_words.size()); ++i) {
    Words& words = s_words[static_cast<std::size_t>(i)];
    if (words.taken.exchange(true)) continue;
    m_place = i;
    words.say.store(say);
    words.context.store(context);
    return;
  }
}

LastWords::~LastWords()
{
  if (m_place < 0) return;
  Words& words = s_words[static_cast<std::size_t>(m_place)];
  words.context.store(nullptr);
  const std::timespec millisecond{0, 1000000};
  while (words.speaking.load() != 0) nanosleep(&millisecond, nullptr);
  words.taken.store(false);
}

} // namespace esm
