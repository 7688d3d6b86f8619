// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/net_format.h"

#include "core/net/net_builder.h"
#include "core/project/net_json.h"

#include <algorithm>

namespace esm {

namespace json {

namespace {

/// What the format offers: no tables.
constexpr auto kPlainLaws = std::span(kLawNames).first(3);

void readPlainNodes(const View& nodes, SpringNet& net)
{
  nodes.expectKeys({"position", "mass"}, {"fixed", "velocity", "mass_damping"});
  const Index count = net.nodeCount();
  net.mass = nodes["mass"].numbers(count, Range::Positive);
  if (nodes.has("fixed"))
    for (const Index node : nodes["fixed"].indexList(count)) net.fixed[static_cast<std::size_t>(node)] = 1;
  if (nodes.has("mass_damping")) net.massDamping = nodes["mass_damping"].numbers(count, Range::NotNegative);
  if (nodes.has("velocity")) {
    net.initialVelocity = nodes["velocity"].points();
    if (net.initialVelocity.cols() != count)
      nodes["velocity"].mustBe(("a flat list of " + std::to_string(count) + " x, y, z triples").c_str());
  }
}

void readPlainSprings(const View& springs, SpringNet& net)
{
  springs.expectKeys({"i", "j", "stiffness", "rest_length"}, {"viscosity", "law", "law_parameter"});
  const Index count = net.springCount();
  net.stiffness = springs["stiffness"].numbers(count, Range::NotNegative);
  net.restLength = springs["rest_length"].numbers(count, Range::NotNegative);
  if (springs.has("viscosity")) net.viscosity = springs["viscosity"].numbers(count, Range::NotNegative);
  bool linear = true;
  if (springs.has("law")) {
    const auto laws = springs["law"].choices(count, kPlainLaws);
    std::transform(laws.begin(), laws.end(), net.law.begin(), [](std::size_t i) { return SpringLaw(i); });
    linear = std::all_of(laws.begin(), laws.end(), [](std::size_t law) { return law == 0; });
  }
  if (springs.has("law_parameter"))
    net.lawParameter = springs["law_parameter"].numbers(count);
  else if (!linear)
    springs.complain("lacks \"law_parameter\", which its laws need");
  for (Index s = 0; s < count && springs.sound(); ++s)
    if (net.law[static_cast<std::size_t>(s)] != SpringLaw::Linear && net.restLength[s] == 0.0)
      springs["rest_length"].complain("is 0 at spring " + std::to_string(s) + ", its law needs a length > 0");
}

void readPlainTopology(const View& root, SpringNet& net)
{
  const Eigen::Matrix3Xd position = root["nodes"]["position"].points();
  const auto nodes = static_cast<Index>(position.cols());
  const View from = root["springs"]["i"], to = root["springs"]["j"];
  const std::vector<Index> i = from.indexList(nodes), j = to.indexList(nodes);
  if (i.size() != j.size()) to.mustBe(("a list of " + std::to_string(i.size()) + " nodes, as i is").c_str());
  if (!root.sound()) return;

  resizeNet(net, nodes, static_cast<Index>(i.size()));
  net.restPosition = position;
  for (std::size_t s = 0; s < i.size(); ++s) {
    if (i[s] == j[s]) to[s].mustBe("another node than the spring's i");
    net.ends.col(static_cast<Eigen::Index>(s)) << i[s], j[s];
  }
}

void readPlainTriangles(const View& list, SpringNet& net)
{
  net.triangles.resize(3, static_cast<Eigen::Index>(list.size()));
  for (std::size_t t = 0; t < list.size() && list.sound(); ++t) {
    const std::vector<Index> corners = list[t].indexList(net.nodeCount());
    if (corners.size() == 3)
      net.triangles.col(static_cast<Eigen::Index>(t)) << corners[0], corners[1], corners[2];
    else
      list[t].mustBe("a list of three nodes");
  }
}

} // namespace

Result<Project> readPlainNet(const Json& tree, const std::string& origin)
{
  Faults faults{origin, {}};
  const View root(tree, faults);
  constexpr const char* kFormats[] = {kPlainNetFormat};
  root["format"].choice(kFormats);

  Project project;
  project.parametersFromTissue = false;
  project.tissue = defaultTissue();
  readPlainTopology(root, project.net);
  if (faults.first) return *faults.first;
  SpringNet& net = project.net;
  readPlainNodes(root["nodes"], net);
  readPlainSprings(root["springs"], net);
  if (root.has("anchors")) readAnchors(root["anchors"], net);
  if (root.has("triangles")) readPlainTriangles(root["triangles"], net);
  if (root.has("gravity")) project.loads.gravity = root["gravity"].vector();
  if (root.has("forces")) project.loads.forces = readForces(root["forces"], net.nodeCount());
  if (root.has("motions")) project.loads.motions = readMotions(root["motions"], net.nodeCount());
  if (root.has("name")) project.name = root["name"].text();
  if (root.has("duration")) project.simulation.duration = root["duration"].number(Range::NotNegative);
  if (root.has("frame_rate")) project.simulation.frameRate = root["frame_rate"].number(Range::Positive);
  if (faults.first) return *faults.first;
  if (const Status status = checkNet(net); !status)
    return Error{status.error().code, origin + ": " + status.error().detail};
  return project;
}

} // namespace json

namespace {

using json::Json;

template <class Values, class Predicate>
bool anyOf(const Values& values, Predicate predicate)
{
  return std::any_of(values.begin(), values.end(), predicate);
}

/// One sentence for each thing of the project that the plain format has no place for.
std::vector<std::string> lostInPlainNet(const Project& project)
{
  const SpringNet& net = project.net;
  std::vector<std::string> lost;
  if (project.parametersFromTissue)
    lost.push_back("the rules, inputs and regions; the springs keep the numbers made from them");
  if (anyOf(net.tensionOnly, [](std::uint8_t flag) { return flag != 0; }))
    lost.push_back("the tension-only flags; these springs also push");
  if (anyOf(net.law, [](SpringLaw law) { return law == SpringLaw::Table; }))
    lost.push_back("the force tables; these springs become linear");
  if (!net.pressure.empty()) lost.push_back("the pressure in closed surfaces; nothing keeps their volume");
  bool places = true;
  for (std::size_t i = 0; i < net.nodeId.size(); ++i) places &= static_cast<std::size_t>(net.nodeId[i]) == i;
  for (std::size_t i = 0; i < net.springId.size(); ++i)
    places &= static_cast<std::size_t>(net.springId[i]) == i;
  if (!places) lost.push_back("the ids of nodes and springs; their order stays");
  return lost;
}

Json plainNodes(const SpringNet& net)
{
  std::vector<Index> fixed;
  for (Index i = 0; i < net.nodeCount(); ++i)
    if (net.fixed[static_cast<std::size_t>(i)]) fixed.push_back(i);
  Json nodes = {{"position", json::listOf(net.restPosition)},
                {"mass", json::uniformOrList(net.mass)},
                {"fixed", json::listOf(fixed)}};
  if (net.initialVelocity.cols() > 0) nodes["velocity"] = json::listOf(net.initialVelocity);
  if (net.massDamping.size() > 0) nodes["mass_damping"] = json::uniformOrList(net.massDamping);
  return nodes;
}

Json plainSprings(SpringNet net)
{
  for (std::size_t s = 0; s < net.law.size(); ++s)
    if (net.law[s] == SpringLaw::Table) {
      net.law[s] = SpringLaw::Linear;
      net.lawParameter[static_cast<Eigen::Index>(s)] = 0.0;
    }
  return {{"i", json::listOf(SegmentMatrix(net.ends).row(0).eval())},
          {"j", json::listOf(SegmentMatrix(net.ends).row(1).eval())},
          {"stiffness", json::uniformOrList(net.stiffness)},
          {"viscosity", json::uniformOrList(net.viscosity)},
          {"rest_length", json::uniformOrList(net.restLength)},
          {"law", json::lawsOf(net)},
          {"law_parameter", json::uniformOrList(net.lawParameter)}};
}

} // namespace

Result<Project> parseNetFormat(std::string_view bytes, const std::string& origin)
{
  try {
    const Result<Json> tree = json::parseJson(bytes, origin);
    if (!tree) return tree.error();
    return json::readPlainNet(*tree, origin);
  } catch (...) {
    return json::thrownWhileReading(origin);
  }
}

std::string toNetFormat(const Project& project, std::vector<std::string>* lost)
{
  if (lost) *lost = lostInPlainNet(project);
  const SpringNet& net = project.net;
  Json tree = {{"format", json::kPlainNetFormat},
               {"name", json::validUtf8(project.name)},
               {"duration", project.simulation.duration},
               {"frame_rate", project.simulation.frameRate},
               {"gravity", json::listOf(project.loads.gravity)},
               {"nodes", plainNodes(net)},
               {"springs", plainSprings(net)},
               {"anchors",
                {{"node", json::listOf(net.anchors.node)},
                 {"point", json::listOf(net.anchors.point)},
                 {"stiffness", json::uniformOrList(net.anchors.stiffness)},
                 {"viscosity", json::uniformOrList(net.anchors.viscosity)}}},
               {"forces", json::forcesOf(project.loads)},
               {"motions", json::motionsOf(project.loads)}};
  if (net.triangleCount() > 0) {
    Json::array_t triangles;
    for (Index t = 0; t < net.triangleCount(); ++t)
      triangles.push_back(json::listOf(Eigen::Vector3i(net.triangles.col(t))));
    tree["triangles"] = std::move(triangles);
  }
  return json::write(tree);
}

} // namespace esm
