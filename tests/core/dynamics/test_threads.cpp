// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Threads change nothing but the time. The nets here have somewhat more springs than the least that is
// divided.
#include "core/base/hash.h"
#include "core/base/worker_pool.h"
#include "core/forces/force_model.h"
#include "core/net/net_builder.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/methods.h"
#include "tests/support/nets.h"
#include "tests/support/physics.h"

#include <cstring>
#include <numeric>
#include <random>

namespace esm::test {
namespace {

constexpr Index kSide = 101; ///< nodes along a sheet with 30,200 springs
constexpr int kThreads[] = {1, 2, 3, 5};

/// A sheet with all laws, damped and undamped springs, some tension-only, and held nodes.
/// @param anchorEvery  one node in so many is anchored.
SpringNet mixedSheet(Index anchorEvery)
{
  SpringNet net;
  resizeNet(net, kSide * kSide, (kSide - 1) * (3 * kSide - 1));
  Index next = 0;
  const auto join = [&](Index a, Index b) { net.ends.col(next++) << a, b; };
  for (Index row = 0; row < kSide; ++row)
    for (Index column = 0; column < kSide; ++column) {
      const Index here = row * kSide + column;
      net.restPosition.col(here) << 0.01 * column, 0.01 * row, 0.0;
      if (column + 1 < kSide) join(here, here + 1);
      if (row + 1 < kSide) join(here, here + kSide);
      if (column + 1 < kSide && row + 1 < kSide) join(here, here + kSide + 1);
    }
  std::mt19937 random(11);
  net.tables = {{{-0.5, 0.0, 0.1, 0.4}, {-0.3, 0.0, 0.1, 1.2}}};
  for (Index s = 0; s < net.springCount(); ++s) {
    const auto place = static_cast<std::size_t>(s);
    net.law[place] = static_cast<SpringLaw>(random() % 4);
    net.lawParameter[s] = net.law[place] == SpringLaw::Table ? 0.0 : 2.0;
    net.tensionOnly[place] = random() % 5 == 0 ? 1 : 0;
    net.stiffness[s] = 100.0;
    net.viscosity[s] = random() % 3 == 0 ? 0.0 : 0.02;
    const double length =
      (net.restPosition.col(net.ends(1, s)) - net.restPosition.col(net.ends(0, s))).norm();
    net.restLength[s] = length * (0.9 + 0.01 * static_cast<double>(random() % 10));
  }
  net.mass.setConstant(1e-3);
  for (Index node = 0; node < net.nodeCount(); node += anchorEvery) net.anchors.node.push_back(node);
  const auto anchors = static_cast<Index>(net.anchors.node.size());
  net.anchors.point = net.restPosition(Eigen::all, Eigen::seq(0, Eigen::last, anchorEvery));
  net.anchors.point.row(2).setConstant(1e-3);
  net.anchors.stiffness = Eigen::ArrayXd::Constant(anchors, 5.0);
  net.anchors.viscosity = Eigen::ArrayXd::Constant(anchors, 0.01);
  for (Index node = 0; node < kSide; ++node) net.fixed[static_cast<std::size_t>(node)] = 1;
  return net;
}

/// The same net with its nodes in a random order.
SpringNet shuffled(const SpringNet& net)
{
  std::vector<Index> place(static_cast<std::size_t>(net.nodeCount()));
  std::iota(place.begin(), place.end(), Index{0});
  std::mt19937 random(3);
  for (std::size_t i = place.size() - 1; i > 0; --i) std::swap(place[i], place[random() % (i + 1)]);
  SpringNet result = net;
  for (Index& end : result.ends.reshaped()) end = place[static_cast<std::size_t>(end)];
  for (Index& node : result.anchors.node) node = place[static_cast<std::size_t>(node)];
  for (std::size_t i = 0; i < place.size(); ++i) {
    result.restPosition.col(place[i]) = net.restPosition.col(static_cast<Index>(i));
    result.fixed[static_cast<std::size_t>(place[i])] = net.fixed[i];
  }
  return result;
}

NodeArray randomNodes(std::size_t count, double size)
{
  std::mt19937 random(7);
  const auto number = [&] { return size * (static_cast<double>(random()) / 2147483648.0 - 1.0); };
  NodeArray nodes(count, Lanes{0, 0, 0, 0});
  for (Lanes& node : nodes)
    for (int lane = 0; lane < 3; ++lane) node[lane] = number();
  return nodes;
}

/// A tenth of a spring away from rest, so that no law runs away.
NodeArray nearRest(const SpringNet& net)
{
  NodeArray nodes = randomNodes(static_cast<std::size_t>(net.nodeCount()), 1e-3);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    nodes[i] += toLanes(net.restPosition.col(static_cast<Index>(i)));
  return nodes;
}

bool areSameBits(const NodeArray& a, const NodeArray& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Lanes)) == 0;
}

