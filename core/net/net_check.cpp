// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/text_number.h"
#include "core/net/net_builder.h"
#include "core/net/parameter_patch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <string>

namespace esm {

namespace {

template <class Id>
std::string named(const char* what, const std::vector<Id>& ids, Index i)
{
  return std::string(what) + " " + std::to_string(i) + " (id " +
         std::to_string(static_cast<Index>(ids[static_cast<std::size_t>(i)])) + ")";
}

/// "spring 12 (id 12): stiffness is -3 N/m, it must be >= 0"
Error badNumber(const std::string& owner, const char* quantity, double value, const char* unit,
                const char* rule)
{
  return invalidValue(owner + ": " + quantity + " is " + formatDouble(value) + (*unit ? " " : "") + unit +
                      ", it must be " + rule);
}

struct Shape {
  const char* name;
  std::size_t size, wanted;
  bool mayBeAbsent = false;
};

Status checkShapes(std::span<const Shape> shapes)
{
  for (const Shape& shape : shapes)
    if (shape.size != shape.wanted && !(shape.mayBeAbsent && shape.size == 0))
      return invalidValue("the net's array " + std::string(shape.name) + " holds " +
                          std::to_string(shape.size) + " entries, it must hold " +
                          std::to_string(shape.wanted));
  return {};
}

Status checkAnchorShapes(const AnchorSet& anchors)
{
  const auto size = [](const auto& array) { return static_cast<std::size_t>(array.size()); };
  const std::size_t count = anchors.node.size();
  const Shape shapes[] = {
    {"anchors.point", static_cast<std::size_t>(anchors.point.cols()), count},
    {"anchors.stiffness", size(anchors.stiffness), count},
    {"anchors.viscosity", size(anchors.viscosity), count},
    {"anchors.bandLength", size(anchors.bandLength), count, true},
  };
  return checkShapes(shapes);
}

Status checkArrays(const SpringNet& net)
{
  if (net.restPosition.cols() > kMostNetNodes)
    return invalidValue("the net has " + std::to_string(net.restPosition.cols()) + " nodes, it may have " +
                        std::to_string(kMostNetNodes) +
                        ": simplify the mesh or cut it into several projects");
  const auto cols = [](const auto& matrix) { return static_cast<std::size_t>(matrix.cols()); };
  const auto size = [](const auto& array) { return static_cast<std::size_t>(array.size()); };
  const std::size_t n = cols(net.restPosition), s = cols(net.ends);
  const Shape shapes[] = {
    {"initialVelocity", cols(net.initialVelocity), n, true},
    {"mass", size(net.mass), n},
    {"massDamping", size(net.massDamping), n, true},
    {"fixed", net.fixed.size(), n},
    {"nodeId", net.nodeId.size(), n},
    {"volume", size(net.volume), n, true},
    {"supportNode", net.supportNode.size(), n, true},
    {"restLength", size(net.restLength), s},
    {"stiffness", size(net.stiffness), s},
    {"viscosity", size(net.viscosity), s},
    {"law", net.law.size(), s},
    {"lawParameter", size(net.lawParameter), s},
    {"tensionOnly", net.tensionOnly.size(), s},
    {"kind", net.kind.size(), s},
    {"springId", net.springId.size(), s},
    {"section", size(net.section), s, true},
  };
  if (Status status = checkShapes(shapes); !status) return status;
  return checkAnchorShapes(net.anchors);
}

template <class Id>
Status checkDistinct(const char* what, const std::vector<Id>& ids)
{
  const auto notRising = [](Id a, Id b) { return a >= b; };
  if (std::adjacent_find(ids.begin(), ids.end(), notRising) == ids.end()) return {}; // as after an import
  std::vector<Index> order(ids.size());
  std::iota(order.begin(), order.end(), 0);
  const auto id = [&ids](Index i) { return ids[static_cast<std::size_t>(i)]; };
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return id(a) < id(b); });
  for (std::size_t k = 1; k < order.size(); ++k)
    if (id(order[k - 1]) == id(order[k]))
      return invalidValue(named(what, ids, order[k]) + ": the id is already taken by " + what + " " +
                          std::to_string(order[k - 1]));
  return {};
}

bool notNegative(double value)
{
  return std::isfinite(value) && value >= 0.0;
}

/// @param owner  called only for who is named.
template <class Owner>
Status checkInertia(const Owner& owner, double mass, double damping)
{
  if (!(std::isfinite(mass) && mass > 0.0)) return badNumber(owner(), "mass", mass, "kg", "> 0");
  if (!notNegative(damping)) return badNumber(owner(), "mass damping", damping, "1/s", ">= 0");
  return {};
}

