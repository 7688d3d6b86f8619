// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <atomic>
#include <cstddef>

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
/// Loops that take such small items by blocks take so many at once, or stopWantedAt() passes over some.
inline constexpr std::size_t kItemsPerLook = 4096;
/// For loops over many small items: every few thousand of them tells how far it is and asks whether to stop.
inline bool stopWantedAt(std::size_t item, std::size_t items, WorkControl* control) noexcept
{
  if (item % kItemsPerLook != 0 || !control) return false;
  tellDone(control, static_cast<double>(item) / static_cast<double>(items));
  return stopWanted(control);
}
inline Error cancelledError()
{
  return {ErrorCode::Cancelled, "stopped at the user's wish"};
}

} // namespace esm
