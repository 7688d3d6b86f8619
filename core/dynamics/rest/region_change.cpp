// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The part of RegionDriver that decides who wakes and who sleeps, and makes it so.
#include "core/dynamics/rest/region_driver.h"

#include "core/dynamics/system/diagonal.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

double diagonalOf(const NodeArray& x) noexcept
{
  const double square = squareOfDiagonal(x);
  return square > 0.0 && std::isfinite(square) ? std::sqrt(square) : 1.0;
}

double squareOf(const Lanes& a) noexcept
{
  return dot(a, a);
}

} // namespace

bool RegionDriver::isDivisible() const noexcept
{
  return m_region.freeCount() >= m_policy.rest.smallestDivisible && m_body.net.pressure.empty();
}

void RegionDriver::begin()
{
  m_driver.begin(m_body.system, m_body.motion);
  m_allMoved = true;
  m_moved.clear();
  m_work = 0.0;
  if (!m_on) return;
  const std::size_t nodes = m_body.motion.x.size();
  m_region = ActiveRegion(m_body.net);
  m_cutter.prepare(m_body.net);
  m_watch.prepare(nodes);
  m_tensions.prepare(static_cast<std::size_t>(m_body.net.springCount()));
  m_origin = m_still = m_body.motion.x;
  m_fresh.assign(nodes, 0);
  m_freshList.clear();
  m_played.assign(nodes, 0);
  m_playedCount = m_squareAsleep = 0.0;
  m_extent = diagonalOf(m_body.motion.x);
  m_limitText.clear();
  m_bodiesAreKnown = false;
  m_settling.begin();
  m_stirred = m_body.motion.time;
  watchLoads();
  std::vector<Index> seeds = unbalancedNodes();
  seeds.insert(seeds.end(), m_loads.moving().begin(), m_loads.moving().end());
  m_mode = Mode::Rest;
  m_changed = false;
  m_driverHasWhole = true;
  if (seeds.empty() || isDivisible()) keepTensions(); // else nobody is going to sleep now
  wake(seeds, kFirstLayers);
  applyChange();
}

/// Nodes that do not begin at rest: moving, or with a force that is more than rounding.
std::vector<Index> RegionDriver::unbalancedNodes()
{
  MotionState& motion = m_body.motion;
  const SpringNet& net = m_body.net;
  NodeArray force(motion.x.size());
  m_body.system.evaluate(motion.time, motion.x, motion.v, force);
  Eigen::ArrayXd tension(net.springCount());
  m_body.system.forces().springTensions(motion.x.data(), motion.v.data(), tension.data());
  NodeArray load(motion.x.size(), Lanes{0, 0, 0, 0});
  m_body.system.addLoads(motion.time, motion.v, load);
  const double tiny = m_extent * std::max(1e-10 * m_settings.tolerance, 1e-15);
  std::vector<double> yielding(motion.x.size(), 0.0), rounding = yielding; // [N]
  for (Index s = 0; s < net.springCount(); ++s)
    for (const Index node : {net.ends(0, s), net.ends(1, s)}) {
      yielding[static_cast<std::size_t>(node)] += tiny * net.stiffness[s];
      rounding[static_cast<std::size_t>(node)] += 1e-13 * std::abs(tension[s]);
    }
  for (Index k = 0; k < net.anchors.count(); ++k)
    yielding[static_cast<std::size_t>(net.anchors.node[static_cast<std::size_t>(k)])] +=
      tiny * net.anchors.stiffness[k];
  std::vector<Index> nodes;
  for (std::size_t i = 0; i < force.size(); ++i) {
    if (!m_body.system.isFree(i)) continue;
    const double pull = std::sqrt(squareOf(load[i] + m_body.system.forces().weight(i)));
    // Springs too stiff for their stretch to be seen need not be in the way of what pulls.
    const double bound =
      rounding[i] + (pull > 0.0 ? std::min(yielding[i], m_policy.rest.balanced * pull) : yielding[i]);
    if (squareOf(motion.v[i]) > 0.0 || !(squareOf(force[i]) <= bound * bound))
      nodes.push_back(static_cast<Index>(i));
  }
  for (std::size_t body = 0; body < bodies().count(); ++body) {
    const std::span<const Index> all = bodies().nodesOf(body);
    if (movesAsOne(body))
      nodes.insert(nodes.end(), all.begin(), bodies().isHeavy(body) ? all.end() : all.begin() + 1);
  }
  return nodes;
}

