// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/net/outward_surface.h"
#include "core/structure/support_parts.h"

#include <limits>

namespace esm::support {

namespace {

/// The smallest closed part around a cavity; kNoIndex if there is none.
Index partAround(const OutwardSurface& surface, const Eigen::Vector3d& place)
{
  Index around = kNoIndex;
  double least = std::numeric_limits<double>::infinity();
  for (Index p = 0; p < static_cast<Index>(surface.parts().size()); ++p) {
    const OutwardSurface::Part& part = surface.parts()[static_cast<std::size_t>(p)];
    if (!part.isClosed || part.isCavity || part.volume >= least) continue;
    const auto isOther = [&](Index t) { return surface.partOf(t) != p; };
    if (surface.tree().crossings(place, kObliqueDirection, isOther) % 2 == 0) continue;
    around = p;
    least = part.volume;
  }
  return around;
}

} // namespace

Index addPressure(SpringNet& net, double bulkModulus, WorkControl* control)
{
  const OutwardSurface surface(net, control);
  if (stopWanted(control)) return 0;
  const std::size_t parts = surface.parts().size();
  std::vector<Index> bodyOf(parts, kNoIndex), first(parts, kNoIndex), count(parts, 0);
  for (Index t = net.triangleCount(); t-- > 0;) first[static_cast<std::size_t>(surface.partOf(t))] = t;
  for (std::size_t p = 0; p < parts; ++p) {
    const OutwardSurface::Part& part = surface.parts()[p];
    if (!part.isClosed || !part.isOriented) continue;
    const Eigen::Vector3d place = net.restPosition.col(surface.triangles()(0, first[p]));
    bodyOf[p] = part.isCavity ? partAround(surface, place) : static_cast<Index>(p);
    if (stopWanted(control)) return 0;
  }
  for (Index t = 0; t < net.triangleCount(); ++t)
    if (const Index body = bodyOf[static_cast<std::size_t>(surface.partOf(t))]; body != kNoIndex)
      ++count[static_cast<std::size_t>(body)];
  Index added = 0;
  for (Index p = 0; p < static_cast<Index>(parts); ++p) {
    if (count[static_cast<std::size_t>(p)] == 0) continue;
    PressureBody body{TriangleMatrix(3, count[static_cast<std::size_t>(p)]), bulkModulus};
    Index next = 0;
    for (Index t = 0; t < net.triangleCount(); ++t)
      if (bodyOf[static_cast<std::size_t>(surface.partOf(t))] == p)
        body.triangles.col(next++) = surface.triangles().col(t);
    net.pressure.push_back(std::move(body));
    ++added;
  }
  return added;
}

} // namespace esm::support
