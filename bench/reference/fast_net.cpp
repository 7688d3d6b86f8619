// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/reference/fast_net.h"

#include "core/base/assert.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace esm::bench {
namespace {

constexpr double kTooShort = 1e-12; // [m]

Vec4 vec4(const Eigen::Vector3d& value)
{
  return Vec4{value.x(), value.y(), value.z(), 0.0};
}

BENCH_INLINE void load4(const double* from, Vec4& to) noexcept
{
  __builtin_memcpy(&to, from, sizeof(to));
}

/// exp(s) - 1, |s| < 700: s = n ln 2 + r, Taylor in r to r^13.
BENCH_INLINE void expMinusOne4(const Vec4& s, Vec4& result) noexcept
{
  constexpr double kRound = 0x1.8p52;
  const Vec4 shifted = s * 0x1.71547652b82fep+0 + kRound;
  const Vec4 n = shifted - kRound;
  const Vec4 r = (s - n * 0x1.62e42fefa3800p-1) - n * 0x1.ef35793c76730p-45;
  Vec4 p = r * (1.0 / 6227020800.0) + (1.0 / 479001600.0);
  p = p * r + (1.0 / 39916800.0);
  p = p * r + (1.0 / 3628800.0);
  p = p * r + (1.0 / 362880.0);
  p = p * r + (1.0 / 40320.0);
  p = p * r + (1.0 / 5040.0);
  p = p * r + (1.0 / 720.0);
  p = p * r + (1.0 / 120.0);
  p = p * r + (1.0 / 24.0);
  p = p * r + (1.0 / 6.0);
  p = p * r + 0.5;
  p = p * (r * r) + r;
  Bits4 bits;
  __builtin_memcpy(&bits, &shifted, sizeof(bits));
  bits = (bits + 1023) << 52;
  Vec4 power;
  __builtin_memcpy(&power, &bits, sizeof(power));
  result = power * p + (power - 1.0);
}

/// Elastic tension of springs i .. i+3. The group's stiffness holds k, or k L/b for the exponential law, its
/// parameter holds a/L^2 or b/L.
template <SpringLaw law>
BENCH_INLINE void tension4(const FastNet::Group& group, std::size_t i, const Vec4& e, Vec4& f) noexcept
{
  Vec4 k, p;
  load4(&group.stiffness[i], k);
  if constexpr (law == SpringLaw::Linear) {
    f = k * e;
  } else {
    load4(&group.parameter[i], p);
    if constexpr (law == SpringLaw::Cubic) {
      f = k * e * (1.0 + p * (e * e));
    } else {
      const Vec4 s = p * e, most = Vec4{0, 0, 0, 0} + 600.0;
      const Vec4 below = s > most ? most : s;
      expMinusOne4(below < -most ? -most : below, f);
      f *= k;
    }
  }
}

template <SpringLaw law, bool damped>
BENCH_INLINE void pass(const FastNet::Group& group, const Vec4* x, const Vec4* v, Vec4* force) noexcept
{
  const int* endA = group.a.data();
  const int* endB = group.b.data();
  const Vec4 zero = {0, 0, 0, 0}, one = {1, 1, 1, 1};
  const std::size_t count = group.a.size();
  for (std::size_t i = 0; i < count; i += 4) {
    const int a0 = endA[i], a1 = endA[i + 1], a2 = endA[i + 2], a3 = endA[i + 3];
    const int b0 = endB[i], b1 = endB[i + 1], b2 = endB[i + 2], b3 = endB[i + 3];
    const Vec4 d0 = x[b0] - x[a0], d1 = x[b1] - x[a1], d2 = x[b2] - x[a2], d3 = x[b3] - x[a3];
    Vec4 dx, dy, dz, rest, pull;
    transpose4(d0, d1, d2, d3, dx, dy, dz);
    Vec4 length = dx * dx + dy * dy + dz * dz;
    for (int lane = 0; lane < 4; ++lane) length[lane] = __builtin_sqrt(length[lane]);
    const Bits4 tooShort = length < one * kTooShort;
    const Vec4 inverse = one / (tooShort ? one : length);
    load4(&group.rest[i], rest);
    tension4<law>(group, i, length - rest, pull);
    if constexpr (damped) {
      const Vec4 w0 = v[b0] - v[a0], w1 = v[b1] - v[a1], w2 = v[b2] - v[a2], w3 = v[b3] - v[a3];
      Vec4 wx, wy, wz, c;
      transpose4(w0, w1, w2, w3, wx, wy, wz);
      load4(&group.viscosity[i], c);
      pull += c * ((wx * dx + wy * dy + wz * dz) * inverse);
    }
    const Vec4 scale = (tooShort ? zero : pull) * inverse;
    const Vec4 f0 = d0 * scale[0], f1 = d1 * scale[1], f2 = d2 * scale[2], f3 = d3 * scale[3];
    force[a0] += f0;
    force[b0] -= f0;
    force[a1] += f1;
    force[b1] -= f1;
    force[a2] += f2;
    force[b2] -= f2;
    force[a3] += f3;
    force[b3] -= f3;
  }
}

BENCH_CLONES void passLinear(const FastNet::Group& group, const Vec4* x, const Vec4* v, Vec4* force)
{
  group.damped ? pass<SpringLaw::Linear, true>(group, x, v, force)
               : pass<SpringLaw::Linear, false>(group, x, v, force);
}

BENCH_CLONES void passCubic(const FastNet::Group& group, const Vec4* x, const Vec4* v, Vec4* force)
{
  group.damped ? pass<SpringLaw::Cubic, true>(group, x, v, force)
               : pass<SpringLaw::Cubic, false>(group, x, v, force);
}

BENCH_CLONES void passExponential(const FastNet::Group& group, const Vec4* x, const Vec4* v, Vec4* force)
{
  group.damped ? pass<SpringLaw::Exponential, true>(group, x, v, force)
               : pass<SpringLaw::Exponential, false>(group, x, v, force);
}

BENCH_CLONES void anchorPass(const std::vector<FastNet::Anchor>& anchors, const Vec4* x, const Vec4* v,
                             Vec4* force)
{
  for (const FastNet::Anchor& anchor : anchors)
    force[anchor.node] -=
      (x[anchor.node] - anchor.point) * anchor.stiffness + v[anchor.node] * anchor.viscosity;
}

FastNet::Group makeGroup(SpringLaw law, bool damped, const std::vector<FastNet::Spring>& springs)
{
  FastNet::Group group{law, damped, {}, {}, {}, {}, {}, {}};
  const auto add = [&](int a, int b, double rest, double k, double c, double p) {
    group.a.push_back(a);
    group.b.push_back(b);
    group.rest.push_back(rest);
    group.stiffness.push_back(k);
    group.viscosity.push_back(c);
    group.parameter.push_back(p);
  };
  for (const FastNet::Spring& s : springs) {
    if (s.law != law || (s.viscosity > 0.0) != damped) continue;
    if (law == SpringLaw::Exponential)
      add(s.a, s.b, s.rest, s.stiffness * s.rest / s.parameter, s.viscosity, s.parameter / s.rest);
    else
      add(s.a, s.b, s.rest, s.stiffness, s.viscosity, s.parameter / (s.rest * s.rest));
  }
  while (group.a.size() % 4 != 0) add(0, 0, 1.0, 0.0, 0.0, 0.0);
  return group;
}

} // namespace