void RegionDriver::watchLoads()
{
  const double t = m_body.motion.time;
  m_loads.enter(m_body.loads, t, m_body.system.nextEvent(t));
}

/// Before a stretch: whom do the loads move in it?
void RegionDriver::wakeForLoads(bool eventIsReached)
{
  if (m_mode == Mode::Whole) return;
  std::vector<Index> seeds;
  for (const Index node : m_loads.moving())
    if (!m_region.isAwake(node)) seeds.push_back(node);
  if (eventIsReached)
    for (const Index node : m_loads.atEvent())
      if (!m_region.isAwake(node)) seeds.push_back(node);
  wake(seeds, kFirstLayers);
  applyChange();
}

/// Adds to the awake nodes; applyChange() makes it real.
void RegionDriver::wake(std::span<const Index> seeds, int layers)
{
  if (seeds.empty() || m_mode == Mode::Whole) return;
  const std::span<const Index> woken = m_region.wake(seeds, isDivisible() ? layers : 0); // else all wake
  for (const Index node : woken) {
    const auto i = static_cast<std::size_t>(node);
    m_still[i] = m_body.motion.x[i];
    m_squareAsleep -= squareOf(m_body.motion.x[i] - m_origin[i]);
    m_playedCount += m_played[i] ? 0.0 : 1.0;
    m_played[i] = 1;
    for (const Index spring : m_region.springsOf(node)) m_tensions.remove(spring);
  }
  m_watch.watch(woken, m_body.motion);
  m_changed = m_changed || !woken.empty();
}

void RegionDriver::applyChange()
{
  if (!m_changed) return;
  m_changed = false;
  closeLoss();
  const auto awake = static_cast<double>(m_region.awake().size());
  if (awake == 0.0) {
    m_mode = Mode::Rest;
    m_region.update(m_fresh);
  } else if (!isDivisible() || awake > m_policy.rest.largestPart * m_region.freeCount()) {
    enterWhole();
  } else {
    enterPart();
  }
  for (const Index node : m_freshList) m_fresh[static_cast<std::size_t>(node)] = 0;
  m_freshList.clear();
}

void RegionDriver::enterWhole()
{
  std::vector<Index> sleepers;
  for (std::size_t i = 0; i < m_body.motion.x.size(); ++i)
    if (const auto node = static_cast<Index>(i); !m_region.isAwake(node)) sleepers.push_back(node);
  wake(sleepers, 0); // fixed nodes are passed over
  m_changed = false;
  m_region.update(m_fresh);
  m_mode = Mode::Whole;
  m_settling.forget();
  m_stirred = m_body.motion.time;
  m_squareAsleep = 0.0;
  m_tensions.prepare(static_cast<std::size_t>(m_body.net.springCount()));
  if (m_driverHasWhole)
    m_driver.restart(m_body.system, m_body.motion); // velocities may have been cleared
  else
    m_driver.partChanged(m_body.system, m_body.motion, {{}, m_origin, m_body.motion.x.size(), 0.0});
  m_driverHasWhole = true;
}