std::uint64_t hashOf(const Simulation& simulation)
{
  const NetState& state = simulation.state();
  const double sums[] = {simulation.externalWork(), simulation.dissipatedEnergy()};
  const auto bytes = [](const Eigen::Matrix3Xd& x) {
    return sizeof(double) * static_cast<std::size_t>(x.size());
  };
  return hashBytes(sums, sizeof sums,
                   hashBytes(state.velocity.data(), bytes(state.velocity),
                             hashBytes(state.position.data(), bytes(state.position))));
}

/// Frames with gravity, a push, a pulled edge, then a tool, then other parameters. @return hash of the end.
std::uint64_t move(const SpringNet& net, SolverSettings settings, int threads, int frames)
{
  settings.threads = threads;
  Loads loads;
  loads.gravity = {0, 0, -9.81};
  const auto constant = [](const Eigen::Vector3d& value) { return VectorCurve{{0.0}, value}; };
  loads.forces.push_back({{kSide * 20 + 5, kSide * 60 + 40}, constant({0.1, 0, 0.2})});
  VectorCurve pull;
  pull.time = {0.0, 0.1};
  pull.value = Eigen::Matrix3Xd::Zero(3, 2);
  pull.value(0, 1) = 0.01;
  loads.motions.push_back({{kSide * (kSide - 1), kSide * (kSide - 1) + 1}, pull, 0.03});
  Simulation simulation = simulate(net, loads, settings);
  const ToolSpring tool{kSide * 40 + 40, {0.4, 0.4, 0.01}, {0, 0, 0.1}, 20.0, 0.1};
  SpringNet stiffer = net;
  stiffer.stiffness *= 1.1;
  for (int frame = 0; frame < frames; ++frame) {
    if (frame == 1) simulation.setTools({&tool, 1});
    if (frame == 2) {
      EXPECT_TRUE(simulation.setParameters(stiffer));
    }
    EXPECT_TRUE(simulation.advance(1.0 / 60.0).good()) << simulation.why();
  }
  return hashOf(simulation);
}

} // namespace

// Whatever the number of parts and threads, each part is done once, and the caller sees what was written; at
// once after the last piece and after the workers have gone to sleep.
TEST(WorkerPool, DoesEachPartOnce)
{
  for (const int threads : kThreads) {
    WorkerPool pool(threads);
    EXPECT_EQ(pool.threads(), threads);
    std::vector<int> done(300, 0);
    for (const std::size_t count : {0u, 1u, 2u, 7u, 64u, 300u})
      for (int repeat = 0; repeat < 50; ++repeat) {
        if (repeat == 25) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        std::fill(done.begin(), done.end(), 0);
        pool.forEach(count, [&](std::size_t i) noexcept { ++done[i]; });
        const auto end = done.begin() + static_cast<std::ptrdiff_t>(count);
        ASSERT_EQ(std::count(done.begin(), end, 1), end - done.begin());
        ASSERT_EQ(std::count(end, done.end(), 0), done.end() - end);
      }
  }
}

// The promise that keeps threads apart: parts of a phase share no node; and no spring is lost. In a random
// order nearly all springs are between ranges.
TEST(Threads, PartsOfAPhaseShareNoNode)
{
  const SpringNet ordered = mixedSheet(10);
  for (const bool isRandom : {false, true}) {
    const SpringNet net = isRandom ? shuffled(ordered) : ordered;
    std::vector<Index> all(static_cast<std::size_t>(net.springCount()));
    std::iota(all.begin(), all.end(), Index{0});
    const NetDivision division(net, all);
    ASSERT_EQ(division.firstPart[3], division.partCount());
    std::vector<std::size_t> sizes;
    for (std::size_t phase = 0; phase < 3; ++phase) {
      std::vector<std::size_t> owner(static_cast<std::size_t>(net.nodeCount()), division.partCount());
      for (std::size_t p = division.firstPart[phase]; p < division.firstPart[phase + 1]; ++p)
        for (std::size_t i = division.first[p]; i < division.first[p + 1]; ++i)
          for (const int end : {0, 1}) {
            const Index node = net.ends(end, division.springs[i]);
            std::size_t& now = owner[static_cast<std::size_t>(node)];
            EXPECT_TRUE(now == p || now == division.partCount()) << "node " << node;
            now = p;
            if (phase == 0) {
              EXPECT_EQ(division.ranges.of(node), p);
            }
          }
      sizes.push_back(division.first[division.firstPart[phase + 1]] -
                      division.first[division.firstPart[phase]]);
    }
    EXPECT_EQ(sizes[0] > sizes[1] + sizes[2], !isRandom);
    // There is work for several threads where most of it is.
    const std::size_t busy = isRandom ? 1 : 0;
    EXPECT_GE(division.firstPart[busy + 1] - division.firstPart[busy], 4u);
    std::vector<Index> springs = division.springs;
    std::sort(springs.begin(), springs.end());
    EXPECT_EQ(springs, all);
  }
  EXPECT_FALSE(ForceModel(sheet(20, 0.01, 100.0), {0, 0, 0}).isDivided()); // one part: the plain pass
}

