// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/project_io.h"

#include "core/base/file_io.h"
#include "core/base/text_encoding.h"
#include "core/net/net_builder.h"
#include "core/project/net_json.h"
#include "core/project/project_tree.h"
#include "core/project/recipe_json.h"
#include "core/project/tissue_json.h"
#include "core/project/xsp_format.h"

#include <algorithm>

namespace esm {

using json::Json;
using json::Range;
using json::View;

namespace {

constexpr const char* kFormat = "esm-project";
constexpr const char* kColourings[] = {"none", "stiffness", "strain", "force", "region_weight"};

Json tissueOf(const Project& project)
{
  Json object = {{"parameters_from_tissue", project.parametersFromTissue},
                 {"thickness", project.tissue.thickness},
                 {"density", project.tissue.density},
                 {"law", json::kLawNames[static_cast<std::size_t>(project.tissue.law)]},
                 {"law_parameter", project.tissue.lawParameter}};
  if (!project.tissue.learned.isEmpty()) object["learned"] = json::learnedOf(project.tissue.learned);
  return object;
}

Json simulationOf(const SimulationSettings& settings)
{
  const SolverSettings& solver = settings.solver;
  Json object = {{"duration", settings.duration},
                 {"frame_rate", settings.frameRate},
                 {"solver", json::validUtf8(solver.solver)},
                 {"tolerance", solver.tolerance},
                 {"fixed_step", solver.fixedStep},
                 {"threads", solver.threads}};
  // Only where it differs: files are read by older programs, which know no such key.
  if (!solver.skipResting) object["skip_resting"] = false;
  return object;
}

Json viewOf(const ViewSettings& view)
{
  Json object = {
    {"target", json::listOf(view.target)}, {"distance", view.distance},   {"azimuth", view.azimuth},
    {"elevation", view.elevation},         {"colouring", view.colouring}, {"show_surface", view.showSurface},
    {"show_springs", view.showSprings}};
  if (view.showStruts) object["show_struts"] = true; // as above
  return object;
}

TissueModel readTissue(const View& root, bool& parametersFromTissue)
{
  TissueModel tissue;
  tissue.rules = json::readRuleBase(root["rule_base"]);
  if (root.sound())
    if (const Status status = fuzzy::checkRuleBase(tissue.rules); !status)
      root["rule_base"].complain("does not hold together: " + status.error().detail);
  tissue.inputs = json::readInputs(root["inputs"], tissue.rules);
  tissue.regions = json::readRegions(root["regions"], tissue.rules);

  const View object = root["tissue"];
  object.expectKeys({"parameters_from_tissue", "thickness", "density", "law", "law_parameter"}, {"learned"});
  parametersFromTissue = object["parameters_from_tissue"].boolean();
  tissue.thickness = object["thickness"].number(Range::Positive);
  tissue.density = object["density"].number(Range::Positive);
  constexpr std::size_t kOffered = std::size(json::kLawNames) - 1; // a table belongs to a spring
  tissue.law = SpringLaw(object["law"].choice(std::span(json::kLawNames).first(kOffered)));
  tissue.lawParameter = object["law_parameter"].number();
  if (object.has("learned")) tissue.learned = json::readLearned(object["learned"]);
  return tissue;
}

SimulationSettings readSimulation(const View& object)
{
  object.expectKeys({"duration", "frame_rate", "solver", "tolerance", "fixed_step", "threads"},
                    {"skip_resting"});
  SimulationSettings settings;
  settings.duration = object["duration"].number(Range::NotNegative);
  settings.frameRate = object["frame_rate"].number(Range::Positive);
  settings.solver.solver = object["solver"].text();
  settings.solver.tolerance = object["tolerance"].number(Range::Positive);
  settings.solver.fixedStep = object["fixed_step"].number(Range::NotNegative);
  settings.solver.threads = object["threads"].integer(1, 1024);
  if (object.has("skip_resting")) settings.solver.skipResting = object["skip_resting"].boolean();
  return settings;
}

ViewSettings readView(const View& object)
{
  object.expectKeys(
    {"target", "distance", "azimuth", "elevation", "colouring", "show_surface", "show_springs"},
    {"show_struts"});
  return {object["target"].vector(),
          object["distance"].number(Range::NotNegative),
          object["azimuth"].number(),
          object["elevation"].number(),
          kColourings[object["colouring"].choice(kColourings)],
          object["show_surface"].boolean(),
          object["show_springs"].boolean(),
          object.has("show_struts") && object["show_struts"].boolean()};
}

void checkUnits(const View& object)
{
  object.expectKeys({"length", "mass", "time", "force", "pressure"});
  const auto only = [&](const char* key, const char* unit) { object[key].choice(std::span(&unit, 1)); };
  only("length", "m"), only("mass", "kg"), only("time", "s"), only("force", "N"), only("pressure", "Pa");
}

/// Whether this program can know the document; what a later one wrote is not judged by today's rules.
void checkVersion(const View& root)
{
  constexpr const char* kFormats[] = {kFormat};
  root["format"].choice(kFormats);
  const Index version = root["schema_version"].integer(1, 1000000);
  if (version > kSchemaVersion)
    root.complain("was written by a newer version of this program (schema version " +
                    std::to_string(version) + ", this program knows " + std::to_string(kSchemaVersion) +
                    "); open it with that version",
                  ErrorCode::NewerVersion);
}

} // namespace

Json json::treeWithoutNet(const Project& project)
{
  return {{"format", kFormat},
          {"schema_version", kSchemaVersion},
          {"name", json::validUtf8(project.name)},
          {"units", {{"length", "m"}, {"mass", "kg"}, {"time", "s"}, {"force", "N"}, {"pressure", "Pa"}}},
          {"source", json::sourceOf(project.source)},
          {"rule_base", json::ruleBaseOf(project.tissue.rules)},
          {"inputs", json::inputsOf(project.tissue.inputs, project.tissue.rules)},
          {"regions", json::regionsOf(project.tissue)},
          {"tissue", tissueOf(project)},
          {"loads", json::loadsOf(project.loads)},
          {"simulation", simulationOf(project.simulation)},
          {"view", viewOf(project.view)}};
}

void json::addNet(Json& tree, const SpringNet& net)
{
  tree["geometry"] = json::geometryOf(net);
  tree["net"] = json::netOf(net);
}

Json json::treeOf(const Project& project)
{
  Json tree = treeWithoutNet(project);
  addNet(tree, project.net);
  return tree;
}

namespace {

/// All but the net, and the loads on it.
void readParts(const View& root, Project& project)
{
  project.name = root["name"].text();
  checkUnits(root["units"]);
  project.source = json::readSource(root["source"]);
  project.tissue = readTissue(root, project.parametersFromTissue);
  project.simulation = readSimulation(root["simulation"]);
  project.view = readView(root["view"]);
}

} // namespace

Result<Project> json::readProject(const Json& tree, const std::string& origin)
{
  json::Faults faults{origin, {}};
  const View root(tree, faults);
  checkVersion(root);
  if (faults.first) return *faults.first;

  root.expectKeys({"format", "schema_version", "name", "units", "source", "rule_base", "inputs", "regions",
                   "tissue", "loads", "simulation", "view", "geometry", "net"});
  Project project;
  readParts(root, project);
  project.net = json::readNet(root["geometry"], root["net"]);
  project.loads = json::readLoads(root["loads"], project.net.nodeCount());
  if (faults.first) return *faults.first;
  if (const Status status = checkProject(project); !status)
    return Error{status.error().code, origin + ": " + status.error().detail};
  return project;
}

namespace {

bool isCborMap(std::string_view bytes)
{
  return !bytes.empty() && (static_cast<unsigned char>(bytes[0]) & 0xe0) == 0xa0;
}

Result<Project> parseTree(std::string_view bytes, const std::string& origin)
{
  bytes = withoutByteOrderMark(bytes);
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos)
    return Error{ErrorCode::BadFormat, origin + ": is empty, it holds no project"};
  if (looksLikeXsp(bytes)) return parseXsp(bytes, origin);
  const bool cbor = isCborMap(bytes);
  if (!cbor && bytes[start] != '{')
    return Error{ErrorCode::BadFormat,
                 origin + ": is neither a project (.esm, .esmb) nor a net in the esm-net-1 or Xsp format"};
  const Result<Json> tree = cbor ? json::parseCbor(bytes, origin) : json::parseJson(bytes, origin);
  if (!tree) return tree.error();
  if (const auto format = tree->find("format"); format != tree->end() && *format == json::kPlainNetFormat)
    return json::readPlainNet(*tree, origin);
  return json::readProject(*tree, origin);
}

bool isSolver(const std::string& name)
{
  const std::vector<SolverInfo> solvers = solverNames();
  return name == "auto" ||
         std::any_of(solvers.begin(), solvers.end(), [&](const SolverInfo& s) { return s.name == name; });
}

Status checkCurve(const std::string& owner, const std::vector<Index>& places, const VectorCurve& curve,
                  Index nodes)
{
  const auto refuse = [&](const char* why) { return Error{ErrorCode::InvalidValue, owner + " " + why}; };
  if (std::any_of(places.begin(), places.end(), [&](Index node) { return node < 0 || node >= nodes; }))
    return refuse("acts on a node that the net does not have");
  if (curve.time.empty() || static_cast<Eigen::Index>(curve.time.size()) != curve.value.cols())
    return refuse("has not one value for each of its times, at least one");
  if (!std::is_sorted(curve.time.begin(), curve.time.end())) return refuse("has times that go back");
  return {};
}

Status checkLoads(const Loads& loads, Index nodes)
{
  for (std::size_t i = 0; i < loads.forces.size(); ++i)
    if (const Status status =
          checkCurve("force " + std::to_string(i), loads.forces[i].nodes, loads.forces[i].force, nodes);
        !status)
      return status;
  for (std::size_t i = 0; i < loads.motions.size(); ++i)
    if (const Status status = checkCurve("motion " + std::to_string(i), loads.motions[i].nodes,
                                         loads.motions[i].displacement, nodes);
        !status)
      return status;
  return {};
}

/// All but the net, which has so many nodes.
Status checkParts(const Project& project, Index nodes)
{
  if (const Status status = checkRecipe(project.source); !status) return status;
  if (const Status status = checkLoads(project.loads, nodes); !status) return status;
  if (const std::string& solver = project.simulation.solver.solver; !isSolver(solver))
    return Error{ErrorCode::InvalidValue,
                 "the solver \"" + solver + "\" is unknown; use auto or a name of `esm solvers`"};
  const TissueModel& tissue = project.tissue;
  if (const Status status = fuzzy::checkRuleBase(tissue.rules); !status) return status;
  if (const Status status = checkLearned(tissue.learned); !status) return status;
  const auto fits = [&](const auto& inputs) { return inputs.size() == tissue.rules.inputs.size(); };
  if (!fits(tissue.inputs) || !std::all_of(tissue.regions.begin(), tissue.regions.end(),
                                           [&](const Region& r) { return fits(r.inputs); }))
    return Error{ErrorCode::InvalidValue,
                 "the tissue or a region has not one input for each of the rule base"};
  if (project.parametersFromTissue)
    if (const auto field = TissueField::create(tissue); !field) return field.error();
  return {};
}

} // namespace