FastNet::FastNet(const SpringNet& net, const Loads& loads)
{
  ESM_ASSERT(net.tables.empty() && net.massDamping.size() == 0);
  numberBreadthFirst(net);
  const auto count = static_cast<std::size_t>(net.nodeCount());
  m_mass.resize(count);
  m_freeInverseMass.resize(count);
  m_start.resize(count);
  m_startVelocity.assign(count, Vec4{0, 0, 0, 0});
  m_weight.resize(count);
  for (Index i = 0; i < net.nodeCount(); ++i) {
    const auto place = static_cast<std::size_t>(m_placeOf[static_cast<std::size_t>(i)]);
    const bool fixed = net.fixed[static_cast<std::size_t>(i)] != 0;
    m_mass[place] = net.mass[i];
    m_freeInverseMass[place] = fixed ? 0.0 : 1.0 / net.mass[i];
    m_start[place] = vec4(net.restPosition.col(i));
    if (net.initialVelocity.cols() > 0 && !fixed) m_startVelocity[place] = vec4(net.initialVelocity.col(i));
    m_weight[place] = vec4(net.mass[i] * loads.gravity);
  }
  m_inverseMass = m_freeInverseMass;
  const auto placeOf = [&](Index node) { return m_placeOf[static_cast<std::size_t>(node)]; };
  for (Index s = 0; s < net.springCount(); ++s) {
    SpringLaw law = net.law[static_cast<std::size_t>(s)];
    if (net.lawParameter[s] == 0.0) law = SpringLaw::Linear;
    int a = placeOf(net.ends(0, s)), b = placeOf(net.ends(1, s));
    if (a > b) std::swap(a, b);
    m_springs.push_back(
      {a, b, net.restLength[s], net.stiffness[s], net.viscosity[s], net.lawParameter[s], law});
  }
  std::sort(m_springs.begin(), m_springs.end(), [](const Spring& left, const Spring& right) {
    return left.a != right.a ? left.a < right.a : left.b < right.b;
  });
  m_springCount = net.springCount();
  for (const SpringLaw law : {SpringLaw::Linear, SpringLaw::Cubic, SpringLaw::Exponential})
    for (const bool damped : {false, true})
      if (Group group = makeGroup(law, damped, m_springs); !group.a.empty())
        m_groups.push_back(std::move(group));
  for (Index i = 0; i < net.anchors.count(); ++i)
    m_anchors.push_back({placeOf(net.anchors.node[static_cast<std::size_t>(i)]),
                         vec4(net.anchors.point.col(i)), net.anchors.stiffness[i], net.anchors.viscosity[i]});
  std::sort(m_anchors.begin(), m_anchors.end(),
            [](const Anchor& left, const Anchor& right) { return left.node < right.node; });
  const auto makeLoad = [&](const std::vector<Index>& nodes, const VectorCurve& curve, double release) {
    Load load;
    for (const Index node : nodes) load.nodes.push_back(placeOf(node));
    std::sort(load.nodes.begin(), load.nodes.end());
    load.curve = curve;
    load.release = release;
    return load;
  };
  for (const NodalForce& force : loads.forces)
    m_forceLoads.push_back(makeLoad(force.nodes, force.force, 0.0));
  for (const PrescribedMotion& motion : loads.motions)
    m_motions.push_back(makeLoad(motion.nodes, motion.displacement,
                                 motion.release.value_or(std::numeric_limits<double>::infinity())));
}

