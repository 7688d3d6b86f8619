// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/secant_pairs.h"

#include "core/dynamics/system/system.h"
#include "core/forces/spring_pass.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

/// Least cosine between s and y: what is flatter is rounding, or no positive curvature.
constexpr double kLeastCosine = 1e-8;

ESM_CPU_CLONES double dotOf(std::size_t count, const Lanes* a, const Lanes* b) noexcept
{
  const auto take = [=](std::size_t i, Lanes& to) noexcept { to += a[i] * b[i]; };
  Lanes sum;
  sumOver(count, take, sum);
  return sumLanes(sum);
}

ESM_CPU_CLONES void setPair(std::size_t count, double fraction, const Lanes* change, const Lanes* before,
                            const Lanes* after, Lanes* step, Lanes* drop) noexcept
{
  for (std::size_t i = 0; i < count; ++i) {
    step[i] = change[i] * fraction;
    drop[i] = before[i] - after[i];
  }
}

} // namespace

void SecantPairs::clearAll() noexcept
{
  m_pairs = {};
  m_count = m_next = 0;
}

void SecantPairs::add(const NodeArray& change, double fraction, const NodeArray& before,
                      const NodeArray& after)
{
  Pair& oldest = m_pairs[m_next];
  const std::size_t count = change.size();
  for (NodeArray* array : {&oldest.step, &oldest.drop}) array->resize(count);
  setPair(count, fraction, change.data(), before.data(), after.data(), oldest.step.data(),
          oldest.drop.data());
  oldest.curvature = dotOf(count, oldest.step.data(), oldest.drop.data());
  const double lengths = std::sqrt(sumOfSquares(oldest.step) * sumOfSquares(oldest.drop));
  if (oldest.curvature > kLeastCosine * lengths) {
    m_next = (m_next + 1) % kMost;
    m_count = std::min(m_count + 1, kMost);
  } else {
    m_count = std::min(m_count, kMost - 1); // it has overwritten the oldest
  }
}

void SecantPairs::fold(NodeArray& residual) noexcept
{
  if (m_count == 0) return;
  const std::size_t count = residual.size();
  double seen = dotOf(count, pair(0).step.data(), residual.data());
  for (std::size_t age = 0; age < m_count; ++age) {
    Pair& here = pair(age);
    here.share = seen / here.curvature;
    const Pair& next = pair(std::min(age + 1, m_count - 1));
    seen = takeOff(count, here.share, here.drop.data(), residual.data(), next.step.data());
  }
}

void SecantPairs::unfold(NodeArray& change) noexcept
{
  if (m_count == 0) return;
  const std::size_t count = change.size();
  double seen = dotOf(count, pair(m_count - 1).drop.data(), change.data());
  for (std::size_t age = m_count; age-- > 0;) {
    const Pair &here = pair(age), &next = pair(age > 0 ? age - 1 : 0);
    seen =
      takeOff(count, seen / here.curvature - here.share, here.step.data(), change.data(), next.drop.data());
  }
}

} // namespace esm
