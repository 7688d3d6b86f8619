// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/loads.h"
#include "core/net/spring_net.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace esm::bench {

/// The textbook program: one struct per node and per spring, one loop with a switch over the laws, a step
/// chosen by hand. It shares no code with core/forces and core/dynamics, so it serves twice: as the
/// competitor that times are set against, and at a tiny step as the reference that errors are measured
/// against. Motions and releases must fall on steps.
class PlainNet {
public:
  PlainNet(const SpringNet& net, const Loads& loads);
  void stepSymplecticEuler(double h);
  void stepRungeKutta4(double h);
  double time() const { return m_time; }
  void positions(Eigen::Matrix3Xd& x) const;

private:
  struct Node {
    Eigen::Vector3d start, x, v, force;
    double mass = 1.0, drag = 0.0;
    bool fixed = false;
    int motion = -1;
  };
  struct Spring {
    Index a, b;
    double k, c, length, parameter;
    SpringLaw law;
    bool tensionOnly;
  };
  struct Anchor {
    Index node;
    Eigen::Vector3d point;
    double k, c;
  };
  bool held(const Node& node, double t) const;
  void place(double t, double releaseAfter);
  void computeForces(double t);

  std::vector<Node> m_nodes;
  std::vector<Spring> m_springs;
  std::vector<Anchor> m_anchors;
  Loads m_loads;
  double m_time = 0.0;
  long m_steps = 0;
};

} // namespace esm::bench
