// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <sys/types.h>

namespace esm {

/// The bounds of the worker process, set by itself before it touches a file: no file may be written, a crash
/// leaves no core file, and it dies with the thread of its parent.
/// @return false if the parent is gone already
bool lockDown(pid_t parent);

/// Raises what the process may use to what reading `bytes` more can need, so that a small file that lies
/// about its size gets neither gigabytes nor minutes: 256 MB and 1 s of processor time to begin with, 64
/// bytes and 5 microseconds for each byte of a file. Never above three quarters of the machine's memory.
void allowFor(std::uint64_t bytes);

} // namespace esm
