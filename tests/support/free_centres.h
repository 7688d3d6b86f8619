// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/simulation.h"
#include "core/forces/loads.h"
#include "core/net/spring_net.h"

#include <vector>

namespace esm::test {

/// Where the centres of mass of the parts of a net that nothing holds must be: by m a = F from weight and
/// nodal forces alone, integrated exactly from corner to corner of their curves. Knows nothing of the engine.
class FreeCentres {
public:
  FreeCentres(const SpringNet& net, const Loads& loads, const NetState& start);

  /// How far centres or their velocities are from there at most, over a thousandth of a millionth of the
  /// largest displacement or speed of a node of the part so far (and rounding of positions, and eps sum|f| T^2/M
  /// of forces that cancel out): above 1 momentum or fall is not kept. To be called at each release, which begins a part's flight.
  double look(const NetState& state);
  std::size_t freeCount() const; ///< parts that fly now

private:
  struct Part {
    std::vector<Index> nodes;
    double mass = 0.0;
    bool isHeld = false, isFlying = false;
    double motion = 0.0, speed = 0.0; ///< largest so far [m], [m/s]
    double start = 0.0;               ///< of the flight [s]
    double pulled = 0.0;              ///< sum of the sizes of all forces, over its time [N s]
    Eigen::Vector3d x, v;             ///< of its centre at m_time, in flight
    Eigen::Matrix3Xd from;            ///< positions when the flight began
  };
  bool isMoved(const Part& part, double time) const;
  Eigen::Vector3d forceOn(const Part& part, double from, double at) const;
  double sizeOfForcesOn(const Part& part, double from, double at) const;
  void fly(Part& part, double to) const;

  const SpringNet& m_net;
  const Loads& m_loads;
  std::vector<Part> m_parts;
  std::vector<Index> m_partOf;
  std::vector<double> m_corners; ///< of all curves, rising
  double m_time = 0.0;
};

} // namespace esm::test