template <class Owner>
Status checkBed(const Owner& owner, double stiffness, double viscosity)
{
  if (!notNegative(stiffness)) return badNumber(owner(), "stiffness", stiffness, "N/m", ">= 0");
  if (!notNegative(viscosity)) return badNumber(owner(), "viscosity", viscosity, "N s/m", ">= 0");
  return {};
}

Status checkNodes(const SpringNet& net)
{
  for (Index i = 0; i < net.nodeCount(); ++i) {
    const auto owner = [&] { return named("node", net.nodeId, i); };
    for (int k = 0; k < 3; ++k) {
      if (!std::isfinite(net.restPosition(k, i)))
        return badNumber(owner(), "rest position", net.restPosition(k, i), "m", "finite");
      if (net.initialVelocity.cols() > 0 && !std::isfinite(net.initialVelocity(k, i)))
        return badNumber(owner(), "initial velocity", net.initialVelocity(k, i), "m/s", "finite");
    }
    const double damping = net.massDamping.size() > 0 ? net.massDamping[i] : 0.0;
    if (Status status = checkInertia(owner, net.mass[i], damping); !status) return status;
    if (!notNegative(net.volumeOf(i))) return badNumber(owner(), "volume", net.volumeOf(i), "m^3", ">= 0");
  }
  return checkDistinct("node", net.nodeId);
}

Status checkTables(const SpringNet& net)
{
  for (std::size_t t = 0; t < net.tables.size(); ++t) {
    const ForceTable& table = net.tables[t];
    const std::string owner = "force table " + std::to_string(t);
    if (table.strain.size() != table.force.size())
      return invalidValue(owner + ": it holds " + std::to_string(table.strain.size()) + " strains but " +
                          std::to_string(table.force.size()) + " forces");
    if (table.strain.size() < 2) return invalidValue(owner + ": it must hold at least two points");
    for (std::size_t i = 0; i < table.strain.size(); ++i) {
      const std::string point = owner + ", point " + std::to_string(i);
      if (!std::isfinite(table.strain[i])) return badNumber(point, "strain", table.strain[i], "", "finite");
      if (!std::isfinite(table.force[i])) return badNumber(point, "force", table.force[i], "", "finite");
      if (i > 0 && !(table.strain[i] > table.strain[i - 1]))
        return badNumber(point, "strain", table.strain[i], "", "above the strain before it");
    }
  }
  return {};
}

Status checkLaw(const SpringNet& net, Index s, SpringLaw law, double parameter, const std::string& owner)
{
  if (law > SpringLaw::Table)
    return badNumber(owner, "law number", static_cast<double>(law), "", "a SpringLaw");
  if (law != SpringLaw::Linear && !(net.restLength[s] > 0.0))
    return badNumber(owner, "rest length", net.restLength[s], "m", "> 0, for its law divides by it");
  if (!std::isfinite(parameter)) return badNumber(owner, "law parameter", parameter, "", "finite");
  if (law == SpringLaw::Table && !(parameter >= 0.0 && parameter == std::floor(parameter) &&
                                   parameter < static_cast<double>(net.tables.size())))
    return badNumber(owner, "law parameter", parameter, "", "the number of a force table of the net");
  return {};
}

Status checkSprings(const SpringNet& net)
{
  for (Index s = 0; s < net.springCount(); ++s) {
    const Index a = net.ends(0, s), b = net.ends(1, s);
    const bool inRange = std::min(a, b) >= 0 && std::max(a, b) < net.nodeCount();
    const bool good = inRange && a != b && notNegative(net.restLength[s]) && notNegative(net.stiffness[s]) &&
                      notNegative(net.viscosity[s]) && notNegative(net.sectionOf(s));
    const bool simple =
      net.law[static_cast<std::size_t>(s)] == SpringLaw::Linear && std::isfinite(net.lawParameter[s]);
    if (good && simple) continue;

    const std::string owner = named("spring", net.springId, s);
    if (!inRange)
      return invalidValue(owner + ": its ends are nodes " + std::to_string(a) + " and " + std::to_string(b) +
                          ", they must be below " + std::to_string(net.nodeCount()));
    if (a == b) return invalidValue(owner + ": both ends are node " + std::to_string(a));
    if (!notNegative(net.restLength[s]))
      return badNumber(owner, "rest length", net.restLength[s], "m", ">= 0");
    if (!notNegative(net.stiffness[s])) return badNumber(owner, "stiffness", net.stiffness[s], "N/m", ">= 0");
    if (!notNegative(net.viscosity[s]))
      return badNumber(owner, "viscosity", net.viscosity[s], "N s/m", ">= 0");
    if (!notNegative(net.sectionOf(s))) return badNumber(owner, "section", net.sectionOf(s), "m^2", ">= 0");
    if (Status status = checkLaw(net, s, net.law[static_cast<std::size_t>(s)], net.lawParameter[s], owner);
        !status)
      return status;
  }
  return checkDistinct("spring", net.springId);
}

