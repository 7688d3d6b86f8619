// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The whole way: a mesh file becomes a net, rules give it tissue, a poke makes it move, ParaView shows it.
//   02_tissue_to_motion MESH MOTION.pvd
#include "core/dynamics/simulation.h"
#include "core/net/net_builder.h"
#include "core/project/export.h"
#include "core/tissue/tissue_model.h"
#include "meshimport/mesh_importer.h"

#include <iostream>

namespace {

esm::Status run(const std::string& meshFile, const std::string& motionFile)
{
  // Geometry: vertices become nodes, edges and lines become springs.
  auto imported = esm::importMesh(meshFile);
  if (!imported) return imported.error();
  esm::toScene(imported->mesh, esm::LengthUnit::Millimetre, esm::UpAxis::Z);
  auto net = esm::buildNet(imported->mesh);
  if (!net) return net.error();

  // Tissue: words for all of it, and a softer region around the first node.
  esm::TissueModel tissue = esm::defaultTissue();
  tissue.inputs[0] = esm::fuzzy::Word{"medium", {}};
  esm::Region region;
  region.ellipsoid.centre = net->restPosition.col(0);
  region.inputs = tissue.inputs;
  region.inputs[0] = esm::fuzzy::Word{"soft", {esm::fuzzy::Hedge::Very}};
  tissue.regions = {region};
  if (auto applied = esm::applyTissue(tissue, *net); !applied) return applied.error();

  // Motion: 0.02 N along x on the first node, rising within 0.1 s.
  Eigen::Matrix3Xd force = Eigen::Matrix3Xd::Zero(3, 2);
  force(0, 1) = 0.02;
  esm::Loads loads;
  loads.forces = {{{0}, {{0.0, 0.1}, force}}};
  auto simulation = esm::Simulation::create(*net, loads, {});
  if (!simulation) return simulation.error();
  auto writer = esm::TrajectoryWriter::create(motionFile);
  if (!writer) return writer.error();
  for (int frame = 0; frame <= 12; ++frame) {
    const auto& state = simulation->state();
    if (auto added = writer->addFrame({&*net, &state.position, &state.velocity, nullptr, state.time}); !added)
      return added.error();
    if (!simulation->advance(1.0 / 60.0).good())
      return esm::Error{esm::ErrorCode::Numerics, simulation->why()};
  }
  const double depth = (simulation->state().position.col(0) - net->restPosition.col(0)).norm();
  std::cout << "The node gave way by " << depth * 1000.0 << " mm (" << simulation->why() << ").\n";
  if (!(depth > 0.0)) return esm::Error{esm::ErrorCode::Numerics, "nothing moved"};
  return writer->finish();
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 3) {
    std::cerr << "Usage: 02_tissue_to_motion MESH MOTION.pvd\n";
    return 2;
  }
  if (const esm::Status status = run(argv[1], argv[2]); !status) {
    std::cerr << status.error().detail << '\n';
    return 1;
  }
}
