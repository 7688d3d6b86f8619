// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "haptics/hand.h"
#include "haptics/haptic_types.h"

#include <Eigen/Core>

#include <atomic>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace esm {

/// Where a hand was, over time: recorded, kept as a table, led again. Plain data.
struct HandPath {
  std::vector<double> time;  ///< [s], rising
  Eigen::Matrix3Xd position; ///< 3 x time.size() [m]

  double duration() const noexcept { return time.empty() ? 0.0 : time.back() - time.front(); }
  /// Between the points on straight lines; before the first and after the last it rests. @pre not empty
  Eigen::Vector3d at(double t) const noexcept;
};

/// A table with the header "t,x,y,z", seconds and metres, as CsvReader takes it; written as CSV with decimal
/// points, numbers read back to the same bits.
/// Errors: FileUnreadable; BadFormat (which line) for other columns, times that do not rise or what is no
/// finite number; EmptyResult without points.
Result<HandPath> readHandPath(const std::filesystem::path& file);
Status writeHandPath(const std::filesystem::path& file, const HandPath& path);

/// The way of the hand in a trace; it begins at t = 0.
HandPath handPathOf(std::span<const TraceSample> trace);

/// Leads a simulated device along a path, from the first time that it is asked on.
class RecordedHand final : public Hand {
public:
  explicit RecordedHand(HandPath path) : m_path(std::move(path)) {}
  HandPose pose(double time) noexcept override;

private:
  HandPath m_path;
  double m_start = 0.0;
  bool m_started = false;
};

/// Rests where a path begins until it is told to go; each time it lets go and begins at the first point.
class WaitingHand final : public Hand {
public:
  explicit WaitingHand(HandPath path) : m_path(std::move(path)) {}
  void go() noexcept
  {
    m_starts.fetch_add(1, std::memory_order_relaxed);
  } ///< from the first point; any thread
  HandPose pose(double time) noexcept override;

private:
  HandPath m_path;
  std::atomic<std::uint32_t> m_starts{0};
  std::uint32_t m_seen = 0;
  double m_start = 0.0;
};

} // namespace esm
