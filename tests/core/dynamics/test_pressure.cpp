// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/simulation.h"
#include "core/dynamics/system/implicit_matrix.h"
#include "core/net/net_builder.h"
#include "tests/support/methods.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <map>
#include <random>
#include <string>

namespace esm {
namespace {

/// A sphere about the origin, an octahedron's faces in n^2 parts each, as a net of springs of `stiffness`
/// [N/m] that keeps its volume by a bulk modulus of `bulk` [Pa].
SpringNet balloon(int n, double radius, double stiffness, double bulk)
{
  std::map<std::array<int, 3>, Index> vertices;
  std::vector<std::array<int, 3>> triangles;
  const auto vertex = [&](int x, int y, int z) {
    return vertices.emplace(std::array{x, y, z}, static_cast<Index>(vertices.size())).first->second;
  };
  for (int sign = 0; sign < 8; ++sign) {
    const int sx = sign & 1 ? -1 : 1, sy = sign & 2 ? -1 : 1, sz = sign & 4 ? -1 : 1;
    const auto add = [&](std::array<int, 3> a, std::array<int, 3> b, std::array<int, 3> c) {
      if (sx * sy * sz < 0) std::swap(b, c);
      const auto at = [&](const std::array<int, 3>& p) { return vertex(sx * p[0], sy * p[1], sz * p[2]); };
      triangles.push_back({at(a), at(b), at(c)});
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        add({n - i - j, i, j}, {n - i - j - 1, i + 1, j}, {n - i - j - 1, i, j + 1});
        if (i + j < n - 1)
          add({n - i - j - 1, i + 1, j}, {n - i - j - 2, i + 1, j + 1}, {n - i - j - 1, i, j + 1});
      }
  }
  Mesh mesh;
  mesh.position.resize(3, static_cast<Eigen::Index>(vertices.size()));
  for (const auto& [place, index] : vertices)
    mesh.position.col(index) = radius * Eigen::Vector3d(place[0], place[1], place[2]).normalized();
  mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      mesh.triangles(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(t)) = triangles[t][k];
  SpringNet net = buildNet(mesh).value();
  net.stiffness.setConstant(stiffness);
  net.viscosity.setConstant(0.01 * stiffness);
  net.mass.setConstant(0.05 / net.nodeCount());
  if (bulk > 0.0) net.pressure = {{net.triangles, bulk}};
  return net;
}

/// Positions of a net pushed about by up to `most` [m], the same numbers each time.
NodeArray shaken(const SpringNet& net, double most)
{
  std::mt19937 random(7);
  NodeArray x(static_cast<std::size_t>(net.nodeCount()));
  copyNodes(net.restPosition, x);
  for (Lanes& place : x)
    for (int k = 0; k < 3; ++k) place[k] += most * (static_cast<double>(random()) / 2147483648.0 - 1.0);
  return x;
}

double volumeOf(const SpringNet& net, const Eigen::Matrix3Xd& position)
{
  NodeArray x(static_cast<std::size_t>(net.nodeCount()));
  copyNodes(position, x);
  SpringNet still = net;
  still.pressure = {{net.triangles, 1.0}};
  return Pressure(still).volume(0, x.data());
}

// A regular octahedron of half axis a holds 4/3 a^3.
TEST(Pressure, KnowsTheVolumeOfAnOctahedron)
{
  const SpringNet net = balloon(1, 0.03, 10.0, 1e4);
  EXPECT_NEAR(Pressure(net).restVolume(0) / (4.0 / 3.0 * 27e-6), 1.0, 1e-14);
}

// The force is the negative gradient of the energy: central differences agree to their own error, h^2 in
// theory, at h = 1e-7 of 3 cm mostly rounding: 1e-8 of the largest force.
TEST(Pressure, ForcesAreTheGradientOfTheEnergy)
{
  const SpringNet net = balloon(3, 0.03, 10.0, 2e4);
  const Pressure pressure(net);
  NodeArray x = shaken(net, 0.004), force(x.size(), Lanes{0, 0, 0, 0});
  pressure.addForces(x.data(), force.data());
  double largest = 0.0;
  for (const Lanes& f : force) largest = std::max(largest, std::sqrt(dot(f, f)));
  ASSERT_GT(largest, 1e-3);
  constexpr double h = 1e-7;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const double at = x[i][k];
      x[i][k] = at + h;
      const double above = pressure.energy(x.data());
      x[i][k] = at - h;
      const double below = pressure.energy(x.data());
      x[i][k] = at;
      EXPECT_NEAR(force[i][k], (below - above) / (2.0 * h), 1e-7 * largest);
    }
}

// Pressure from inside pushes nothing away and turns nothing, wherever the body is: sums are zero to
// rounding.
TEST(Pressure, HasNoForceAndNoTorqueAsAWhole)
{
  const SpringNet net = balloon(4, 0.03, 10.0, 2e4);
  NodeArray x = shaken(net, 0.004), force(x.size(), Lanes{0, 0, 0, 0});
  for (Lanes& place : x) place += Lanes{0.3, -0.2, 0.1, 0.0};
  Pressure(net).addForces(x.data(), force.data());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), torque = sum;
  double size = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sum += toVector(force[i]);
    torque += toVector(x[i]).cross(toVector(force[i]));
    size += toVector(force[i]).norm();
  }
  EXPECT_LT(sum.norm(), 1e-13 * size);
  EXPECT_LT(torque.norm(), 1e-13 * size);
}

