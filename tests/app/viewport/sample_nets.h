// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/net/spring_net.h"
#include "core/runtime/sim_thread.h"

#include <functional>
#include <memory>

namespace esm::samples {

using Shape = std::function<Eigen::Vector3d(const Eigen::Vector3d& unit)>; ///< unit sphere to space [m]

/// A closed net over an octahedron refined `levels` times (4^levels * 8 triangles, outward), its vertices
/// moved by `shape`. Stiffness 100 N/m everywhere. Node 0 is the pole +x, 1 -x, 2 +y, 3 -y, 4 +z, 5 -z.
std::shared_ptr<SpringNet> ball(int levels, const Shape& shape);

/// A sphere of that radius around a centre [m].
std::shared_ptr<SpringNet> sphere(int levels, double radius,
                                  const Eigen::Vector3d& centre = Eigen::Vector3d::Zero());

/// Adds struts (kind Line) between the pairs of nodes, stiffness 100 N/m.
void addStruts(SpringNet& net, const std::vector<std::pair<Index, Index>>& pairs);

/// A snapshot of the net at rest, as the simulation thread would send it.
SimSnapshot restSnapshot(const SpringNet& net, std::uint64_t generation, std::uint64_t sequence);

} // namespace esm::samples