// Forces, kept damping and heat have the same bits on one thread and on five, with few anchors (a list) and
// with many (arrays).
TEST(Threads, ForcePassesHaveTheSameBits)
{
  for (const Index anchorEvery : {2, 10})
    for (const bool isRandom : {false, true}) {
      const SpringNet ordered = mixedSheet(anchorEvery);
      const SpringNet net = isRandom ? shuffled(ordered) : ordered;
      const ForceModel model(net, {0, 0, -9.81});
      ASSERT_TRUE(model.isDivided());
      const NodeArray x = nearRest(net), v = randomNodes(model.nodeCount(), 1.0);
      NodeArray force(x.size()), damper(model.damperSize(), Lanes{0, 0, 0, 0});
      const double heat = model.computeForces(x.data(), v.data(), force.data(), damper.data());
      NodeArray damped = force;
      model.addDamping(damper.data(), v.data(), damped.data());
      EXPECT_FALSE(areSameBits(force, damped));
      for (const int threads : kThreads) {
        WorkerPool pool(threads);
        for (int repeat = 0; repeat < 2; ++repeat) { // which thread does what differs each time
          NodeArray again(x.size()), kept(damper.size(), Lanes{0, 0, 0, 0});
          const double found = model.computeForces(x.data(), v.data(), again.data(), kept.data(), &pool);
          EXPECT_TRUE(areSameBits(again, force)) << threads;
          EXPECT_TRUE(areSameBits(kept, damper)) << threads;
          EXPECT_EQ(found, heat) << threads;
          model.addDamping(kept.data(), v.data(), again.data(), &pool);
          EXPECT_TRUE(areSameBits(again, damped)) << threads;
        }
      }
    }
}