void RegionDriver::enterPart()
{
  m_region.update(m_fresh);
  m_mode = Mode::Part;
  m_settling.forget();
  for (const ActiveRegion::Layered& layer : m_region.layers())
    if (const auto i = static_cast<std::size_t>(layer.node); layer.nearFresh) m_still[i] = m_body.motion.x[i];
  m_part = m_cutter.cut(m_body.net, m_body.loads, m_region);
  m_partSystem = System(m_part.net, m_part.loads);
  m_partSystem.setWorkers(m_body.system.workers());
  gather();
  m_partSystem.enter(m_partMotion, true);
  NetPart part{m_part.nodes, NodeArray(m_part.nodes.size()), m_body.motion.x.size(),
               std::max(m_squareAsleep, 0.0)};
  for (std::size_t i = 0; i < m_part.nodes.size(); ++i) {
    const Index node = m_part.nodes[i];
    // What held nodes are displaced by is counted among the sleepers.
    part.rest[i] = m_region.isAwake(node) ? m_origin[static_cast<std::size_t>(node)] : m_partMotion.x[i];
  }
  m_driver.partChanged(m_partSystem, m_partMotion, std::move(part));
  m_driverHasWhole = false;
}

/// The body's motion and tools to the part.
void RegionDriver::gather()
{
  const MotionState& motion = m_body.motion;
  m_partMotion.x.resize(m_part.nodes.size());
  m_partMotion.v.resize(m_part.nodes.size());
  for (std::size_t i = 0; i < m_part.nodes.size(); ++i) {
    const auto from = static_cast<std::size_t>(m_part.nodes[i]);
    m_partMotion.x[i] = motion.x[from];
    m_partMotion.v[i] = motion.v[from];
  }
  m_partMotion.time = motion.time;
  static_cast<EnergySums&>(m_partMotion) = motion;
  std::vector<ToolSpring> tools;
  for (ToolSpring tool : m_body.system.tools())
    if (m_region.isAwake(tool.node)) {
      tool.node = m_cutter.placeOf(tool.node);
      tools.push_back(tool);
    }
  m_partSystem.setTools(tools, m_partMotion.x, m_body.system.toolsSetAt());
}

/// The part's motion to the body, but not its time.
void RegionDriver::scatter()
{
  MotionState& motion = m_body.motion;
  for (const Index node : m_region.awake()) {
    const auto from = static_cast<std::size_t>(m_cutter.placeOf(node)), to = static_cast<std::size_t>(node);
    motion.x[to] = m_partMotion.x[from];
    motion.v[to] = m_partMotion.v[from];
  }
  static_cast<EnergySums&>(motion) = m_partMotion;
}

void RegionDriver::letSleep(const std::vector<Index>& nodes)
{
  MotionState& motion = m_body.motion;
  m_region.sleep(nodes);
  keepTensions();
  for (const Index node : nodes) {
    const auto i = static_cast<std::size_t>(node);
    motion.heat += 0.5 * m_body.system.mass()[i] * squareOf(motion.v[i]);
    motion.v[i] = Lanes{0, 0, 0, 0};
    m_squareAsleep += squareOf(motion.x[i] - m_origin[i]);
    m_fresh[i] = 1;
  }
  m_freshList.insert(m_freshList.end(), nodes.begin(), nodes.end());
  m_moved.insert(m_moved.end(), nodes.begin(), nodes.end());
  m_changed = true;
}

/// Notes the tensions of springs that are going to rest: both ends sleep, but the spring is evaluated still.
void RegionDriver::keepTensions()
{
  const bool part = m_mode == Mode::Part;
  const System& system = part ? m_partSystem : m_body.system;
  const MotionState& motion = part ? m_partMotion : m_body.motion;
  std::vector<double> tension(part ? m_part.springs.size()
                                   : static_cast<std::size_t>(m_body.net.springCount()));
  system.forces().springTensions(motion.x.data(), motion.v.data(), tension.data());
  for (std::size_t s = 0; s < tension.size(); ++s) {
    const Index spring = part ? m_part.springs[s] : static_cast<Index>(s);
    if (!m_region.isAwake(m_body.net.ends(0, spring)) && !m_region.isAwake(m_body.net.ends(1, spring)))
      m_tensions.add(spring, std::abs(tension[s]));
  }
}

