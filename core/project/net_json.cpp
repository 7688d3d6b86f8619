// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/net_json.h"

#include "core/net/net_builder.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace esm::json {

namespace {

constexpr const char* kEdgeFormulas[] = {"van_gelder", "regular"};

/// The places where a flag is set.
template <class Flags, class Predicate>
Json placesOf(const Flags& flags, Predicate isSet)
{
  Json::array_t list;
  for (std::size_t i = 0; i < flags.size(); ++i)
    if (isSet(flags[i])) list.emplace_back(i);
  return list;
}

/// Ids are written only where they say more than the places do.
template <class Id>
void addIds(Json& object, const std::vector<Id>& ids)
{
  bool places = true;
  for (std::size_t i = 0; i < ids.size(); ++i) places = places && static_cast<std::size_t>(ids[i]) == i;
  if (places) return;
  Json::array_t list;
  for (const Id id : ids) list.emplace_back(static_cast<Index>(id));
  object["id"] = std::move(list);
}

template <class Id>
void readIds(const View& object, std::vector<Id>& ids)
{
  if (!object.has("id")) return; // resizeNet() has set ids = places
  const View list = object["id"];
  if (list.size() != ids.size())
    return list.mustBe(("a list of " + std::to_string(ids.size()) + " numbers").c_str());
  const std::vector<Index> values = list.indexList(std::numeric_limits<Index>::max());
  std::transform(values.begin(), values.end(), ids.begin(), [](Index id) { return Id{id}; });
}

/// A flat list of node numbers, `corners` to each item.
template <class Matrix>
Matrix readCorners(const View& list, Index nodes)
{
  constexpr Eigen::Index corners = Matrix::RowsAtCompileTime;
  const std::vector<Index> flat = list.indexList(nodes);
  const auto size = static_cast<Eigen::Index>(flat.size());
  if (size % corners != 0) {
    list.mustBe(("a flat list with a multiple of " + std::to_string(corners) + " node numbers").c_str());
    return Matrix(corners, 0);
  }
  return Eigen::Map<const Matrix>(flat.data(), corners, size / corners);
}

Json curveOf(const VectorCurve& curve)
{
  Json::array_t values;
  for (Eigen::Index i = 0; i < curve.value.cols(); ++i)
    values.push_back(listOf(Eigen::Vector3d(curve.value.col(i))));
  return values;
}

VectorCurve readCurve(const View& object, const char* valueKey)
{
  VectorCurve curve;
  const View time = object["time"], value = object[valueKey];
  curve.time = time.numberList();
  if (curve.time.empty()) time.mustBe("a list of one or more times");
  for (std::size_t i = 1; i < curve.time.size(); ++i)
    if (curve.time[i] < curve.time[i - 1]) time[i].mustBe("not before the time ahead of it");
  if (value.size() != curve.time.size())
    value.mustBe(("a list of " + std::to_string(curve.time.size()) + ", one for each time").c_str());
  curve.value = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(curve.time.size()));
  for (std::size_t i = 0; i < curve.time.size() && value.sound(); ++i)
    curve.value.col(static_cast<Eigen::Index>(i)) = value[i].vector();
  return curve;
}

void readNodes(const View& nodes, SpringNet& net)
{
  nodes.expectKeys({"mass", "fixed"}, {"id", "velocity", "mass_damping", "volume", "support"});
  const Index count = net.nodeCount();
  net.mass = nodes["mass"].numbers(count, Range::Positive);
  for (const Index node : nodes["fixed"].indexList(count)) net.fixed[static_cast<std::size_t>(node)] = 1;
  if (nodes.has("mass_damping")) net.massDamping = nodes["mass_damping"].numbers(count, Range::NotNegative);
  if (nodes.has("velocity")) {
    net.initialVelocity = nodes["velocity"].points();
    if (net.initialVelocity.cols() != count)
      nodes["velocity"].mustBe(("a flat list of " + std::to_string(count) + " x, y, z triples").c_str());
  }
  if (nodes.has("volume")) net.volume = nodes["volume"].numbers(count, Range::NotNegative);
  if (nodes.has("support")) {
    net.supportNode.assign(static_cast<std::size_t>(count), 0);
    for (const Index node : nodes["support"].indexList(count))
      net.supportNode[static_cast<std::size_t>(node)] = 1;
  }
  readIds(nodes, net.nodeId);
}

constexpr std::pair<const char*, SpringKind> kSupportKinds[] = {{"struts", SpringKind::Strut},
                                                                {"wall_edges", SpringKind::WallEdge},
                                                                {"wall_diagonals", SpringKind::WallDiagonal},
                                                                {"wall_across", SpringKind::WallAcross},
                                                                {"wall_braces", SpringKind::WallBrace}};