void FastNet::numberBreadthFirst(const SpringNet& net)
{
  const auto count = static_cast<std::size_t>(net.nodeCount());
  std::vector<std::vector<int>> neighbours(count);
  for (Index s = 0; s < net.springCount(); ++s) {
    neighbours[static_cast<std::size_t>(net.ends(0, s))].push_back(net.ends(1, s));
    neighbours[static_cast<std::size_t>(net.ends(1, s))].push_back(net.ends(0, s));
  }
  m_placeOf.assign(count, -1);
  std::vector<int> queue;
  queue.reserve(count);
  for (std::size_t seed = 0; seed < count; ++seed) {
    if (m_placeOf[seed] >= 0) continue;
    m_placeOf[seed] = static_cast<int>(queue.size());
    queue.push_back(static_cast<int>(seed));
    for (std::size_t head = queue.size() - 1; head < queue.size(); ++head)
      for (const int next : neighbours[static_cast<std::size_t>(queue[head])])
        if (int& place = m_placeOf[static_cast<std::size_t>(next)]; place < 0) {
          place = static_cast<int>(queue.size());
          queue.push_back(next);
        }
  }
}

void FastNet::start(Nodes& x, Nodes& v) const
{
  x = m_start;
  v = m_startVelocity;
}

bool FastNet::beginFrame(double t, Nodes& x, Nodes& v)
{
  constexpr double kSame = 1e-9; // [s]: frames and events are written with other roundings
  bool changed = !m_begun;
  m_begun = true;
  m_frameStart = t;
  const auto takeLine = [&](Load& load) {
    const Vec4 slope = vec4(load.curve.slopeAt(t + kSame)),
               value = vec4(load.curve.at(t + kSame)) - slope * kSame;
    for (int lane = 0; lane < 3; ++lane) changed = changed || slope[lane] != load.slope[lane];
    load.slope = slope;
    load.value = value;
  };
  for (Load& load : m_forceLoads) {
    takeLine(load);
    const Vec4 size = load.value * load.value + load.slope * load.slope;
    load.active = size[0] + size[1] + size[2] > 1e-30;
  }
  for (Load& motion : m_motions) {
    takeLine(motion);
    const bool before = motion.active;
    motion.active = t < motion.release - kSame;
    changed = changed || before != motion.active;
    for (const int node : motion.nodes) {
      const auto i = static_cast<std::size_t>(node);
      if (m_freeInverseMass[i] == 0.0) continue; // fixed stays fixed
      m_inverseMass[i] = motion.active ? 0.0 : m_freeInverseMass[i];
      if (!motion.active) continue;
      x[i] = m_start[i] + motion.value;
      v[i] = motion.slope;
    }
  }
  return changed;
}