/// @param awake  largest tension that StepDriver found.
double RegionDriver::largestTension(double awake)
{
  if (!m_on || m_mode == Mode::Whole) return awake;
  return m_mode == Mode::Rest ? m_tensions.largest() : std::max(awake, m_tensions.largest());
}

/// Of the displacement up to now, or as it is now, if that is more [m^2].
double RegionDriver::meanSquare() const noexcept
{
  const ErrorScale& scale = m_driver.errorScale();
  const double time = m_body.motion.time, now = scale.displacement * scale.displacement;
  return time > 0.0 ? std::max(now, scale.squareOverTime / time) : now;
}

/// Sum of squares that the sleepers may miss [m^2]; see the class.
double RegionDriver::budget() const noexcept
{
  const double floor = m_policy.errors.floor * m_extent, share = m_ledger.sleepers() * m_settings.tolerance;
  return share * share * std::max(meanSquare(), floor * floor) * static_cast<double>(m_body.motion.x.size());
}

/// The same where a motion ends as a whole, so that no step errs any more: what the steps have not spent of
/// the mean square, up to four fifths of the tolerance.
double RegionDriver::settlingBudget() const noexcept
{
  const ErrorScale scale = m_driver.errorScale();
  const double all = m_settings.tolerance * m_settings.tolerance * scale.squareOverTime;
  const double spent = all > 0.0 ? scale.spentSquare / all : 1.0,
               own = m_ledger.sleepers() * m_ledger.sleepers();
  return budget() / own * m_ledger.settling(spent);
}

/// Layers next to sleepers that are watched.
int RegionDriver::edgeDepth() const noexcept
{
  return std::max(4, m_region.radius() / 4);
}

/// What the sleepers miss, sum of squares [m^2]. Held at the edge, a displacement that would die out over L
/// layers goes as u = 2 u0 sinh(depth/L), where u0 is what the edge misses; inside and outside together the
/// error is u0^2 L for each node of the edge. The sum of u^2 over the depths to m and the one to m/2 are in
/// the ratio D(y)/D(y/2) with D(y) = sinh y - y and y = 2m/L, and the error is the first sum over D(y):
/// within a factor of two below (ratio - 8)^-3/2 of it. A ratio near 8 or less says that nothing dies out.
/// @param restless  gets the nodes of the edge that have more than their share of the budget; may be null.
double RegionDriver::missedMotion(std::vector<Index>* restless) const
{
  const auto& layers = m_region.layers();
  const int depth = edgeDepth();
  const auto last = std::partition_point(
    layers.begin(), layers.end(), [&](const ActiveRegion::Layered& layer) { return layer.depth <= depth; });
  const auto square = [&](const ActiveRegion::Layered& layer) {
    const auto place = static_cast<std::size_t>(m_cutter.placeOf(layer.node));
    return squareOf(m_partMotion.x[place] - m_still[static_cast<std::size_t>(layer.node)]);
  };
  double outer = 0.0, all = 0.0;
  for (auto layer = layers.begin(); layer != last; ++layer) {
    const double add = square(*layer);
    all += add;
    if (2 * layer->depth <= depth) outer += add;
  }
  if (restless)
    for (auto layer = layers.begin(); layer != last; ++layer)
      if (m_policy.rest.restlessShare * square(*layer) * static_cast<double>(last - layers.begin()) >= all)
        restless->push_back(layer->node);
  const double excess = all - 8.0 * outer; // (ratio - 8) outer
  if (!(excess > m_policy.rest.leastDecay * outer))
    return all / (m_policy.rest.leastDecay * std::sqrt(m_policy.rest.leastDecay));
  const double decay = std::min(excess / outer, m_policy.rest.mostDecay);
  return all / (decay * std::sqrt(decay));
}

/// Wakes more layers where the edge moves. @return whether anybody has woken.
bool RegionDriver::grow(bool late)
{
  std::vector<Index> restless;
  missedMotion(&restless);
  const int more = std::max(4, m_region.radius() / (late ? 2 : 4));
  wake(restless, edgeDepth() + more);
  return m_changed;
}

} // namespace esm