void readSprings(const View& springs, SpringNet& net)
{
  springs.expectKeys(
    {"ends", "rest_length", "stiffness", "viscosity", "law", "law_parameter", "tension_only", "lines"},
    {"id", "struts", "wall_edges", "wall_diagonals", "wall_across", "wall_braces", "section"});
  const Index count = net.springCount();
  net.restLength = springs["rest_length"].numbers(count, Range::NotNegative);
  net.stiffness = springs["stiffness"].numbers(count, Range::NotNegative);
  net.viscosity = springs["viscosity"].numbers(count, Range::NotNegative);
  net.lawParameter = springs["law_parameter"].numbers(count);
  const auto laws = springs["law"].choices(count, kLawNames);
  std::transform(laws.begin(), laws.end(), net.law.begin(), [](std::size_t i) { return SpringLaw(i); });
  for (const Index spring : springs["tension_only"].indexList(count))
    net.tensionOnly[static_cast<std::size_t>(spring)] = 1;
  for (const Index spring : springs["lines"].indexList(count))
    net.kind[static_cast<std::size_t>(spring)] = SpringKind::Line;
  for (const auto& [key, kind] : kSupportKinds)
    if (springs.has(key))
      for (const Index spring : springs[key].indexList(count))
        net.kind[static_cast<std::size_t>(spring)] = kind;
  if (springs.has("section")) net.section = springs["section"].numbers(count, Range::NotNegative);
  readIds(springs, net.springId);
}

void readMaterial(const View& object, SpringNet& net)
{
  object.expectKeys({"edges", "modulus_scale"});
  net.material.edges = EdgeFormula(object["edges"].choice(kEdgeFormulas));
  net.material.modulusScale = object["modulus_scale"].number(Range::Positive);
}

void readPressure(const View& list, SpringNet& net)
{
  for (std::size_t i = 0; i < list.size() && list.sound(); ++i) {
    const View body = list[i];
    body.expectKeys({"bulk_modulus", "triangles"});
    net.pressure.push_back({readCorners<TriangleMatrix>(body["triangles"], net.nodeCount()),
                            body["bulk_modulus"].number(Range::Positive)});
  }
}

void readTables(const View& list, SpringNet& net)
{
  for (std::size_t i = 0; i < list.size() && list.sound(); ++i) {
    const View table = list[i];
    table.expectKeys({"strain", "force"});
    net.tables.push_back({table["strain"].numberList(), table["force"].numberList()});
  }
}

} // namespace

Json listOf(const double* values, Eigen::Index count)
{
  return Json::array_t(values, values + count);
}

Json listOf(const std::vector<Index>& values)
{
  return Json::array_t(values.begin(), values.end());
}

Json uniformOrList(const Eigen::ArrayXd& values)
{
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  const bool uniform = values.size() > 0 && std::all_of(values.data(), values.data() + values.size(),
                                                        [&](double v) { return bits(v) == bits(values[0]); });
  if (uniform) return values[0];
  return listOf(values.data(), values.size());
}

Json lawsOf(const SpringNet& net)
{
  const auto name = [](SpringLaw law) { return kLawNames[static_cast<std::size_t>(law)]; };
  const auto& laws = net.law;
  if (!laws.empty() && std::all_of(laws.begin(), laws.end(), [&](SpringLaw l) { return l == laws[0]; }))
    return name(laws[0]);
  Json::array_t list;
  for (const SpringLaw law : laws) list.emplace_back(name(law));
  return list;
}

Json forcesOf(const Loads& loads)
{
  Json::array_t list;
  for (const NodalForce& load : loads.forces)
    list.push_back(
      {{"nodes", listOf(load.nodes)}, {"time", load.force.time}, {"force", curveOf(load.force)}});
  return list;
}

Json motionsOf(const Loads& loads)
{
  Json::array_t list;
  for (const PrescribedMotion& motion : loads.motions) {
    Json object = {{"nodes", listOf(motion.nodes)},
                   {"time", motion.displacement.time},
                   {"displacement", curveOf(motion.displacement)}};
    if (motion.release) object["release"] = *motion.release;
    list.push_back(std::move(object));
  }
  return list;
}

std::vector<NodalForce> readForces(const View& list, Index nodes)
{
  std::vector<NodalForce> forces;
  for (std::size_t i = 0; i < list.size() && list.sound(); ++i) {
    list[i].expectKeys({"nodes", "time", "force"});
    forces.push_back({list[i]["nodes"].indexList(nodes), readCurve(list[i], "force")});
  }
  return forces;
}

std::vector<PrescribedMotion> readMotions(const View& list, Index nodes)
{
  std::vector<PrescribedMotion> motions;
  for (std::size_t i = 0; i < list.size() && list.sound(); ++i) {
    list[i].expectKeys({"nodes", "time", "displacement"}, {"release"});
    PrescribedMotion motion{list[i]["nodes"].indexList(nodes), readCurve(list[i], "displacement"), {}};
    if (list[i].has("release")) motion.release = list[i]["release"].number();
    motions.push_back(std::move(motion));
  }
  return motions;
}

Json anchorsOf(const AnchorSet& set)
{
  Json anchors = {{"node", listOf(set.node)},
                  {"point", listOf(set.point)},
                  {"stiffness", uniformOrList(set.stiffness)},
                  {"viscosity", uniformOrList(set.viscosity)}};
  if (set.bandLength.size() > 0) anchors["band_length"] = uniformOrList(set.bandLength);
  return anchors;
}