// The implicit matrix with pressure is the one without, plus K/V0 g g^T; what solve() gives is its inverse.
TEST(Pressure, ImplicitMatrixInvertsWhatItMultiplies)
{
  SpringNet net = balloon(3, 0.03, 40.0, 5e4);
  net.fixed[0] = net.fixed[5] = 1;
  const System system(net, {});
  const NodeArray x = shaken(net, 0.002);
  NodeArray v(x.size(), Lanes{0, 0, 0, 0}), vector = shaken(net, 1.0), product(x.size());
  vector[0] = vector[5] = Lanes{0, 0, 0, 0};
  ImplicitMatrix matrix;
  matrix.prepare(system);
  ASSERT_TRUE(matrix.factor(system, x, v, ImplicitMatrix::Shares::ofStep(0.01), true));
  matrix.multiply(vector, product);
  NodeArray pressed(x.size());
  SpringNet bare = net;
  bare.pressure.clear();
  const System without(bare, {});
  ImplicitMatrix other;
  other.prepare(without);
  ASSERT_TRUE(other.factor(without, x, v, ImplicitMatrix::Shares::ofStep(0.01), true));
  other.multiply(vector, pressed);
  double difference = 0.0, error = 0.0, length = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
    difference = std::max(difference, dot(product[i] - pressed[i], product[i] - pressed[i]));
  EXPECT_GT(difference, 0.0); // the pressure is in it
  matrix.solve(product);
  for (std::size_t i = 0; i < x.size(); ++i) {
    error += dot(product[i] - vector[i], product[i] - vector[i]);
    length += dot(vector[i], vector[i]);
  }
  EXPECT_LT(std::sqrt(error / length), 1e-10);
}

// Along g the matrix's stiffness is what the force does: finite differences of the pressure's own force, with
// the surface at rest, where nothing turns.
TEST(Pressure, StiffnessIsTheDerivativeOfTheForceAtRest)
{
  const SpringNet net = balloon(3, 0.03, 10.0, 2e4);
  const Pressure pressure(net);
  NodeArray x(static_cast<std::size_t>(net.nodeCount())), g(x.size(), Lanes{0, 0, 0, 0}), before = g,
                                                                                          after = g;
  copyNodes(net.restPosition, x);
  pressure.addGradient(0, x.data(), g.data());
  const NodeArray way = shaken(net, 1.0);
  double along = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) along += dot(g[i], way[i]);
  constexpr double h = 1e-7;
  NodeArray there = x, back = x;
  for (std::size_t i = 0; i < x.size(); ++i) {
    there[i] += way[i] * h;
    back[i] -= way[i] * h;
  }
  pressure.addForces(there.data(), after.data());
  pressure.addForces(back.data(), before.data());
  for (std::size_t i = 0; i < x.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const double wanted = -pressure.stiffness(0) * along * g[i][k];
      // The turning part is even in h here but for terms of h^2.
      EXPECT_NEAR((after[i][k] - before[i][k]) / (2.0 * h), wanted,
                  1e-5 * pressure.stiffness(0) * std::abs(along) * 1e-4);
    }
}

