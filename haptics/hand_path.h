// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "haptics/hand.h"

#include <Eigen/Core>

#include <filesystem>
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

/// CSV with the header "t,x,y,z", seconds and metres; numbers read back to the same bits.
/// Errors: FileUnreadable; BadFormat (which line) for other columns, times that do not rise or what is no
/// finite number; EmptyResult without points.
Result<HandPath> readHandPath(const std::filesystem::path& file);
Status writeHandPath(const std::filesystem::path& file, const HandPath& path);

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

} // namespace esm