void readAnchors(const View& object, SpringNet& net)
{
  object.expectKeys({"node", "point", "stiffness", "viscosity"}, {"band_length"});
  net.anchors.node = object["node"].indexList(net.nodeCount());
  net.anchors.point = object["point"].points();
  if (net.anchors.point.cols() != net.anchors.count())
    object["point"].mustBe(
      ("a flat list of " + std::to_string(net.anchors.count()) + " x, y, z triples, one for each node")
        .c_str());
  net.anchors.stiffness = object["stiffness"].numbers(net.anchors.count(), Range::NotNegative);
  net.anchors.viscosity = object["viscosity"].numbers(net.anchors.count(), Range::NotNegative);
  if (object.has("band_length"))
    net.anchors.bandLength = object["band_length"].numbers(net.anchors.count(), Range::NotNegative);
}

Json geometryOf(const SpringNet& net)
{
  return {{"position", listOf(net.restPosition)}, {"triangles", listOf(net.triangles)}};
}

Json netOf(const SpringNet& net)
{
  const auto isOne = [](std::uint8_t flag) { return flag != 0; };
  Json nodes = {{"mass", uniformOrList(net.mass)}, {"fixed", placesOf(net.fixed, isOne)}};
  if (net.initialVelocity.cols() > 0) nodes["velocity"] = listOf(net.initialVelocity);
  if (net.massDamping.size() > 0) nodes["mass_damping"] = uniformOrList(net.massDamping);
  // Only where they are: files are read by older programs, which know no such keys.
  if (net.volume.size() > 0) nodes["volume"] = uniformOrList(net.volume);
  if (!net.supportNode.empty()) nodes["support"] = placesOf(net.supportNode, isOne);
  addIds(nodes, net.nodeId);

  Json springs = {{"ends", listOf(net.ends)},
                  {"rest_length", uniformOrList(net.restLength)},
                  {"stiffness", uniformOrList(net.stiffness)},
                  {"viscosity", uniformOrList(net.viscosity)},
                  {"law", lawsOf(net)},
                  {"law_parameter", uniformOrList(net.lawParameter)},
                  {"tension_only", placesOf(net.tensionOnly, isOne)},
                  {"lines", placesOf(net.kind, [](SpringKind k) { return k == SpringKind::Line; })}};
  for (const auto& [key, kind] : kSupportKinds) {
    const auto isOfKind = [wanted = kind](SpringKind k) { return k == wanted; };
    if (std::any_of(net.kind.begin(), net.kind.end(), isOfKind)) springs[key] = placesOf(net.kind, isOfKind);
  }
  if (net.section.size() > 0) springs["section"] = uniformOrList(net.section);
  addIds(springs, net.springId);

  Json tables = Json::array();
  for (const ForceTable& table : net.tables)
    tables.push_back({{"strain", table.strain}, {"force", table.force}});
  Json object = {{"nodes", std::move(nodes)},
                 {"springs", std::move(springs)},
                 {"anchors", anchorsOf(net.anchors)},
                 {"tables", std::move(tables)}};
  if (net.material != NetMaterial{})
    object["material"] = {{"edges", kEdgeFormulas[static_cast<std::size_t>(net.material.edges)]},
                          {"modulus_scale", net.material.modulusScale}};
  for (const PressureBody& body : net.pressure)
    object["pressure"].push_back({{"bulk_modulus", body.bulkModulus}, {"triangles", listOf(body.triangles)}});
  return object;
}

SpringNet readNet(const View& geometry, const View& block)
{
  geometry.expectKeys({"position", "triangles"});
  block.expectKeys({"nodes", "springs", "anchors", "tables"}, {"material", "pressure"});
  SpringNet net;
  const Eigen::Matrix3Xd position = geometry["position"].points();
  const auto nodes = static_cast<Index>(position.cols());
  const auto ends = readCorners<SegmentMatrix>(block["springs"]["ends"], nodes);
  resizeNet(net, nodes, static_cast<Index>(ends.cols()));
  net.restPosition = position;
  net.ends = ends;
  net.triangles = readCorners<TriangleMatrix>(geometry["triangles"], nodes);
  readNodes(block["nodes"], net);
  readSprings(block["springs"], net);
  readTables(block["tables"], net);
  readAnchors(block["anchors"], net);
  if (block.has("material")) readMaterial(block["material"], net);
  if (block.has("pressure")) readPressure(block["pressure"], net);
  return net;
}

Json loadsOf(const Loads& loads)
{
  return {{"gravity", listOf(loads.gravity)}, {"forces", forcesOf(loads)}, {"motions", motionsOf(loads)}};
}

Loads readLoads(const View& object, Index nodes)
{
  object.expectKeys({"gravity", "forces", "motions"});
  return {object["gravity"].vector(), readForces(object["forces"], nodes),
          readMotions(object["motions"], nodes)};
}

} // namespace esm::json