// At rest the pressure is 0 to the bit: a body that nobody touches stays where it is, bit for bit.
TEST(Pressure, RestStaysRest)
{
  const SpringNet net = balloon(4, 0.03, 10.0, 1e6);
  for (const char* solver : {"auto", "verlet", "implicit"}) {
    SolverSettings settings;
    settings.solver = solver;
    auto simulation = Simulation::create(net, {}, settings);
    ASSERT_TRUE(simulation);
    ASSERT_TRUE(simulation->advance(0.1).good());
    EXPECT_EQ(simulation->state().position, net.restPosition) << solver;
  }
}

/// Hangs a balloon by its top and lets it fall into its own weight; the least volume over that at rest.
double leastVolume(double bulk, const std::string& solver)
{
  SpringNet net = balloon(3, 0.03, 15.0, bulk);
  Eigen::Index top = 0;
  net.restPosition.row(2).maxCoeff(&top);
  for (Index node = 0; node < net.nodeCount(); ++node)
    if (net.restPosition(2, node) > 0.8 * 0.03) net.fixed[static_cast<std::size_t>(node)] = 1;
  Loads loads;
  loads.gravity = {0, 0, -9.81};
  // A poke from one side.
  Eigen::Index side = 0;
  net.restPosition.row(0).maxCoeff(&side);
  loads.forces.push_back(
    {{static_cast<Index>(side)}, {{0.1, 0.15, 0.3, 0.35}, Eigen::Matrix3Xd::Zero(3, 4)}});
  loads.forces[0].force.value.col(1) = loads.forces[0].force.value.col(2) = Eigen::Vector3d(-0.3, 0, 0);
  SolverSettings settings;
  settings.solver = solver;
  const bool damps = solver == "lie" || solver == "descent" || solver == "block-descent";
  if (damps) settings.fixedStep = 2e-3; // first order: they would step finely
  if (solver == "wavefront") settings.fixedStep = 1e-4;
  auto simulation = Simulation::create(net, loads, settings);
  if (!simulation) {
    ADD_FAILURE() << simulation.error().detail;
    return 0.0;
  }
  const double whole = volumeOf(net, net.restPosition);
  double least = 1.0;
  for (int frame = 0; frame < 27; ++frame) {
    EXPECT_TRUE(simulation->advance(1.0 / 60.0).good()) << solver << ": " << simulation->why();
    least = std::min(least, volumeOf(net, simulation->state().position) / whole);
  }
  // But for the methods that damp by themselves, energy: what came in is there or has become heat, within the
  // 1e-3 of the tolerance and its sum over time.
  const Energies now = simulation->energies();
  const double stored = now.kinetic + now.elastic + now.gravity;
  const double start = -net.mass.matrix().dot(net.restPosition.transpose() * loads.gravity);
  if (solver != "wavefront" && !damps) {
    EXPECT_NEAR(stored + simulation->dissipatedEnergy() - simulation->externalWork() - start, 0.0,
                0.05 * (simulation->dissipatedEnergy() + now.elastic))
      << solver;
  }
  return least;
}

// Under weight and a poke a skin loses volume; with the pressure of something nearly incompressible it does
// not, whichever method steps it.
TEST(Pressure, KeepsTheVolumeUnderGravityAndAPoke)
{
  EXPECT_LT(leastVolume(0.0, "verlet"), 0.97);
  for (const std::string& solver :
       test::accurateMethods({"auto", "multirate", "lie", "descent", "block-descent"}))
    EXPECT_GT(leastVolume(2e5, solver), 0.99) << solver;
  EXPECT_GT(leastVolume(2e5, "wavefront"), 0.98);
}

