// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/structure/support.h"

#include "core/base/text_number.h"
#include "core/geometry/distance.h"
#include "core/net/net_builder.h"
#include "core/net/net_edit.h"
#include "core/net/solid_net.h"
#include "core/structure/net_cost.h"
#include "core/structure/support_parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace esm {

namespace {

using Interior = SupportOptions::Interior;

Status checkOptions(const SupportOptions& options)
{
  const auto wrong = [](const char* what) { return Error{ErrorCode::InvalidValue, what}; };
  if (options.strutsPerNode < 1 || options.strutsPerNode > 16)
    return wrong("the struts per node must be from 1 to 16");
  if (!(options.strutLean >= 0.0 && options.strutLean <= 1.4))
    return wrong("the struts' lean must be from 0 to 1.4 rad");
  if (!(std::isfinite(options.longestStrut) && options.longestStrut >= 0.0))
    return wrong("the longest strut must not be below 0 m");
  if (options.hubs < 0 || options.hubs > 1000) return wrong("the number of hubs must be from 0 to 1000");
  if (!(std::isfinite(options.latticeCell) && options.latticeCell >= 0.0))
    return wrong("the lattice's cell must not be below 0 m");
  if (!(std::isfinite(options.wallThickness) && options.wallThickness >= 0.0))
    return wrong("the wall's thickness must not be below 0 m");
  if (options.wallLayers < 0 || options.wallLayers > 16)
    return wrong("the wall's layers must be from 0 to 16");
  if (!(std::isfinite(options.anchorLength) && options.anchorLength > 0.0))
    return wrong("the anchors' bands must be longer than 0 m");
  if (!(options.anchorPart.centre.allFinite() && options.anchorPart.semiAxes.allFinite() &&
        options.anchorPart.semiAxes.minCoeff() > 0.0))
    return wrong("the anchored part must be an ellipsoid with half axes above 0 m");
  if (!(std::isfinite(options.bulkModulus) && options.bulkModulus >= 0.0))
    return wrong("the bulk modulus of the pressure must not be below 0 Pa");
  if (!(std::isfinite(options.timeLimit) && options.timeLimit > 0.0))
    return wrong("the program's time limit must be above 0 s");
  return {};
}

double median(std::vector<double> values)
{
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Numbers for struts in a net that has its own: as its springs, by their length.
struct Example {
  double stiffnessTimesLength = 0.0, retardation = 0.0, mass = 1.0;
  explicit Example(const SpringNet& net)
  {
    std::vector<double> products, ratios;
    for (Index s = 0; s < net.springCount(); ++s)
      if (net.stiffness[s] > 0.0) {
        products.push_back(net.stiffness[s] * net.restLength[s]);
        ratios.push_back(net.viscosity[s] / net.stiffness[s]);
      }
    stiffnessTimesLength = median(std::move(products));
    retardation = median(std::move(ratios));
    mass = median({net.mass.begin(), net.mass.end()});
  }
};

void addLayer(SpringNet& net, const support::Layer& layer, SupportReport& report)
{
  const Example example(net);
  const Index oldNodes = net.nodeCount(), oldSprings = net.springCount();
  const auto nodes = static_cast<Index>(layer.nodes.cols()),
             springs = static_cast<Index>(layer.struts.size());
  if (net.section.size() == 0) net.section.setZero(oldSprings);
  if (nodes > 0) {
    if (net.volume.size() == 0) net.volume.setZero(oldNodes);
    net.supportNode.assign(static_cast<std::size_t>(oldNodes), 0);
  }
  growNet(net, nodes, springs);
  for (Index i = 0; i < nodes; ++i) {
    const Index node = oldNodes + i;
    net.restPosition.col(node) = layer.nodes.col(i);
    net.mass[node] = example.mass;
    net.volume[node] = layer.volume[i];
    net.supportNode[static_cast<std::size_t>(node)] = 1;
  }
  for (Index i = 0; i < springs; ++i) {
    const support::Strut& strut = layer.struts[static_cast<std::size_t>(i)];
    const Index s = oldSprings + i;
    net.ends.col(s) << strut.a, strut.b;
    net.restLength[s] = distance(net.restPosition.col(strut.a), net.restPosition.col(strut.b));
    net.stiffness[s] = example.stiffnessTimesLength / net.restLength[s];
    net.viscosity[s] = example.retardation * net.stiffness[s];
    net.kind[static_cast<std::size_t>(s)] = strut.kind;
    net.section[s] = strut.section;
  }
  if (layer.surfaceSection.size() > 0) net.section.head(oldSprings) = layer.surfaceSection;
  if (layer.surfaceVolume.size() > 0) net.volume.head(oldNodes) = layer.surfaceVolume;
  if (layer.tetrahedra.cols() > 0) {
    std::vector<Index> itself(static_cast<std::size_t>(net.nodeCount()));
    std::iota(itself.begin(), itself.end(), 0);
    addSolidShares(net.restPosition, layer.tetrahedra, itself, net);
  }
  report.nodes = nodes;
  report.springs = springs;
  if (springs > 0) {
    report.shortest = net.restLength.tail(springs).minCoeff();
    report.longest = net.restLength.tail(springs).maxCoeff();
  }
}

Result<support::Layer> makeInterior(const SpringNet& net, const SupportOptions& options, WorkControl* control)
{
  switch (options.interior) {
  case Interior::None:
    return support::Layer{};
  case Interior::Struts:
    return support::makeStruts(net, options, control);
  case Interior::Hub:
    return support::makeHubs(net, options, control);
  case Interior::Lattice:
    return support::makeLattice(net, options, control);
  case Interior::Tetrahedra:
    return support::makeTetrahedra(net, options, control);
  case Interior::Wall:
    return support::makeWall(net, options, control);
  }
  return Error{ErrorCode::InvalidValue, "this kind of interior is not known"};
}

} // namespace

Result<SupportReport> addSupport(SpringNet& net, const SupportOptions& options, WorkControl* control)
{
  if (Status status = checkOptions(options); !status) return status.error();
  SpringNet made = net;
  removeSupport(made);
  SupportReport report;
  if (options.isNone()) {
    net = std::move(made);
    return report;
  }
  if (made.triangleCount() == 0)
    return Error{
      ErrorCode::EmptyResult,
      "the net has no surface, only lines, so there is nothing that could be supported from inside or "
      "anchored"};
  if (options.interior != Interior::None && isSolidNet(made))
    return Error{ErrorCode::InvalidValue,
                 "the net is solid already, by the tetrahedra of its file: it needs no interior"};
  report.stepBefore = predictCost(made).step;
  Result<support::Layer> layer = makeInterior(made, options, control);
  if (!layer) return layer.error();
  if (options.interior != Interior::None) {
    if (layer->struts.empty())
      return Error{
        ErrorCode::EmptyResult,
        "no strut found its way: the surface is flat or lies open, so no wall is opposite another"};
    addLayer(made, *layer, report);
    for (const Index node : layer->unsupported)
      report.unsupported.push_back(made.nodeId[static_cast<std::size_t>(node)]);
    report.notes = std::move(layer->notes);
    if (!report.unsupported.empty())
      report.notes.push_back(std::to_string(report.unsupported.size()) +
                             " nodes of the surface found no wall opposite and got no strut");
  }
  if (options.anchors != SupportOptions::Anchors::None) {
    report.anchors = support::addBands(made, options);
    if (report.anchors == 0)
      return Error{ErrorCode::EmptyResult,
                   "no node of the surface lies in the part that is to be anchored; move or enlarge it"};
  }
  if (options.bulkModulus > 0.0) {
    report.pressureBodies = support::addPressure(made, options.bulkModulus, control);
    if (stopWanted(control)) return cancelledError();
    if (report.pressureBodies == 0)
      return Error{ErrorCode::EmptyResult,
                   "no part of the surface is closed, so there is no volume that pressure could keep; fill "
                   "its holes, or leave the pressure out"};
  }
  report.stepAfter = predictCost(made).step;
  net = std::move(made);
  return report;
}

} // namespace esm
