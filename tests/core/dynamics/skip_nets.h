// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/nets.h"
#include "tests/support/physics.h"

#include <span>
#include <vector>

namespace esm::test {

/// A sheet of nodes 1 mm apart, each bedded softly and so viscously that nothing swings: a poke dies out
/// within some ten springs. At rest.
inline SpringNet beddedSheet(Index n)
{
  SpringNet net = sheet(n, 1e-3, 100.0);
  net.mass.setConstant(1e-5);
  const Eigen::Matrix3Xd points = net.restPosition;
  for (Index i = 0; i < net.nodeCount(); ++i) addAnchor(net, i, points.col(i), 5.0, 0.05);
  return net;
}

inline SolverSettings settingsOf(double tolerance, bool skip, const std::string& solver = "auto")
{
  SolverSettings settings;
  settings.tolerance = tolerance;
  settings.skipResting = skip;
  settings.solver = solver;
  return settings;
}

struct Frames {
  std::vector<Eigen::Matrix3Xd> position;
  std::vector<StepReport> report;
};

/// The tools come with frame 1.
inline Frames play(Simulation& simulation, int frames, std::span<const ToolSpring> tools = {})
{
  Frames result;
  result.position.push_back(simulation.state().position);
  if (!tools.empty()) simulation.setTools(tools);
  for (int i = 0; i < frames; ++i) {
    result.report.push_back(simulation.advance(1.0 / 60.0));
    EXPECT_TRUE(result.report.back().good()) << simulation.why();
    result.position.push_back(simulation.state().position);
  }
  return result;
}

/// The error metric of docs/FILE_FORMAT.md.
inline double errorOf(const Frames& frames, const Frames& reference)
{
  double error = 0.0, displacement = 0.0;
  for (std::size_t i = 0; i < frames.position.size(); ++i) {
    error += (frames.position[i] - reference.position[i]).squaredNorm();
    displacement += (reference.position[i] - reference.position[0]).squaredNorm();
  }
  return std::sqrt(error / displacement);
}

inline ToolSpring pull(const SpringNet& net, Index node, const Eigen::Vector3d& by, double stiffness)
{
  return {node, Eigen::Vector3d(net.restPosition.col(node)) + by, {0, 0, 0}, stiffness, 0.0};
}

inline VectorCurve curve(std::vector<double> time, const Eigen::Matrix3Xd& value)
{
  return {std::move(time), value};
}

} // namespace esm::test