// Nearly water (a bulk modulus of 20 MPa on springs of 15 N/m): the breathing motion is now the fastest, and
// the explicit methods' own steps know it.
TEST(Pressure, AVeryStiffBodyLimitsTheStep)
{
  const double soft = Simulation::create(balloon(4, 0.03, 15.0, 0.0), {}, {})->stableStep();
  const double stiff = Simulation::create(balloon(4, 0.03, 15.0, 2e7), {}, {})->stableStep();
  EXPECT_LT(stiff, 0.5 * soft);
  EXPECT_GT(leastVolume(2e7, "verlet"), 0.999);
}

// A free balloon that is pushed into an egg: momentum and angular momentum stay what they were.
TEST(Pressure, KeepsMomentumAndAngularMomentum)
{
  SpringNet net = balloon(4, 0.03, 15.0, 5e4);
  net.initialVelocity = Eigen::Matrix3Xd::Zero(3, net.nodeCount());
  for (Index i = 0; i < net.nodeCount(); ++i) {
    const Eigen::Vector3d p = net.restPosition.col(i);
    net.initialVelocity.col(i) = Eigen::Vector3d(0.1, 0.0, 0.02) + Eigen::Vector3d(0, 0, 3).cross(p) +
                                 Eigen::Vector3d(-8.0 * p[0], 4.0 * p[1], 4.0 * p[2]);
  }
  SolverSettings settings;
  settings.solver = "verlet";
  auto simulation = Simulation::create(net, {}, settings);
  ASSERT_TRUE(simulation);
  const Eigen::Vector3d momentum = simulation->momentum(), spin = simulation->angularMomentum();
  ASSERT_TRUE(simulation->advance(0.3).good());
  EXPECT_LT((simulation->momentum() - momentum).norm(), 1e-12 * momentum.norm());
  EXPECT_LT((simulation->angularMomentum() - spin).norm(), 1e-6 * spin.norm()); // Verlet predicts velocities
}

// Equal bits on any number of threads.
TEST(Pressure, IsTheSameOnAnyThreads)
{
  SpringNet net = balloon(24, 0.03, 15.0, 5e4); // large enough to be divided
  net.initialVelocity = Eigen::Matrix3Xd::Zero(3, net.nodeCount());
  net.initialVelocity.row(0) = -5.0 * net.restPosition.row(0);
  Eigen::Matrix3Xd first;
  for (const int threads : {1, 2}) {
    SolverSettings settings;
    settings.solver = "verlet";
    settings.threads = threads;
    auto simulation = Simulation::create(net, {}, settings);
    ASSERT_TRUE(simulation);
    ASSERT_TRUE(simulation->advance(0.01).good());
    if (threads == 1)
      first = simulation->state().position;
    else
      EXPECT_EQ(simulation->state().position, first);
  }
}

// What is not closed, or inside out, or has no modulus, is refused with its number.
TEST(Pressure, OpenSurfacesAreRefused)
{
  const SpringNet good = balloon(2, 0.03, 10.0, 1e4);
  ASSERT_TRUE(checkNet(good));
  const auto refused = [&](const auto& spoil) {
    SpringNet net = good;
    spoil(net.pressure[0]);
    const Status status = checkNet(net);
    const std::string why = status ? "" : status.error().detail;
    EXPECT_NE(why.find("pressure body 0"), std::string::npos) << why;
  };
  refused([](PressureBody& body) { body.triangles.conservativeResize(3, body.triangles.cols() - 1); });
  refused([](PressureBody& body) { body.triangles.row(1).swap(body.triangles.row(2)); });
  refused([](PressureBody& body) { body.triangles(0, 0) = 10000; });
  refused([](PressureBody& body) { body.bulkModulus = 0.0; });
  refused([](PressureBody& body) { body.triangles.resize(3, 0); });
}

} // namespace
} // namespace esm
