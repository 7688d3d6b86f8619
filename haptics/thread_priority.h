// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace esm {

/// What the system granted a thread.
enum class ServoPriority : std::uint8_t { Normal, Raised, RealTime };

/// The best that the system allows the calling thread: real-time above ordinary programs and below the
/// kernel's own threads, else a raised one, else what it has. Most users are allowed neither.
ServoPriority raiseThreadPriority() noexcept;

} // namespace esm