// What a method does with the nodes on the way through a pass is what it does before it: same bits, on any
// number of threads, also where nodes are put to prescribed places in between.
TEST(Threads, SweepsOnTheWayAreSweepsBefore)
{
  const SpringNet net = shuffled(mixedSheet(2));
  for (const bool isPrescribed : {false, true}) {
    Loads loads;
    if (isPrescribed) loads.motions.push_back({{7, 4'000}, {{0.0, 1.0}, Eigen::Matrix3Xd::Ones(3, 2)}, {}});
    System system(net, loads);
    const std::size_t count = system.nodeCount();
    const NodeArray from = nearRest(net), slow = randomNodes(count, 1.0), missed = randomNodes(count, 0.1);
    NodeArray x = from, v = slow;
    const auto move = [&](std::size_t first, std::size_t nodes) noexcept {
      for (std::size_t i = first; i < first + nodes; ++i) {
        x[i] += slow[i] * 1e-3;
        v[i] += slow[i];
      }
    };
    NodeArray force(count), w(count), damper(system.forces().damperSize(), Lanes{0, 0, 0, 0});
    const auto correct = [&](std::size_t first, std::size_t nodes) noexcept {
      for (std::size_t i = first; i < first + nodes; ++i) {
        w[i] = missed[i] + force[i] * 1e-3;
        force[i] = force[i] * 0.5;
      }
    };
    MotionState start{{}, x, v};
    system.enter(start, true);
    move(0, count);
    const double heat = system.evaluate(0.5, x, v, force, damper.data()).heat;
    const NodeArray movedTo = x, atFirst = force;
    correct(0, count);
    system.addDamping(damper.data(), w, force);
    const NodeArray expected = force;
    for (const int threads : kThreads) {
      WorkerPool pool(threads);
      system.setWorkers(&pool);
      x = from;
      v = slow;
      EXPECT_EQ(system.evaluate(0.5, x, v, force, damper.data(), move).heat, heat) << threads;
      EXPECT_TRUE(areSameBits(x, movedTo)) << threads;
      EXPECT_TRUE(areSameBits(force, atFirst)) << threads;
      system.addDamping(damper.data(), w, force, correct);
      EXPECT_TRUE(areSameBits(force, expected)) << threads;
    }
    system.setWorkers(nullptr);
  }
}

// A division changes the order of sums and nothing else: forces agree with those of the same springs one by
// one to rounding, 1e-12 of the largest force here.
TEST(Threads, DividedForcesAreTheForces)
{
  const SpringNet net = shuffled(mixedSheet(10));
  const ForceModel model(net, {0, 0, -9.81});
  const NodeArray x = nearRest(net), still(x.size(), Lanes{0, 0, 0, 0});
  NodeArray force(x.size());
  model.computeForces(x.data(), still.data(), force.data());
  Eigen::ArrayXd tension(net.springCount());
  model.springTensions(x.data(), still.data(), tension.data());
  Eigen::Matrix3Xd expected = Eigen::Vector3d(0, 0, -9.81) * net.mass.matrix().transpose();
  const auto at = [&](Index node) { return toVector(x[static_cast<std::size_t>(node)]); };
  for (Index s = 0; s < net.springCount(); ++s) {
    const Index a = net.ends(0, s), b = net.ends(1, s);
    const Eigen::Vector3d pull = tension[s] * (at(b) - at(a)).normalized();
    expected.col(a) += pull;
    expected.col(b) -= pull;
  }
  for (std::size_t i = 0; i < net.anchors.node.size(); ++i) {
    const Index node = net.anchors.node[i], place = static_cast<Index>(i);
    expected.col(node) += net.anchors.stiffness[place] * (net.anchors.point.col(place) - at(node));
  }
  const double largest = expected.cwiseAbs().maxCoeff();
  for (Index node = 0; node < net.nodeCount(); ++node)
    EXPECT_NEAR((toVector(force[static_cast<std::size_t>(node)]) - expected.col(node)).norm() / largest, 0,
                1e-12);
}

// Kept dampers are what velocities add to the forces, to rounding: 1e-12 of the largest force.
TEST(Threads, DividedDampersAreTheDampers)
{
  const SpringNet net = mixedSheet(10);
  const ForceModel model(net, {0, 0, -9.81});
  const NodeArray x = nearRest(net), v = randomNodes(model.nodeCount(), 1.0);
  const NodeArray still(x.size(), Lanes{0, 0, 0, 0});
  NodeArray moving(x.size()), damped(x.size()), damper(model.damperSize());
  model.computeForces(x.data(), v.data(), moving.data());
  model.computeForces(x.data(), still.data(), damped.data(), damper.data());
  model.addDamping(damper.data(), v.data(), damped.data());
  double largest = 0.0, difference = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    largest = std::max(largest, toVector(moving[i]).norm());
    difference = std::max(difference, (toVector(damped[i]) - toVector(moving[i])).norm());
  }
  EXPECT_LT(difference, 1e-12 * largest);
}

// Whole runs with loads and tools: the same bits with one thread and with two.
TEST(Threads, RunsHaveTheSameBits)
{
  for (const std::string& solver : explicitMethods({"block-descent"})) {
    const SolverSettings settings = fixedSteps(solver, 1e-3);
    EXPECT_EQ(move(mixedSheet(2), settings, 2, 2), move(mixedSheet(2), settings, 1, 2)) << solver;
  }
}

// The same when parameters change on the way, with as many threads as there are, and twice in a row.
TEST(Threads, RunsHaveTheSameBitsAgain)
{
  const SolverSettings settings = fixedSteps("leapfrog", 1e-3);
  const std::uint64_t once = move(mixedSheet(10), settings, 1000, 3);
  EXPECT_EQ(move(mixedSheet(10), settings, 1000, 3), once);
  EXPECT_EQ(move(mixedSheet(10), settings, 1, 3), once);
}

// The choice of method and step must not look at threads: the same bits under `auto`.
TEST(Threads, AutomaticRunsHaveTheSameBits)
{
  SolverSettings settings;
  settings.tolerance = 0.1;
  EXPECT_EQ(move(mixedSheet(10), settings, 2, 1), move(mixedSheet(10), settings, 1, 1));
}

// A frame on several threads allocates nothing.
TEST(Threads, FramesDoNotAllocate)
{
  SolverSettings settings = fixedSteps("leapfrog", 1e-3);
  settings.threads = 2;
  Simulation simulation = simulate(mixedSheet(10), {}, settings);
  simulation.advance(1.0 / 60.0);
  const std::uint64_t before = allocationsOfThisThread();
  for (int frame = 0; frame < 3; ++frame) simulation.advance(1.0 / 60.0);
  EXPECT_EQ(allocationsOfThisThread() - before, 0u);
}

} // namespace esm::test
