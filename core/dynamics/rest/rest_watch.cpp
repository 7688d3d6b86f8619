// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/rest/rest_watch.h"

#include "core/dynamics/planner/policy.h"
#include "core/dynamics/system/frame.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

double length(const Lanes& a) noexcept
{
  return std::sqrt(dot(a, a));
}

} // namespace

void RestWatch::prepare(std::size_t nodes)
{
  m_x.assign(nodes, Lanes{0, 0, 0, 0});
  m_v.assign(nodes, Lanes{0, 0, 0, 0});
  m_nodes.assign(nodes, Watched{});
  m_slow.assign(nodes, 0);
  m_calm.assign(nodes, 0);
  m_slowCount = m_calmCount = m_firstSlowCount = 0;
  m_lookTime = 0.0;
}

void RestWatch::watch(std::span<const Index> nodes, const MotionState& motion)
{
  for (const Index node : nodes) {
    const auto i = static_cast<std::size_t>(node);
    m_x[i] = motion.x[i];
    m_v[i] = motion.v[i];
    m_nodes[i] = Watched{};
    m_slow[i] = m_calm[i] = 0;
  }
}

bool RestWatch::lookIsDue(double time) const noexcept
{
  return time - m_lookTime >= m_policy->lookGap;
}

void RestWatch::look(const std::vector<Index>& nodes, const MotionState& motion, double limit)
{
  const double window = std::max(motion.time - m_lookTime, 1e-3 * kFrame);
  const auto count = [](std::uint8_t looks, bool yes) {
    return static_cast<std::uint8_t>(yes ? std::min(looks + 1, 255) : 0);
  };
  m_lookTime = motion.time;
  m_slowCount = m_calmCount = m_firstSlowCount = 0;
  for (const Index node : nodes) {
    const auto i = static_cast<std::size_t>(node);
    Watched& watched = m_nodes[i];
    bool slow = length(motion.v[i]) * kFrame <= limit, calm = false;
    if (slow) {
      const double change = length(motion.v[i] - m_v[i]) / window;
      const double speed = length(motion.x[i] - m_x[i]) / window, before = watched.speed;
      const double lost = before - speed; // next to go: the rest of the series speed (1 + q + q^2 + ...)
      const double looks =
        lost > 0.0 ? std::min(before / lost, m_policy->longestSeries) : m_policy->longestSeries;
      slow = speed * kFrame * m_policy->someFrames <= limit;
      calm = slow && before >= 0.0 && 0.5 * change * m_policy->horizon * m_policy->horizon <= limit &&
             speed * window * looks <= limit;
      watched.speed = speed;
    } else {
      watched.speed = -1.0;
    }
    watched.slowLooks = count(watched.slowLooks, slow);
    watched.calmLooks = count(watched.calmLooks, calm);
    m_slow[i] = watched.slowLooks >= m_policy->looks ? 1 : 0;
    m_calm[i] = watched.calmLooks >= m_policy->looks ? 1 : 0;
    m_slowCount += m_slow[i];
    m_calmCount += m_calm[i];
    m_firstSlowCount += slow ? 1 : 0;
    m_x[i] = motion.x[i];
    m_v[i] = motion.v[i];
  }
}

void RestWatch::glance(const std::vector<Index>& nodes, const MotionState& motion, double limit)
{
  for (const Index node : nodes) {
    const auto i = static_cast<std::size_t>(node);
    if (length(motion.v[i]) * kFrame > limit) m_nodes[i].slowLooks = m_nodes[i].calmLooks = 0;
  }
}

void RestWatch::pin(std::span<const Index> nodes)
{
  for (const Index node : nodes) {
    const auto i = static_cast<std::size_t>(node);
    m_slowCount -= m_slow[i];
    m_calmCount -= m_calm[i];
    m_slow[i] = m_calm[i] = 0;
  }
}

} // namespace esm