Status checkAnchors(const AnchorSet& anchors, Index nodeCount)
{
  for (Index i = 0; i < anchors.count(); ++i) {
    const Index node = anchors.node[static_cast<std::size_t>(i)];
    const std::string owner = "anchor " + std::to_string(i);
    if (node < 0 || node >= nodeCount)
      return invalidValue(owner + ": it holds node " + std::to_string(node) + ", the net has " +
                          std::to_string(nodeCount) + " nodes");
    for (int k = 0; k < 3; ++k)
      if (!std::isfinite(anchors.point(k, i)))
        return badNumber(owner, "point", anchors.point(k, i), "m", "finite");
    const auto name = [&]() -> const std::string& { return owner; };
    if (Status status = checkBed(name, anchors.stiffness[i], anchors.viscosity[i]); !status) return status;
    if (anchors.bandLength.size() > 0 && !notNegative(anchors.bandLength[i]))
      return badNumber(owner, "length of its band", anchors.bandLength[i], "m", ">= 0");
  }
  return {};
}

Status checkBeds(const SpringNet& net)
{
  return checkAnchors(net.anchors, net.nodeCount());
}

Status checkMaterial(const SpringNet& net)
{
  const double scale = net.material.modulusScale;
  if (!(std::isfinite(scale) && scale > 0.0))
    return badNumber("the net's material", "scale of Young's modulus", scale, "", "> 0");
  return {};
}

/// Of what a closed surface encloses [m^3].
double enclosedVolume(const SpringNet& net, const TriangleMatrix& triangles)
{
  double sum = 0.0;
  const Eigen::Vector3d origin = net.restPosition.col(triangles(0, 0));
  for (const auto& triangle : triangles.colwise()) {
    Eigen::Vector3d corner[3];
    for (int k = 0; k < 3; ++k) corner[k] = net.restPosition.col(triangle[k]) - origin;
    sum += corner[0].dot(corner[1].cross(corner[2]));
  }
  return sum / 6.0;
}

Status checkBulkModulus(const std::string& owner, double modulus)
{
  if (!(std::isfinite(modulus) && modulus > 0.0))
    return badNumber(owner, "bulk modulus", modulus, "Pa", "> 0");
  return {};
}

Status checkPressure(const SpringNet& net)
{
  for (std::size_t i = 0; i < net.pressure.size(); ++i) {
    const PressureBody& body = net.pressure[i];
    const std::string owner = "pressure body " + std::to_string(i);
    if (Status status = checkBulkModulus(owner, body.bulkModulus); !status) return status;
    if (body.triangles.cols() == 0) return invalidValue(owner + ": it has no triangles");
    std::vector<std::pair<Index, Index>> sides;
    for (Eigen::Index t = 0; t < body.triangles.cols(); ++t)
      for (int k = 0; k < 3; ++k) {
        const Index a = body.triangles(k, t), b = body.triangles((k + 1) % 3, t);
        if (a < 0 || a >= net.nodeCount() || a == b)
          return invalidValue(owner + ": triangle " + std::to_string(t) + " uses node " + std::to_string(a) +
                              ", its corners must be three nodes of the net's " +
                              std::to_string(net.nodeCount()));
        sides.emplace_back(a, b);
      }
    std::sort(sides.begin(), sides.end());
    const auto isAlone = [&sides](const std::pair<Index, Index>& side) {
      return !std::binary_search(sides.begin(), sides.end(), std::pair(side.second, side.first));
    };
    if (std::adjacent_find(sides.begin(), sides.end()) != sides.end() ||
        std::any_of(sides.begin(), sides.end(), isAlone))
      return invalidValue(owner +
                          ": its surface must be closed, with normals to the same side across each edge");
    if (const double volume = enclosedVolume(net, body.triangles); !(std::isfinite(volume) && volume > 0.0))
      return badNumber(owner, "volume", volume, "m^3", "> 0; the normals must look outwards");
  }
  return {};
}

