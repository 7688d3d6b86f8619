// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/pressure.h"

#include "core/forces/spring_ends.h"

#include <array>

namespace esm {
namespace {

/// Four places of a corner (x, y, z), each seen from its own origin, in lanes.
struct Corners {
  Lanes x, y, z;

  ESM_INLINE void read(const std::array<std::uint32_t, 4>& place, const Lanes* positions,
                       const std::array<Lanes, 4>& from) noexcept
  {
    transpose(detail::at(positions, place[0]) - from[0], detail::at(positions, place[1]) - from[1],
              detail::at(positions, place[2]) - from[2], detail::at(positions, place[3]) - from[3], x, y, z);
  }
  /// this x other
  ESM_INLINE void cross(const Corners& other, Corners& product) const noexcept
  {
    product.x = y * other.z - z * other.y;
    product.y = z * other.x - x * other.z;
    product.z = x * other.y - y * other.x;
  }
};

/// Six times the volume within the triangles, seen from `origin`.
ESM_CPU_CLONES double sixVolumes(std::size_t count, const FourTriangles* triangles, const Lanes& origin,
                                 const Lanes* positions) noexcept
{
  const std::array<Lanes, 4> from = {origin, origin, origin, origin};
  Lanes sum = {0, 0, 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    Corners a, b, c, normal;
    a.read(triangles[i].a, positions, from);
    b.read(triangles[i].b, positions, from);
    c.read(triangles[i].c, positions, from);
    b.cross(c, normal);
    sum += a.x * normal.x + a.y * normal.y + a.z * normal.z;
  }
  return sumLanes(sum);
}

/// Adds `factor` times twice the area vector of each triangle to its corners.
ESM_CPU_CLONES void addNormals(std::size_t count, const FourTriangles* triangles, double factor,
                               const Lanes* positions, Lanes* to) noexcept
{
  for (std::size_t i = 0; i < count; ++i) {
    const FourTriangles& four = triangles[i];
    std::array<Lanes, 4> from;
    for (std::size_t k = 0; k < 4; ++k) from[k] = detail::at(positions, four.a[k]);
    Corners b, c, normal;
    b.read(four.b, positions, from);
    c.read(four.c, positions, from);
    b.cross(c, normal);
    Lanes share[4];
    detail::transposeBack(normal.x * factor, normal.y * factor, normal.z * factor, share[0], share[1],
                          share[2], share[3]);
    for (std::size_t k = 0; k < 4; ++k) {
      detail::at(to, four.a[k]) += share[k];
      detail::at(to, four.b[k]) += share[k];
      detail::at(to, four.c[k]) += share[k];
    }
  }
}

std::vector<FourTriangles> inFours(std::size_t nodeCount, const std::vector<Index>& corners)
{
  std::array<std::vector<Index>, 3> each;
  for (std::size_t t = 0; t < corners.size(); ++t) each[t % 3].push_back(corners[t]);
  const std::vector<std::size_t> order = conflictFreeOrder(nodeCount, {each[0], each[1], each[2]});
  std::vector<FourTriangles> fours((order.size() + 3) / 4);
  for (std::size_t t = 0; t < 4 * fours.size(); ++t) {
    const auto place = [&](std::size_t corner) { // what only fills up has no area
      return detail::placeOf(t < order.size() ? each[corner][order[t]] : corners.front());
    };
    FourTriangles& four = fours[t / 4];
    four.a[t % 4] = place(0);
    four.b[t % 4] = place(1);
    four.c[t % 4] = place(2);
  }
  return fours;
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
    made.fours = inFours(rest.size(), made.corners);
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
  return sixVolumes(body.fours.size(), body.fours.data(), x[body.corners.front()], x) / 6.0;
}

void Pressure::addGradientOf(const Body& body, double factor, const Lanes* x, Lanes* to) noexcept
{
  addNormals(body.fours.size(), body.fours.data(), factor / 6.0, x, to);
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
