// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/node_array.h"
#include "core/net/spring_net.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace esm {

/// The corners of four triangles, as places in a NodeArray [bytes].
struct FourTriangles {
  std::array<std::uint32_t, 4> a, b, c;
};

/// The pressure in a net's closed surfaces (PressureBody). With V(x) the volume within one of them,
///
///     E = K V0/2 (V/V0 - 1)^2,   f = - dE/dx = p dV/dx,   p = - K (V/V0 - 1)
///
/// and dV/dx of a node is a third of the area vectors of its triangles; over a closed surface these sum to no
/// force and no torque. At rest V is V0 to the bit, so nothing moves. Its stiffness
///
///     K = K/V0 g g^T - p d2V/dx2,   g = dV/dx,
///
/// is of rank one per body but for the second part, which turns the pressure with the surface: small against
/// the springs, it is left out of implicit matrices (the equations themselves have all of it).
///
/// Sums run over the triangles four at a time, in one order: equal input, equal bits, whatever the threads
/// and the processor. Any thread may call the functions at the same time. Without bodies nothing is done.
class Pressure {
public:
  Pressure() = default;
  explicit Pressure(const SpringNet& net);

  bool isEmpty() const noexcept { return m_bodies.empty(); }
  std::size_t bodyCount() const noexcept { return m_bodies.size(); }
  std::size_t triangleCount() const noexcept;

  /// Adds f to `force`. Conservative: the velocities do not matter.
  void addForces(const Lanes* x, Lanes* force) const noexcept;
  double energy(const Lanes* x) const noexcept; ///< [J]

  double volume(std::size_t body, const Lanes* x) const noexcept; ///< [m^3]
  double restVolume(std::size_t body) const noexcept { return m_bodies[body].restVolume; }
  double pressure(std::size_t body, const Lanes* x) const noexcept; ///< p [Pa]
  /// Nodes of its triangles, three by three.
  const std::vector<Index>& corners(std::size_t body) const noexcept { return m_bodies[body].corners; }
  /// K/V0 of g g^T [Pa/m^3].
  double stiffness(std::size_t body) const noexcept
  {
    return m_bodies[body].bulkModulus / m_bodies[body].restVolume;
  }
  /// Adds g to `gradient` [m^2].
  void addGradient(std::size_t body, const Lanes* x, Lanes* gradient) const noexcept;
  /// visit(node, r): parts of a bound r [N/m] of a node's row sums of p d2V/dx2. A corner's gradient turns
  /// with each corner of its triangle by a sixth of the side across.
  template <class Visit>
  void boundTurning(std::size_t body, const Lanes* x, const Visit& visit) const
  {
    const double most = std::abs(pressure(body, x)) / 6.0;
    const std::vector<Index>& corners = m_bodies[body].corners;
    for (std::size_t t = 0; t < corners.size(); t += 3) {
      const Lanes &a = x[corners[t]], &b = x[corners[t + 1]], &c = x[corners[t + 2]];
      const double sides = lengthOf(b - a) + lengthOf(c - b) + lengthOf(a - c);
      for (std::size_t k = 0; k < 3; ++k) visit(corners[t + k], most * sides);
    }
  }

private:
  struct Body {
    std::vector<Index> corners;       ///< of triangle t: 3 t to 3 t + 2
    std::vector<FourTriangles> fours; ///< all of them in the order of conflictFreeOrder(), for the passes
    double bulkModulus = 0.0;         ///< [Pa]
    double restVolume = 0.0;          ///< [m^3]
  };
  static double lengthOf(const Lanes& edge) noexcept { return std::sqrt(dot(edge, edge)); }
  static double volumeOf(const Body& body, const Lanes* x) noexcept;
  static void addGradientOf(const Body& body, double factor, const Lanes* x, Lanes* to) noexcept;

  std::vector<Body> m_bodies;
};

} // namespace esm
