// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/runtime/told_error.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

constexpr double kMemory = 1.0; ///< [s]

} // namespace

void ToldError::add(const Eigen::Matrix3Xd& position, double error, double interval)
{
  const double count = std::max(static_cast<double>(m_begin.cols()), 1.0);
  const double fade = std::exp(-interval / kMemory);
  m_moved = fade * m_moved + interval * (position - m_begin).squaredNorm() / count;
  m_wrong = fade * m_wrong + interval * error * error;
}

double ToldError::share() const noexcept
{
  return m_moved > 0.0 ? std::min(std::sqrt(m_wrong / m_moved), 1.0) : 0.0;
}

} // namespace esm
