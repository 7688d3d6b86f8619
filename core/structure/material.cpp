// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/structure/material.h"

#include "core/net/net_builder.h"
#include "core/net/outward_surface.h"
#include "core/net/solid_net.h"
#include "core/quality/tension_test.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

namespace {

/// Shares the volume among the nodes: a node has half of each of its struts, and of the wall what lies around
/// it.
void shareVolume(SpringNet& net, double volume, double thickness)
{
  Eigen::ArrayXd share = nodeDualAreas(net) * thickness;
  for (Index s = 0; s < net.springCount(); ++s)
    if (isOfSupport(net.kind[static_cast<std::size_t>(s)]))
      for (int end = 0; end < 2; ++end) share[net.ends(end, s)] += 0.5 * net.sectionOf(s) * net.restLength[s];
  net.volume = share * (volume / share.sum());
}

Status makeSolid(SpringNet& net, double thickness, MaterialReport& report, WorkControl* control)
{
  if (isSolidNet(net)) {
    report.volume = net.volume.sum();
    return {};
  }
  const OutwardSurface surface(net, control);
  if (stopWanted(control)) return cancelledError();
  if (!surface.isClosed())
    return Error{ErrorCode::InvalidValue,
                 "the surface is not closed, so it has no volume that could be filled with "
                 "tissue; fill its holes, or choose the wall"};
  report.volume = surface.volume();
  if (!(report.volume > 0.0)) return Error{ErrorCode::InvalidValue, "the surface encloses no volume"};
  shareVolume(net, report.volume, thickness);
  return {};
}

/// The wall's volumes are those of the surface's nodes; new nodes of the support layer keep theirs.
void makeWall(SpringNet& net, double thickness, MaterialReport& report)
{
  if (!isSolidNet(net) && net.volume.size() > 0) {
    const Eigen::ArrayXd area = nodeDualAreas(net);
    for (Index node = 0; node < net.nodeCount(); ++node)
      if (area[node] > 0.0) net.volume[node] = 0.0;
    if ((net.volume == 0.0).all()) net.volume.resize(0);
  }
  report.volume =
    (isSolidNet(net) ? 0.0 : report.wallArea * thickness) + (net.volume.size() > 0 ? net.volume.sum() : 0.0);
}

} // namespace

Result<MaterialReport> setMaterial(SpringNet& net, const MaterialOptions& options, double thickness,
                                   WorkControl* control)
{
  if (!(std::isfinite(thickness) && thickness > 0.0))
    return Error{ErrorCode::InvalidValue, "the wall's thickness must be above 0 m"};
  SpringNet made = net;
  made.material = {options.edges, 1.0};
  MaterialReport report;
  report.wallArea = nodeDualAreas(made).sum();
  if (options.body == MaterialOptions::Body::Solid) {
    if (Status status = makeSolid(made, thickness, report, control); !status) return status.error();
  } else {
    makeWall(made, thickness, report);
  }
  const bool isWallOfCells =
    std::find(made.kind.begin(), made.kind.end(), SpringKind::WallAcross) != made.kind.end();
  if (options.isFitted() && !isWallOfCells) { // whose cells are calibrated one by one
    const bool isSolid = options.body == MaterialOptions::Body::Solid || isSolidNet(made);
    const Result<TensionTest> test = testTension(made, thickness, isSolid, control);
    if (!test) return test.error();
    report.measured = test->measured / test->wanted;
    report.axis = test->axis;
    report.scale = made.material.modulusScale = 1.0 / report.measured;
  }
  net = std::move(made);
  return report;
}

} // namespace esm
