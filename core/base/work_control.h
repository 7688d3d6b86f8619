// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <atomic>

namespace esm {

/// The two wires to long work on another thread: "stop" goes in, "so far" comes out. Whoever started the work
/// owns it and keeps it alive until the work has returned.
/// @note Threads: any; wait-free.
struct WorkControl {
  std::atomic<bool> cancelled{false}; ///< set by the owner; the work answers ErrorCode::Cancelled soon after
  std::atomic<double> done{0.0};      ///< share of the present stage, 0 ... 1; set by the work
};

/// For work that takes a WorkControl*, where null means that nobody watches.
inline bool stopWanted(const WorkControl* control) noexcept
{
  return control && control->cancelled.load(std::memory_order_relaxed);
}
inline void tellDone(WorkControl* control, double share) noexcept
{
  if (control) control->done.store(share, std::memory_order_relaxed);
}
inline Error cancelledError()
{
  return {ErrorCode::Cancelled, "stopped at the user's wish"};
}

} // namespace esm
