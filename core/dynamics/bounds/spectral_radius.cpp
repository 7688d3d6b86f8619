// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/bounds/spectral_radius.h"

#include <cstdint>

namespace esm {
namespace {

/// How many eigenvalues are larger than `x`: negative pivots of x I - T.
std::size_t countAbove(const std::vector<double>& diagonal, const std::vector<double>& off, double x)
{
  std::size_t count = 0;
  double pivot = 1.0;
  for (std::size_t i = 0; i < diagonal.size(); ++i) {
    pivot = x - diagonal[i] - (i > 0 ? off[i - 1] * off[i - 1] / pivot : 0.0);
    if (pivot == 0.0) pivot = 1e-300;
    if (pivot < 0.0) ++count;
  }
  return count;
}

} // namespace

ESM_CPU_CLONES void detail::setScaled(std::size_t count, double factor, const Lanes* x, Lanes* y) noexcept
{
  for (std::size_t i = 0; i < count; ++i) y[i] = x[i] * factor;
}

double largestTridiagonalEigenvalue(const std::vector<double>& diagonal, const std::vector<double>& off)
{
  double low = -1e300, high = 0.0;
  for (std::size_t i = 0; i < diagonal.size(); ++i) {
    const double reach = (i > 0 ? std::abs(off[i - 1]) : 0.0) + (i < off.size() ? std::abs(off[i]) : 0.0);
    low = std::max(low, diagonal[i]);
    high = i == 0 ? diagonal[i] + reach : std::max(high, diagonal[i] + reach);
  }
  for (int i = 0; i < 60 && high - low > 1e-12 * std::abs(high); ++i) {
    const double middle = 0.5 * (low + high);
    (countAbove(diagonal, off, middle) > 0 ? low : high) = middle;
  }
  return high;
}

void Lanczos::start(std::size_t count)
{
  m_before.assign(count, Lanes{0, 0, 0, 0});
  m_now.resize(count);
  m_next.assign(count, Lanes{0, 0, 0, 0});
  std::uint64_t random = 0x9E3779B97F4A7C15u;
  const auto sign = [&random] { // xorshift (Marsaglia 2003)
    random ^= random << 13;
    random ^= random >> 7;
    random ^= random << 17;
    return (random >> 63) != 0 ? 1.0 : -1.0;
  };
  const double norm = 1.0 / std::sqrt(3.0 * static_cast<double>(std::max<std::size_t>(count, 1)));
  for (Lanes& value : m_now) {
    const double x = sign(), y = sign(), z = sign();
    value = Lanes{x * norm, y * norm, z * norm, 0.0};
  }
}

} // namespace esm
