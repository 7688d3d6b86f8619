// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// esm_bench fem: nets as the import makes them against finite elements (bench/fem/README.md).
#include "bench/fem/fem_case.h"
#include "bench/sub_benches.h"
#include "core/dynamics/simulation.h"
#include "core/structure/material.h"
#include "core/structure/support.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <optional>

namespace esm::bench {

namespace {

constexpr double kFemModulus = 20e3; ///< of the reference [Pa]
constexpr double kTubeWall = 3e-3;   ///< of the tube [m]
constexpr double kNoAnswer = 100.0;

/// One way to make a net.
struct FemVariant {
  const char *body, *name;
  SupportOptions::Interior interior;
  MaterialOptions::Body fills;
  bool withBed;
  int layers = 0;
};

constexpr FemVariant kFemVariants[] = {
  {"tube", "struts", SupportOptions::Interior::Struts, MaterialOptions::Body::Wall, false},
  {"tube", "struts in the default bed", SupportOptions::Interior::Struts, MaterialOptions::Body::Wall, true},
  {"tube", "wall", SupportOptions::Interior::Wall, MaterialOptions::Body::Wall, false},
  {"tube", "wall in the default bed", SupportOptions::Interior::Wall, MaterialOptions::Body::Wall, true},
  {"tube", "wall of two layers", SupportOptions::Interior::Wall, MaterialOptions::Body::Wall, false, 2},
  {"block", "struts", SupportOptions::Interior::Struts, MaterialOptions::Body::Solid, false},
  {"block", "lattice", SupportOptions::Interior::Lattice, MaterialOptions::Body::Solid, false},
};

struct FemNet {
  SpringNet net;
  double scale = 1.0;
};

Result<FemNet> makeFemNet(const FemBody& body, const FemVariant& variant)
{
  FemNet made;
  Result<SpringNet> net = buildNet(body.mesh);
  if (!net) return net.error();
  made.net = std::move(*net);
  SupportOptions support;
  support.interior = variant.interior;
  support.wallThickness = kTubeWall;
  support.wallLayers = variant.layers;
  if (auto added = addSupport(made.net, support); !added) return added.error();
  MaterialOptions material;
  material.body = variant.fills;
  material.youngsModulus = kFemModulus;
  material.thickness = kTubeWall;
  const Result<TissueModel> tissue = tissueOf(material, defaultTissue());
  if (!tissue) return tissue.error();
  const auto report = setMaterial(made.net, material, tissue->thickness);
  if (!report) return report.error();
  made.scale = report->scale;
  if (auto applied = applyTissue(*tissue, made.net); !applied) return applied.error();
  if (!variant.withBed) made.net.anchors = {};
  for (Index node = 0; node < made.net.nodeCount(); ++node)
    made.net.fixed[static_cast<std::size_t>(node)] = body.isHeld(made.net.restPosition.col(node)) ? 1 : 0;
  return made;
}

/// Relative errors [%] at the shares of the load; none where there is no equilibrium.
std::vector<std::optional<double>> femErrorsOf(const SpringNet& net, const FemCase& load)
{
  std::vector<std::optional<double>> errors(load.shares.size());
  Loads loads;
  for (std::size_t i = 0; i < load.node.size(); ++i) {
    VectorCurve curve;
    curve.time = {0.0, 1.0};
    curve.value = Eigen::Matrix3Xd::Zero(3, 2);
    curve.value.col(1) = load.force.col(static_cast<Eigen::Index>(i));
    if (curve.value.col(1).norm() > 0.0) loads.forces.push_back({{load.node[i]}, curve});
  }
  SolverSettings settings;
  settings.solver = "relax";
  auto simulation = Simulation::create(net, loads, settings);
  if (!simulation) return errors;
  for (std::size_t k = 0; k < load.shares.size(); ++k) {
    while (simulation->state().time < load.shares[k] - 1e-9) {
      const double step = std::min(0.1, load.shares[k] - simulation->state().time);
      if (!simulation->advance(step).good()) return errors;
    }
    double wrong = 0.0, all = 0.0;
    for (std::size_t i = 0; i < load.node.size(); ++i) {
      const Eigen::Vector3d wanted = load.moved[k].col(static_cast<Eigen::Index>(i)),
                            is = simulation->state().position.col(load.node[i]) -
                                 net.restPosition.col(load.node[i]);
      wrong += (is - wanted).squaredNorm();
      all += wanted.squaredNorm();
    }
    errors[k] = 100.0 * std::sqrt(wrong / all);
  }
  return errors;
}

double medianError(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

struct FemRow {
  const FemCase* load;
  std::vector<double> error; ///< per share [%]
};

void printFemSummary(const FemVariant& variant, const FemNet& made, const std::vector<FemRow>& rows)
{
  const auto print = [&](const std::string& what, const std::function<bool(const FemCase&)>& counts) {
    std::printf("%s,%s,%d,%d,%.3f,%s", variant.body, variant.name, made.net.nodeCount(),
                made.net.springCount(), made.scale, what.c_str());
    for (const std::size_t k : {std::size_t{0}, rows.front().error.size() - 1}) {
      std::vector<double> errors;
      for (const FemRow& row : rows)
        if (counts(*row.load)) errors.push_back(row.error[k]);
      if (errors.empty()) return;
      std::printf(",%.1f,%.1f", medianError(errors), *std::max_element(errors.begin(), errors.end()));
    }
    std::printf("\n");
  };
  print("train", [](const FemCase& load) { return load.isTraining(); });
  print("unseen", [](const FemCase& load) { return !load.isTraining(); });
  std::map<std::string, int> kinds;
  for (const FemRow& row : rows) ++kinds[row.load->kind];
  for (const auto& [kind, count] : kinds)
    print(kind, [&kind = kind](const FemCase& load) { return load.kind == kind; });
  std::fflush(stdout);
}

int failFem(const Error& error)
{
  std::fprintf(stderr, "esm_bench fem: %s\n", error.detail.c_str());
  return 1;
}

} // namespace

int runFem(const std::vector<std::string>& words)
{
  bool isLong = false, isShort = false;
  std::string only, folder = ESM_BENCH_FEM_DATA;
  for (const std::string& word : words) {
    if (word == "--cases")
      isLong = true;
    else if (word == "--quick")
      isShort = true;
    else if (word.rfind("--data=", 0) == 0)
      folder = word.substr(7);
    else
      only = word;
  }
  if (isLong)
    std::printf("body,net,case,kind,errors in %% at each share of the load\n");
  else
    std::printf("body,net,nodes,springs,scale,cases,median at a tenth,worst,median at full load,worst\n");
  std::map<std::string, FemBody> bodies;
  for (const FemVariant& variant : kFemVariants) {
    if (!only.empty() && only != variant.name && only != variant.body) continue;
    if (!bodies.count(variant.body)) {
      Result<FemBody> body = readFemBody(folder, variant.body);
      if (!body) return failFem(body.error());
      bodies.emplace(variant.body, std::move(*body));
    }
    const FemBody& body = bodies.at(variant.body);
    Result<FemNet> made = makeFemNet(body, variant);
    if (!made) return failFem(made.error());
    std::vector<FemRow> rows;
    for (const FemCase& load : body.cases) {
      if (isShort && !rows.empty()) break;
      FemRow row{&load, {}};
      if (isLong)
        std::printf("%s,%s,%s,%s", variant.body, variant.name, load.name.c_str(), load.kind.c_str());
      for (const std::optional<double>& error : femErrorsOf(made->net, load)) {
        row.error.push_back(error.value_or(kNoAnswer));
        if (isLong) error ? std::printf(",%.1f", *error) : std::printf(",none");
      }
      if (isLong) std::printf("\n");
      std::fflush(stdout);
      rows.push_back(std::move(row));
    }
    if (rows.empty())
      return failFem({ErrorCode::EmptyResult, folder + " holds no cases of the " + variant.body});
    if (!isLong) printFemSummary(variant, *made, rows);
  }
  return 0;
}

} // namespace esm::bench
