// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/loads.h"
#include "core/net/net_edit.h"

#include <vector>

namespace esm::test {

/// Several nets as one, with their loads.
struct Scene {
  SpringNet net;
  Loads loads;
  std::vector<std::vector<Index>> nodes, springs; ///< of each, places in the whole net
};

struct NetAndLoads {
  SpringNet net;
  Loads loads;
};

/// @pre no tables; gravity is that of the last.
inline Scene sideBySide(const std::vector<NetAndLoads>& parts)
{
  Scene scene;
  for (const auto& [part, loads] : parts) {
    SpringNet& net = scene.net;
    const Index n = net.nodeCount(), s = net.springCount(), a = net.anchors.count();
    if (n == 0) {
      net = part;
    } else {
      growNet(net, part.nodeCount(), part.springCount());
      net.restPosition.rightCols(part.nodeCount()) = part.restPosition;
      net.mass.tail(part.nodeCount()) = part.mass;
      std::copy(part.fixed.begin(), part.fixed.end(), net.fixed.begin() + n);
      net.ends.rightCols(part.springCount()) = part.ends.array() + n;
      net.restLength.tail(part.springCount()) = part.restLength;
      net.stiffness.tail(part.springCount()) = part.stiffness;
      net.viscosity.tail(part.springCount()) = part.viscosity;
      net.lawParameter.tail(part.springCount()) = part.lawParameter;
      std::copy(part.law.begin(), part.law.end(), net.law.begin() + s);
      std::copy(part.tensionOnly.begin(), part.tensionOnly.end(), net.tensionOnly.begin() + s);
      AnchorSet& set = net.anchors;
      for (const Index node : part.anchors.node) set.node.push_back(node + n);
      set.point.conservativeResize(3, a + part.anchors.count());
      set.point.rightCols(part.anchors.count()) = part.anchors.point;
      for (auto member : {&AnchorSet::stiffness, &AnchorSet::viscosity}) {
        (set.*member).conservativeResize(a + part.anchors.count());
        (set.*member).tail(part.anchors.count()) = part.anchors.*member;
      }
      for (PressureBody body : part.pressure) {
        body.triangles.array() += n;
        net.pressure.push_back(std::move(body));
      }
    }
    scene.nodes.emplace_back();
    for (Index i = 0; i < part.nodeCount(); ++i) scene.nodes.back().push_back(n + i);
    scene.springs.emplace_back();
    for (Index i = 0; i < part.springCount(); ++i) scene.springs.back().push_back(s + i);
    scene.loads.gravity = loads.gravity;
    for (NodalForce force : loads.forces) {
      for (Index& node : force.nodes) node += n;
      scene.loads.forces.push_back(std::move(force));
    }
    for (PrescribedMotion motion : loads.motions) {
      for (Index& node : motion.nodes) node += n;
      scene.loads.motions.push_back(std::move(motion));
    }
  }
  return scene;
}

} // namespace esm::test