Status checkTriangles(const SpringNet& net)
{
  for (Index t = 0; t < net.triangleCount(); ++t)
    for (int k = 0; k < 3; ++k)
      if (const Index node = net.triangles(k, t); node < 0 || node >= net.nodeCount())
        return invalidValue("triangle " + std::to_string(t) + ": it uses node " + std::to_string(node) +
                            ", the net has " + std::to_string(net.nodeCount()) + " nodes");
  return {};
}

/// Whether a patch's list names only who is there, and rises.
template <class Entry>
Status checkPlaces(const char* what, const std::vector<Entry>& list, Index Entry::*index, Index count)
{
  Index last = -1;
  for (const Entry& entry : list) {
    const Index i = entry.*index;
    if (i < 0 || i >= count)
      return invalidValue("the patch names " + std::string(what) + " " + std::to_string(i) +
                          ", the net has " + std::to_string(count));
    if (i <= last)
      return invalidValue("the patch names " + std::string(what) + " " + std::to_string(i) + " after " +
                          std::to_string(last) + ", its list must rise");
    last = i;
  }
  return {};
}

Status checkPatchNodes(const ParameterPatch& patch, const SpringNet& net)
{
  if (Status status = checkPlaces("node", patch.nodes, &ParameterPatch::Node::node, net.nodeCount()); !status)
    return status;
  for (const ParameterPatch::Node& node : patch.nodes) {
    const auto owner = [&] { return named("node", net.nodeId, node.node); };
    if (Status status = checkInertia(owner, node.mass, node.massDamping); !status) return status;
  }
  return {};
}

Status checkPatchSprings(const ParameterPatch& patch, const SpringNet& net)
{
  if (Status status =
        checkPlaces("spring", patch.springs, &ParameterPatch::Spring::spring, net.springCount());
      !status)
    return status;
  for (const ParameterPatch::Spring& spring : patch.springs) {
    const Index s = spring.spring;
    const auto owner = [&] { return named("spring", net.springId, s); };
    if (Status status = checkBed(owner, spring.stiffness, spring.viscosity); !status) return status;
    if (spring.law == SpringLaw::Linear && std::isfinite(spring.lawParameter)) continue;
    if (Status status = checkLaw(net, s, spring.law, spring.lawParameter, owner()); !status) return status;
  }
  return {};
}

Status checkPatchAnchors(const ParameterPatch& patch, const SpringNet& net)
{
  if (patch.anchorSet) {
    if (Status status = checkAnchorShapes(*patch.anchorSet); !status) return status;
    if (Status status = checkAnchors(*patch.anchorSet, net.nodeCount()); !status) return status;
  }
  const Index count = patch.anchorSet ? patch.anchorSet->count() : net.anchors.count();
  if (Status status = checkPlaces("anchor", patch.anchors, &ParameterPatch::Anchor::anchor, count); !status)
    return status;
  for (const ParameterPatch::Anchor& anchor : patch.anchors) {
    const auto owner = [&] { return "anchor " + std::to_string(anchor.anchor); };
    if (Status status = checkBed(owner, anchor.stiffness, anchor.viscosity); !status) return status;
  }
  return {};
}

Status checkPatchPressure(const ParameterPatch& patch, const SpringNet& net)
{
  if (patch.bulkModuli.empty()) return {};
  if (patch.bulkModuli.size() != net.pressure.size())
    return invalidValue("the patch holds " + std::to_string(patch.bulkModuli.size()) +
                        " bulk moduli, the net has " + std::to_string(net.pressure.size()) +
                        " pressure bodies");
  for (std::size_t i = 0; i < patch.bulkModuli.size(); ++i)
    if (Status status = checkBulkModulus("pressure body " + std::to_string(i), patch.bulkModuli[i]); !status)
      return status;
  return {};
}

} // namespace

Status checkPatch(const ParameterPatch& patch, const SpringNet& net)
{
  for (const auto check : {checkPatchNodes, checkPatchSprings, checkPatchAnchors, checkPatchPressure})
    if (Status status = check(patch, net); !status) return status;
  return {};
}

Status checkNet(const SpringNet& net)
{
  for (const auto check : {checkArrays, checkNodes, checkTables, checkSprings, checkBeds, checkTriangles,
                           checkMaterial, checkPressure})
    if (Status status = check(net); !status) return status;
  return {};
}

} // namespace esm