void FastNet::externalForces(double t, Vec4* force) const
{
  std::copy(m_weight.begin(), m_weight.end(), force);
  for (const Load& load : m_forceLoads) {
    if (!load.active) continue;
    const Vec4 value = load.value + load.slope * (t - m_frameStart);
    for (const int node : load.nodes) force[node] += value;
  }
}

void FastNet::forces(double t, const Vec4* x, const Vec4* v, Vec4* force)
{
  ++m_passes;
  externalForces(t, force);
  anchorPass(m_anchors, x, v, force);
  for (const Group& group : m_groups) {
    if (group.law == SpringLaw::Linear) passLinear(group, x, v, force);
    if (group.law == SpringLaw::Cubic) passCubic(group, x, v, force);
    if (group.law == SpringLaw::Exponential) passExponential(group, x, v, force);
  }
}

double FastNet::tension(const Spring& s, double e)
{
  if (s.law == SpringLaw::Cubic) return s.stiffness * e * (1.0 + s.parameter * e * e / (s.rest * s.rest));
  if (s.law == SpringLaw::Exponential)
    return s.stiffness * s.rest / s.parameter * std::expm1(std::min(s.parameter * e / s.rest, 600.0));
  return s.stiffness * e;
}

void FastNet::tangents(const Nodes& x, std::vector<Tangent>& result) const
{
  result.resize(m_springs.size());
  for (std::size_t i = 0; i < m_springs.size(); ++i) {
    const Spring& s = m_springs[i];
    const Vec4 d = x[static_cast<std::size_t>(s.b)] - x[static_cast<std::size_t>(s.a)];
    const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    if (length < kTooShort) {
      result[i] = {Vec4{0, 0, 0, 0}, 0.0, 0.0, 0.0};
      continue;
    }
    const double e = length - s.rest;
    double axial = s.stiffness;
    if (s.law == SpringLaw::Cubic) axial *= 1.0 + 3.0 * s.parameter * e * e / (s.rest * s.rest);
    if (s.law == SpringLaw::Exponential) axial *= std::exp(std::min(s.parameter * e / s.rest, 600.0));
    result[i] = {d / length, axial, std::max(0.0, tension(s, e) / length), s.viscosity};
  }
}

void FastNet::positions(const Nodes& x, Eigen::Matrix3Xd& out) const
{
  out.resize(3, static_cast<Eigen::Index>(x.size()));
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec4& value = x[static_cast<std::size_t>(m_placeOf[i])];
    out.col(static_cast<Eigen::Index>(i)) << value[0], value[1], value[2];
  }
}

} // namespace esm::bench
