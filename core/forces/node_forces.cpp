// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/node_forces.h"

#include "core/forces/spring_pass.h"

#include <algorithm>

namespace esm {
namespace {

/// The arrays of a sweep, all from its first node on.
struct Bedding {
  std::size_t count;
  Lanes gravity;
  const double *mass, *stiffness, *viscosity;
  const Lanes *point, *x, *v;
};

ESM_INLINE bool isHeavy(const Lanes& gravity) noexcept
{
  return gravity[0] != 0.0 || gravity[1] != 0.0 || gravity[2] != 0.0;
}

template <bool hasWeight>
ESM_INLINE double setBeddedAs(const Bedding& given, Lanes* force) noexcept
{
  const Bedding bed = given; // as ESM_CPU_CLONES says
  Lanes heat = {0, 0, 0, 0};
  for (std::size_t i = 0; i < bed.count; ++i) {
    const Lanes drag = bed.v[i] * bed.viscosity[i];
    const Lanes held = (bed.point[i] - bed.x[i]) * bed.stiffness[i] - drag;
    if constexpr (hasWeight)
      force[i] = bed.gravity * bed.mass[i] + held;
    else
      force[i] = held;
    heat += drag * bed.v[i];
  }
  return sumLanes(heat);
}

ESM_CPU_CLONES double setBedded(const Bedding& bed, Lanes* force) noexcept
{
  return isHeavy(bed.gravity) ? setBeddedAs<true>(bed, force) : setBeddedAs<false>(bed, force);
}

ESM_CPU_CLONES void setWeight(std::size_t count, const Lanes& gravity, const double* mass,
                              Lanes* force) noexcept
{
  const Lanes pull = gravity; // as ESM_CPU_CLONES says
  for (std::size_t i = 0; i < count; ++i) force[i] = pull * mass[i];
}

} // namespace

NodeForces::NodeForces(const SpringNet& net, const Eigen::Vector3d& gravity,
                       const std::vector<Anchor>& anchors, const std::vector<double>& massDrag,
                       const NodeRanges& ranges)
  : m_ranges(ranges),
    m_mass(net.mass.begin(), net.mass.end()),
    m_gravity(toLanes(gravity)),
    m_firstFew(ranges.count() + 1, 0)
{
  const auto count = static_cast<std::size_t>(net.nodeCount());
  if (4 * anchors.size() < count && massDrag.empty()) { // a list entry costs as much as four nodes
    m_few = anchors;
    m_firstFew.back() = m_few.size();
    for (std::size_t range = 1; range < ranges.count(); ++range) {
      const auto isBelow = [](const Anchor& anchor, std::size_t node) {
        return static_cast<std::size_t>(anchor.node) < node;
      };
      const auto found = std::lower_bound(m_few.begin(), m_few.end(), ranges.first(range), isBelow);
      m_firstFew[range] = static_cast<std::size_t>(found - m_few.begin());
    }
    return;
  }
  m_viscosity = massDrag;
  m_viscosity.resize(count, 0.0);
  m_stiffness.assign(count, 0.0);
  m_point.assign(count, Lanes{0, 0, 0, 0});
  for (const Anchor& anchor : anchors) addToBed(anchor);
}

void NodeForces::addToBed(const Anchor& anchor) noexcept
{
  const auto i = static_cast<std::size_t>(anchor.node);
  const double total = m_stiffness[i] + anchor.stiffness;
  if (m_stiffness[i] == 0.0)
    m_point[i] = anchor.point; // exactly
  else if (total > 0.0)
    m_point[i] += (anchor.point - m_point[i]) * (anchor.stiffness / total);
  m_stiffness[i] = total;
  m_viscosity[i] += anchor.viscosity;
}

void NodeForces::setBed(Index node, double massDrag, const std::vector<Anchor>& anchors,
                        std::span<const Index> own)
{
  if (m_stiffness.empty()) { // the list of few is that of all
    for (const Index k : own) m_few[static_cast<std::size_t>(k)] = anchors[static_cast<std::size_t>(k)];
    return;
  }
  const auto i = static_cast<std::size_t>(node);
  m_stiffness[i] = 0.0;
  m_viscosity[i] = massDrag;
  m_point[i] = Lanes{0, 0, 0, 0};
  for (const Index k : own) addToBed(anchors[static_cast<std::size_t>(k)]);
}

double NodeForces::set(std::size_t range, const Lanes* x, const Lanes* v, Lanes* force) const noexcept
{
  const std::size_t first = m_ranges.first(range), count = m_ranges.size(range);
  if (!m_stiffness.empty())
    return setBedded({count, m_gravity, m_mass.data() + first, m_stiffness.data() + first,
                      m_viscosity.data() + first, m_point.data() + first, x + first, v + first},
                     force + first);
  if (isHeavy(m_gravity))
    setWeight(count, m_gravity, m_mass.data() + first, force + first);
  else
    std::fill_n(force + first, count, Lanes{0, 0, 0, 0});
  Lanes heat = {0, 0, 0, 0};
  for (const Anchor& anchor : few(range)) {
    const Lanes drag = v[anchor.node] * anchor.viscosity;
    force[anchor.node] += (anchor.point - x[anchor.node]) * anchor.stiffness - drag;
    heat += drag * v[anchor.node];
  }
  return sumLanes(heat);
}

void NodeForces::addFewDampers(std::size_t range, const Lanes* v, Lanes* force) const noexcept
{
  for (const Anchor& anchor : few(range)) force[anchor.node] -= v[anchor.node] * anchor.viscosity;
}

} // namespace esm