Status checkProject(const Project& project)
{
  if (const Status status = checkNet(project.net); !status) return status;
  return checkParts(project, project.net.nodeCount());
}

Result<Project> json::readWithoutNet(const Json& tree, Index nodes, const std::string& origin)
{
  json::Faults faults{origin, {}};
  const View root(tree, faults);
  Project project;
  readParts(root, project);
  project.loads = json::readLoads(root["loads"], nodes);
  if (faults.first) return *faults.first;
  if (const Status status = checkParts(project, nodes); !status)
    return Error{status.error().code, origin + ": " + status.error().detail};
  return project;
}

std::string toJson(const Project& project)
{
  const Json tree = json::treeOf(project);
  ESM_ASSERT(!json::findNonFinite(tree));
  return json::write(tree);
}

std::string toCbor(const Project& project)
{
  const Json tree = json::treeOf(project);
  ESM_ASSERT(!json::findNonFinite(tree));
  return json::writeCbor(tree);
}

Result<Project> parseProject(std::string_view bytes, const std::string& origin)
{
  try {
    return parseTree(bytes, origin);
  } catch (...) {
    return json::thrownWhileReading(origin);
  }
}

Result<Project> loadProject(const std::filesystem::path& path)
{
  try {
    const Result<std::string> bytes = readFile(path);
    if (!bytes) return bytes.error();
    return parseTree(*bytes, path.string());
  } catch (...) {
    return json::thrownWhileReading(path.string());
  }
}

Status saveProject(const Project& project, const std::filesystem::path& path)
{
  const auto refuse = [&](ErrorCode code, const std::string& why) {
    return Error{code, path.string() + ": not written, " + why};
  };
  if (const Status status = checkProject(project); !status)
    return refuse(status.error().code, status.error().detail);
  try {
    const Json tree = json::treeOf(project);
    if (const auto place = json::findNonFinite(tree))
      return refuse(ErrorCode::Numerics, *place + " is not a finite number");
    return writeFileAtomically(path, path.extension() == ".esmb" ? json::writeCbor(tree) : json::write(tree),
                               true);
  } catch (const std::bad_alloc&) {
    return refuse(ErrorCode::OutOfMemory, "there is not enough memory");
  } catch (const std::exception& fault) {
    return refuse(ErrorCode::Internal, fault.what());
  }
}

} // namespace esm
