// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

namespace esm {

/// Takes the force from all hands before the program ends, however it ends.
///
///     SIGINT, SIGTERM, SIGHUP   requested() becomes true and descriptor() readable: main() comes to its end
///                               in its own way. The same signal again ends the program at once.
///     SIGSEGV, SIGBUS, SIGFPE,  the faulty thread waits until the servo loops are silent, 0.1 s at most,
///     SIGILL, SIGABRT,          then the program dies of what it was dying of. If it is a servo thread
///     std::terminate            itself, it sends zero with its last breath.
///     exit()                    the same wait, wherever it is called.
///
/// After the last servo is silent, drivers get 20 ms more to bring its zero to the device. Before and after
/// all that, each device's LastWords are spoken on the dying thread itself: a driver whose own thread crashed
/// will bring nothing any more.
/// Each servo loop looks at requested() every tick: it lets its force fall to zero, sends zero three times
/// and is silent, whatever the rest of the program does. Handlers touch nothing but atomics and a descriptor.
/// @note One per program, made by main(). Signals that the caller ignores (nohup) or that somebody else
///       handles (a sanitizer) are left alone.
class ExitGuard {
public:
  ExitGuard();
  ~ExitGuard();
  ExitGuard(const ExitGuard&) = delete;
  ExitGuard& operator=(const ExitGuard&) = delete;

  static bool requested() noexcept;
  static int signal() noexcept; ///< the one that asked; 0: none
  /// Readable from the request on, to be waited for beside other events; -1 without a guard.
  static int descriptor() noexcept;
};

/// A servo loop in its own thread, as ExitGuard knows it, from its first tick until it is silent.
/// @note Threads: the servo thread's; wait-free.
class LiveServo {
public:
  /// @param sendZero  what this thread can do even while it is dying: noexcept, without locks.
  LiveServo(void (*sendZero)(void*) noexcept, void* context) noexcept;
  ~LiveServo();
  LiveServo(const LiveServo&) = delete;
  LiveServo& operator=(const LiveServo&) = delete;
};

/// What takes the force from a device when nobody but a dying thread is left, for as long as this lives.
/// @note Any thread; eight at a time, more are not heard.
class LastWords {
public:
  /// @param say  for a signal handler on any thread: without locks or allocation, noexcept, may wait 0.1 s.
  LastWords(void (*say)(void*) noexcept, void* context) noexcept;
  ~LastWords(); ///< waits while they are being spoken
  LastWords(const LastWords&) = delete;
  LastWords& operator=(const LastWords&) = delete;

private:
  int m_place;
};

} // namespace esm
