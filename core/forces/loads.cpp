// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/loads.h"

#include <algorithm>

namespace esm {
namespace {

/// How many of the curve's times are <= t.
std::size_t passedTimes(const VectorCurve& curve, double t)
{
  return static_cast<std::size_t>(std::upper_bound(curve.time.begin(), curve.time.end(), t) -
                                  curve.time.begin());
}

} // namespace

Eigen::Vector3d VectorCurve::at(double t) const
{
  if (time.empty()) return Eigen::Vector3d::Zero();
  const std::size_t passed = passedTimes(*this, t);
  if (passed == 0) return value.col(0);
  const auto last = static_cast<Eigen::Index>(passed - 1);
  if (passed == time.size()) return value.col(last);
  return value.col(last) + slopeAt(t) * (t - time[passed - 1]);
}

Eigen::Vector3d VectorCurve::slopeAt(double t) const
{
  const std::size_t passed = passedTimes(*this, t);
  if (passed == 0 || passed == time.size()) return Eigen::Vector3d::Zero();
  const auto last = static_cast<Eigen::Index>(passed - 1);
  return (value.col(last + 1) - value.col(last)) / (time[passed] - time[passed - 1]);
}

} // namespace esm
