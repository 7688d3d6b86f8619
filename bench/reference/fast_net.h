// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/loads.h"
#include "core/net/spring_net.h"

#include <Eigen/Core>

#include <cstdint>
#include <new>
#include <vector>

#pragma GCC diagnostic ignored "-Wpsabi" // vector types are passed only to what is inlined

/// A second version for CPUs with AVX2 and FMA; the loader chooses.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(ESM_SANITIZED)
#define BENCH_CLONES __attribute__((target_clones("default", "arch=x86-64-v3")))
#else
#define BENCH_CLONES
#endif
#define BENCH_INLINE [[gnu::always_inline]] inline

namespace esm::bench {

using Vec4 = double __attribute__((vector_size(32)));
using Bits4 = std::int64_t __attribute__((vector_size(32)));

template <class T>
struct LineAllocator { ///< memory on cache line borders
  using value_type = T;
  LineAllocator() = default;
  template <class U>
  LineAllocator(const LineAllocator<U>&) noexcept
  {}
  T* allocate(std::size_t count)
  {
    return static_cast<T*>(::operator new (count * sizeof(T), std::align_val_t{64}));
  }
  void deallocate(T* memory, std::size_t) noexcept { ::operator delete (memory, std::align_val_t{64}); }
  template <class U>
  bool operator==(const LineAllocator<U>&) const noexcept
  {
    return true;
  }
};
using Nodes = std::vector<Vec4, LineAllocator<Vec4>>; ///< x, y, z, 0 of every node

/// The competitors' common ground: a net made ready for speed as a careful programmer would do it by hand in
/// an afternoon. Nodes are renumbered breadth-first, four doubles each; springs lie sorted by node and law;
/// four springs at a time are gathered, transposed and computed in AVX registers. No code of core/forces or
/// core/dynamics is used, and later tricks of the engine do not reach it: it stays what it is.
///
/// Loads may change their slope only between frames. Within a frame a prescribed node moves on a straight
/// line, so with its velocity set and its inverse mass 0 every method carries it exactly.
class FastNet {
public:
  /// @pre no tables, no tension-only springs, no mass damping: the scenes of the bench have none.
  FastNet(const SpringNet& net, const Loads& loads);

  std::size_t nodeCount() const { return m_mass.size(); }
  std::int64_t springCount() const { return m_springCount; }
  void start(Nodes& x, Nodes& v) const;
  /// Takes the loads' lines of the frame that begins at t and puts held nodes in their place.
  /// @return whether the equations have changed: multistep methods must start anew.
  bool beginFrame(double t, Nodes& x, Nodes& v);
  void forces(double t, const Vec4* x, const Vec4* v, Vec4* force);
  std::int64_t passes() const { return m_passes; } ///< calls of forces()

  const std::vector<double>& mass() const { return m_mass; }
  const std::vector<double>& inverseMass() const { return m_inverseMass; } ///< 0 = held now
  bool held(std::size_t node) const { return m_inverseMass[node] == 0.0; }
  void positions(const Nodes& x, Eigen::Matrix3Xd& out) const; ///< in the net's own order

  // === For the implicit and the position-based methods
  struct Spring {
    int a, b;
    double rest, stiffness, viscosity, parameter;
    SpringLaw law;
  };
  struct Anchor {
    int node;
    Vec4 point;
    double stiffness, viscosity;
  };
  /// dFa/dxb = axial u u^T + lateral (I - u u^T), dFa/dvb = viscous u u^T.
  struct Tangent {
    Vec4 u;
    double axial, lateral, viscous;
  };
  const std::vector<Spring>& springs() const { return m_springs; }
  const std::vector<Anchor>& anchors() const { return m_anchors; }
  static double tension(const Spring& spring, double extension);
  /// Of all springs; lateral >= 0, so that what is made of them stays positive definite.
  void tangents(const Nodes& x, std::vector<Tangent>& result) const;
  /// Weight and nodal forces at t, without springs and anchors.
  void externalForces(double t, Vec4* force) const;

  struct Group { ///< springs of one law, padded to groups of four
    SpringLaw law;
    bool damped;
    std::vector<int> a, b;
    std::vector<double> rest, stiffness, viscosity, parameter;
  };

private:
  struct Load {
    std::vector<int> nodes;
    VectorCurve curve;
    Vec4 value = {0, 0, 0, 0}, slope = {0, 0, 0, 0};
    double release = 0.0; ///< of a motion
    bool active = false;
  };
  void numberBreadthFirst(const SpringNet& net);

  std::vector<int> m_placeOf; ///< net's node -> place here
  std::vector<double> m_mass, m_freeInverseMass, m_inverseMass;
  Nodes m_start, m_startVelocity, m_weight;
  std::vector<Spring> m_springs;
  std::vector<Group> m_groups;
  std::vector<Anchor> m_anchors;
  std::vector<Load> m_forceLoads, m_motions;
  double m_frameStart = 0.0;
  bool m_begun = false;
  std::int64_t m_springCount = 0, m_passes = 0;
};

/// Stretch or turn of four springs: (x, y, z, 0) of four nodes to x, y, z of four springs.
BENCH_INLINE void transpose4(const Vec4& r0, const Vec4& r1, const Vec4& r2, const Vec4& r3, Vec4& x, Vec4& y,
                             Vec4& z) noexcept
{
  const Vec4 low = __builtin_shufflevector(r0, r1, 0, 4, 2, 6);
  const Vec4 high = __builtin_shufflevector(r2, r3, 0, 4, 2, 6);
  const Vec4 lowY = __builtin_shufflevector(r0, r1, 1, 5, 3, 7);
  const Vec4 highY = __builtin_shufflevector(r2, r3, 1, 5, 3, 7);
  x = __builtin_shufflevector(low, high, 0, 1, 4, 5);
  y = __builtin_shufflevector(lowY, highY, 0, 1, 4, 5);
  z = __builtin_shufflevector(low, high, 2, 3, 6, 7);
}

} // namespace esm::bench
