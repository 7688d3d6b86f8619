// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/work_precision.h"

#include "bench/reference/plain_net.h"
#include "core/base/hash.h"
#include "core/dynamics/simulation.h"

#include <cmath>
#include <ctime>

namespace esm::bench {
namespace {

constexpr double kFrameRate = 60.0;

double processorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

std::uint64_t hashOf(const Eigen::Matrix3Xd& x, std::uint64_t seed)
{
  return hashBytes(x.data(), sizeof(double) * static_cast<std::size_t>(x.size()), seed);
}

long frameCount(double duration)
{
  return std::lround(duration * kFrameRate);
}

} // namespace

double trajectoryError(const Trajectory& reference, const Trajectory& other)
{
  double error = 0.0, displacement = 0.0;
  for (std::size_t frame = 0; frame < reference.size(); ++frame) {
    error += (other[frame] - reference[frame]).squaredNorm();
    displacement += (reference[frame] - reference[0]).squaredNorm();
  }
  return std::sqrt(error / displacement);
}

Row runEngine(const Scene& scene, const std::string& solver, double tolerance, double fixedStep,
              double duration, Trajectory* trajectory)
{
  Row row{scene.name, solver, tolerance, fixedStep, 0.0, std::nan(""), 0, 0, true};
  SolverSettings settings;
  settings.solver = solver;
  settings.tolerance = tolerance > 0.0 ? tolerance : 1e-3;
  settings.fixedStep = fixedStep;
  const double start = processorSeconds();
  Result<Simulation> simulation = Simulation::create(scene.net, scene.loads, settings);
  if (!simulation) {
    row.good = false;
    return row;
  }
  if (trajectory) trajectory->assign(1, simulation->state().position);
  StepReport report;
  for (long frame = 0; frame < frameCount(duration) && report.good(); ++frame) {
    report.add(simulation->advance(1.0 / kFrameRate));
    if (trajectory) trajectory->push_back(simulation->state().position);
  }
  row.seconds = processorSeconds() - start;
  row.good = report.good();
  if (fixedStep == 0.0) row.step = report.smallestStep;
  if (solver == "auto") row.solver += ":" + simulation->solverName();
  row.springs = report.springsEvaluated;
  row.hash = hashOf(simulation->state().velocity, hashOf(simulation->state().position, 0));
  return row;
}

Row runPlain(const Scene& scene, const std::string& method, int stepsPerFrame, Trajectory* trajectory)
{
  const double h = 1.0 / kFrameRate / stepsPerFrame;
  Row row{scene.name, method, 0.0, h, 0.0, std::nan(""), 0, 0, true};
  const bool fourth = method == "plain_rk4";
  const double start = processorSeconds();
  PlainNet net(scene.net, scene.loads);
  Eigen::Matrix3Xd x;
  net.positions(x);
  if (trajectory) trajectory->assign(1, x);
  for (long frame = 0; frame < frameCount(scene.duration) && row.good; ++frame) {
    for (int step = 0; step < stepsPerFrame; ++step)
      fourth ? net.stepRungeKutta4(h) : net.stepSymplecticEuler(h);
    net.positions(x);
    row.good = x.allFinite();
    if (trajectory) trajectory->push_back(x);
  }
  row.seconds = processorSeconds() - start;
  row.springs = frameCount(scene.duration) * stepsPerFrame * (fourth ? 4 : 1) * scene.net.springCount();
  row.hash = hashOf(x, 0);
  return row;
}

} // namespace esm::bench
