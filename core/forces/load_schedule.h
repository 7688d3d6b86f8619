// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/forces/loads.h"
#include "core/forces/node_array.h"

#include <limits>

namespace esm {

/// Whether the loads are possible for a net of `nodes` nodes: nodes in range and in one motion at most, times
/// rising, numbers finite. The detail names the first culprit.
Status checkLoads(const Loads& loads, Index nodes);

/// Loads over time, cut at their events (corners and jumps of the curves, releases): between two events every
/// force and every prescribed position is a straight line. A step must not reach over an event; at its end it
/// sees the line from the left, and after enter() the one from the right.
class LoadSchedule {
public:
  LoadSchedule() = default;
  /// @param start  3 x N positions that displacements count from [m].
  /// @param fixed  N; a fixed node stays, whatever a motion says.
  LoadSchedule(const Loads& loads, const Eigen::Matrix3Xd& start, const std::vector<std::uint8_t>& fixed);

  /// Takes the lines that begin at t, an event or the start; does not allocate. Afterwards prescribed() is
  /// what it will be until the next event.
  void enter(double t) noexcept;
  /// The first event after t; infinity if there is none.
  double nextEvent(double t) const noexcept;
  /// When the first of the motions that are held now lets go; infinity if none does.
  double nextRelease() const noexcept;

  /// When the last of nodal forces that come and go has gone [s]; infinity where there is no force, one stays,
  /// or nodes are moved.
  double endOfBlows() const noexcept { return m_endOfBlows; }

  struct PrescribedNode {
    Index node = kNoIndex;
    std::size_t motion = 0;
    Lanes start = {0, 0, 0, 0}; ///< [m]
  };
  bool isEmpty() const noexcept { return m_motions.empty() && m_forces.empty(); }
  bool anyMotion() const noexcept { return !m_nodes.empty(); }
  bool movesAnyNow() const noexcept; ///< whether place() has something to do
  bool isActive(const PrescribedNode& node) const noexcept { return m_motions[node.motion].active; }
  const std::vector<PrescribedNode>& prescribedNodes() const noexcept { return m_nodes; }

  /// Sets position and velocity of the nodes that are prescribed now.
  void place(double t, Lanes* x, Lanes* v) const noexcept;
  /// Adds the nodal forces at t. @return their power [W] at the velocities v.
  double addForces(double t, const Lanes* v, Lanes* force) const noexcept;
  double power(double t, const Lanes* v) const noexcept; ///< of the nodal forces, at other velocities [W]
  /// visit(node, force at t [N], its slope [N/s]) for each node of each nodal force.
  template <class Visit>
  void forEachForce(double t, const Visit& visit) const noexcept
  {
    for (const Force& load : m_forces) {
      if (load.absent) continue;
      const Lanes value = load.line.value + load.line.slope * (t - m_begin);
      for (const NodeRun& run : load.nodes)
        for (std::size_t i = run.first; i < run.first + run.count; ++i) visit(i, value, load.line.slope);
    }
  }

private:
  struct Line { ///< value at m_begin, slope
    Lanes value = {0, 0, 0, 0}, slope = {0, 0, 0, 0};
  };
  struct Motion {
    VectorCurve displacement;
    double release = std::numeric_limits<double>::infinity();
    bool active = false;
    Line line;
  };
  /// Nodes that follow each other, as those of a whole net or of a part that was numbered in one piece do.
  struct NodeRun {
    std::size_t first, count;
  };
  struct Force {
    VectorCurve force;
    std::vector<NodeRun> nodes;
    Line line;
    bool absent = false; ///< zero on the whole line
  };
  template <class Visit>
  double forEachRun(double t, const Visit& visit) const noexcept;

  double m_begin = 0.0;
  std::vector<Motion> m_motions;
  std::vector<PrescribedNode> m_nodes;
  std::vector<Force> m_forces;
  std::vector<double> m_events;                                  ///< rising, distinct
  double m_endOfBlows = std::numeric_limits<double>::infinity(); ///< [s]
};

} // namespace esm
