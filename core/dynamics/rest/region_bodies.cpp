// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The part of RegionDriver that knows what nothing holds: such a part of the net may go on for good, however
// slow its nodes are.
#include "core/dynamics/rest/region_driver.h"

#include "core/dynamics/system/frame.h"

#include <algorithm>
#include <cmath>

namespace esm {
/// Of the whole net, as they are now.
FreeBodies& RegionDriver::bodies()
{
  if (!m_bodiesAreKnown) {
    m_bodies.find(m_body.system);
    m_bodies.begin(m_body.system, m_body.motion);
    m_bodiesAreKnown = true;
  }
  return m_bodies;
}

/// Whether a free body would get anywhere as one if it were left alone.
bool RegionDriver::movesAsOne(std::size_t body)
{
  const FreeBodies::RigidMotion rigid = bodies().rigidMotion(m_body.system, m_body.motion, body);
  const double time = m_body.motion.time, end = m_driver.knownEnd(time);
  // At the end there is no way left, but velocities are looked at, too.
  const double left = std::isfinite(end) ? std::max(end - time, kFrame) : m_policy.rest.longWhile,
               motion = std::sqrt(meanSquare());
  return rigid.isDriven || rigid.speed * left > m_policy.rest.missedMomentum * motion ||
         rigid.turning * left > m_policy.rest.missedTurn * m_settings.tolerance * motion;
}

/// Who is awake in a free body sleeps with all others who are, or not at all.
void RegionDriver::keepBodiesAwake()
{
  if (bodies().isEmpty()) return;
  std::vector<std::uint8_t> isAwake(bodies().count(), 0), isRestless = isAwake;
  for (const Index node : m_region.awake()) {
    if (bodies().bodyOf(node) == kNoIndex) continue;
    const auto body = static_cast<std::size_t>(bodies().bodyOf(node));
    isAwake[body] = 1;
    if (!m_watch.slow()[static_cast<std::size_t>(node)]) isRestless[body] = 1;
  }
  std::vector<Index> restless;
  for (std::size_t body = 0; body < bodies().count(); ++body)
    if (isAwake[body] && !isRestless[body] && movesAsOne(body)) isRestless[body] = 1;
  for (const Index node : m_region.awake())
    if (const Index body = bodies().bodyOf(node);
        body != kNoIndex && isRestless[static_cast<std::size_t>(body)])
      restless.push_back(node);
  m_watch.pin(restless);
}

/// Those of a free body stay awake if not all who are awake are to sleep.
std::vector<Index> RegionDriver::wholeBodies(std::vector<Index> sleepers)
{
  std::vector<std::size_t> left(bodies().count(), 0);
  const auto bodyOf = [&](Index node) { return static_cast<std::size_t>(bodies().bodyOf(node)); };
  for (const Index node : m_region.awake())
    if (bodies().bodyOf(node) != kNoIndex) ++left[bodyOf(node)];
  for (const Index node : sleepers)
    if (bodies().bodyOf(node) != kNoIndex) --left[bodyOf(node)];
  std::erase_if(sleepers,
                [&](Index node) { return bodies().bodyOf(node) != kNoIndex && left[bodyOf(node)] > 0; });
  return sleepers;
}

} // namespace esm
