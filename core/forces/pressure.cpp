// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/pressure.h"

namespace esm {

namespace {

Lanes cross(const Lanes& a, const Lanes& b) noexcept
{
  return Lanes{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0], 0.0};
}

} // namespace

Pressure::Pressure(const SpringNet& net)
{
  if (net.pressure.empty()) return;
  NodeArray rest(static_cast<std::size_t>(net.nodeCount()));
  copyNodes(net.restPosition, rest);
  for (const PressureBody& body : net.pressure) {
    Body& made = m_bodies.emplace_back();
    made.corners.assign(body.triangles.data(), body.triangles.data() + body.triangles.size());
    made.bulkModulus = body.bulkModulus;
    made.restVolume = volumeOf(made, rest.data());
  }
}

std::size_t Pressure::triangleCount() const noexcept
{
  std::size_t count = 0;
  for (const Body& body : m_bodies) count += body.corners.size() / 3;
  return count;
}

/// Seen from a node of its own, so that a body far from the origin loses no digits.
double Pressure::volumeOf(const Body& body, const Lanes* x) noexcept
{
  if (body.corners.empty()) return 0.0;
  const Lanes origin = x[body.corners.front()];
  double sum = 0.0;
  for (std::size_t t = 0; t < body.corners.size(); t += 3) {
    const Lanes a = x[body.corners[t]] - origin, b = x[body.corners[t + 1]] - origin,
                c = x[body.corners[t + 2]] - origin;
    sum += dot(a, cross(b, c));
  }
  return sum / 6.0;
}

void Pressure::addGradientOf(const Body& body, double factor, const Lanes* x, Lanes* to) noexcept
{
  for (std::size_t t = 0; t < body.corners.size(); t += 3) {
    const Index a = body.corners[t], b = body.corners[t + 1], c = body.corners[t + 2];
    const Lanes share = cross(x[b] - x[a], x[c] - x[a]) * (factor / 6.0);
    to[a] += share;
    to[b] += share;
    to[c] += share;
  }
}

void Pressure::addForces(const Lanes* x, Lanes* force) const noexcept
{
  for (std::size_t body = 0; body < m_bodies.size(); ++body)
    if (const double p = pressure(body, x); p != 0.0) addGradientOf(m_bodies[body], p, x, force);
}

double Pressure::energy(const Lanes* x) const noexcept
{
  double sum = 0.0;
  for (const Body& body : m_bodies) {
    const double change = volumeOf(body, x) / body.restVolume - 1.0;
    sum += 0.5 * body.bulkModulus * body.restVolume * change * change;
  }
  return sum;
}

double Pressure::volume(std::size_t body, const Lanes* x) const noexcept
{
  return volumeOf(m_bodies[body], x);
}

double Pressure::pressure(std::size_t body, const Lanes* x) const noexcept
{
  return -m_bodies[body].bulkModulus * (volumeOf(m_bodies[body], x) / m_bodies[body].restVolume - 1.0);
}

void Pressure::addGradient(std::size_t body, const Lanes* x, Lanes* gradient) const noexcept
{
  addGradientOf(m_bodies[body], 1.0, x, gradient);
}

} // namespace esm
