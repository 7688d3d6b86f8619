// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// A patch of parameters is to the engine what the whole net with these numbers is, and costs what it names.
#include "core/net/net_builder.h"
#include "tests/core/dynamics/skip_nets.h"
#include "tests/support/dice.h"

#include <cstring>

namespace esm::test {
namespace {

bool sameBits(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b)
{
  return a.cols() == b.cols() &&
         std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(double)) == 0;
}

/// Springs as they come, or those around a place.
std::vector<Index> someSprings(const SpringNet& net, Dice& dice)
{
  std::vector<Index> springs;
  const Index start = dice.below(net.springCount()), count = 1 + dice.below(40);
  const bool scattered = dice.oneIn(2);
  for (Index i = 0; i < count; ++i)
    springs.push_back(scattered ? dice.below(net.springCount()) : (start + i) % net.springCount());
  std::sort(springs.begin(), springs.end());
  springs.erase(std::unique(springs.begin(), springs.end()), springs.end());
  return springs;
}

ParameterPatch::Spring numbersOf(const SpringNet& net, Index s)
{
  return {s, net.law[static_cast<std::size_t>(s)], net.stiffness[s], net.viscosity[s], net.lawParameter[s]};
}

void changeSprings(ParameterPatch& patch, const SpringNet& net, Dice& dice)
{
  const Index kind = dice.below(6);
  const double factor = dice.uniform(0.5, 2.0);
  for (const Index s : someSprings(net, dice)) {
    ParameterPatch::Spring spring = numbersOf(net, s);
    spring.stiffness *= factor;
    spring.viscosity *= factor;
    if (kind == 1) spring.stiffness = spring.viscosity = 0.0; // torn
    if (kind == 2) spring.viscosity = spring.viscosity > 0.0 ? 0.0 : 0.01;
    if (kind == 3 && spring.law != SpringLaw::Table)
      spring.law = spring.law == SpringLaw::Linear ? SpringLaw::Cubic : SpringLaw::Linear;
    if (kind == 4 && spring.stiffness == 0.0) spring.stiffness = 10.0; // mended
    if (spring.law != SpringLaw::Table && spring.law != SpringLaw::Linear)
      spring.lawParameter = dice.oneIn(8) ? 0.0 : dice.uniform(0.5, 3.0);
    patch.springs.push_back(spring);
  }
  if (kind != 5) return;
  patch.springs.clear(); // all alike, as in a net that nobody has given tissue yet; or no more so
  for (Index s = 0; s < net.springCount(); ++s) {
    ParameterPatch::Spring spring = numbersOf(net, s);
    spring.stiffness = 60.0;
    spring.viscosity = 0.01;
    patch.springs.push_back(spring);
  }
}

ParameterPatch randomPatch(const SpringNet& net, Dice& dice)
{
  ParameterPatch patch;
  const Index kind = dice.below(7);
  if (kind < 4) changeSprings(patch, net, dice);
  if (kind == 3 || kind == 4)
    for (Index i = dice.below(5); i < net.nodeCount(); i += 1 + dice.below(50)) {
      const double damping = net.massDamping.size() > 0 ? net.massDamping[i] : 0.0;
      patch.nodes.push_back({i, net.mass[i] * dice.uniform(0.9, 1.2), damping * dice.uniform(0.5, 1.5)});
    }
  if (kind == 4 && dice.oneIn(4)) patch.nodes.back().massDamping += 0.5; // perhaps the first that has any
  if (kind == 5)
    for (Index k = 0; k < net.anchors.count(); k += 1 + dice.below(30))
      patch.anchors.push_back({k, dice.oneIn(6) ? 0.0 : net.anchors.stiffness[k] * dice.uniform(0.5, 2.0),
                               net.anchors.viscosity[k]});
  if (kind == 6) { // one anchor less, or one more
    AnchorSet set = net.anchors;
    if (set.count() > 3 && dice.oneIn(2)) {
      set.node.pop_back();
      for (Eigen::ArrayXd* values : {&set.stiffness, &set.viscosity}) values->conservativeResize(set.count());
      set.point.conservativeResize(3, set.count());
    }
    if (dice.oneIn(2)) patch.anchors.push_back({0, 3.0, 0.02});
    patch.anchorSet = std::move(set);
  }
  if (!net.pressure.empty() && dice.oneIn(4)) patch.bulkModuli = {net.pressure[0].bulkModulus * 1.1};
  return patch;
}

struct Story {
  SpringNet net;
  std::string solver = "auto";
  std::uint32_t seed = 1;
  int frames = 12;
};

/// The same motion twice, one given patches and one given nets.
void expectSameMotion(const Story& story)
{
  Dice dice(story.seed);
  Loads loads;
  loads.gravity = {0, 0, -1.0};
  SolverSettings settings = settingsOf(1e-2, true, story.solver);
  settings.effort = 1e7;
  Simulation patched = simulate(story.net, loads, settings), whole = simulate(story.net, loads, settings);
  SpringNet net = story.net;
  const ToolSpring tool = pull(net, net.nodeCount() / 2, {0, 0, 2e-4}, 20.0);
  for (Simulation* simulation : {&patched, &whole}) simulation->setTools({&tool, 1});
  for (int frame = 0; frame < story.frames; ++frame) {
    ParameterPatch patch = randomPatch(net, dice);
    const Status good = checkPatch(patch, net);
    ASSERT_TRUE(good) << good.error().detail;
    if (dice.oneIn(3)) { // two of them as one
      SpringNet between = net;
      patch.applyTo(between);
      const ParameterPatch later = randomPatch(between, dice);
      patch.append(later);
      later.applyTo(between);
      patch.applyTo(net);
      EXPECT_TRUE((net.stiffness == between.stiffness).all() && (net.mass == between.mass).all());
      EXPECT_EQ(net.anchors.node, between.anchors.node);
    } else {
      patch.applyTo(net);
    }
    const auto taken = patched.setParameters(patch);
    ASSERT_TRUE(taken) << taken.error().detail;
    ASSERT_TRUE(whole.setParameters(net));
    const double scale = 1e-9 * std::abs(whole.energies().total()) + 1e-15; // sums in another order
    EXPECT_NEAR(patched.energyReport().atStart.total(), whole.energyReport().atStart.total(), scale);
    Eigen::ArrayXd tension[2] = {Eigen::ArrayXd(net.springCount()), Eigen::ArrayXd(net.springCount())};
    patched.springTensions(tension[0]);
    whole.springTensions(tension[1]);
    EXPECT_TRUE((tension[0] == tension[1]).all());
    patched.springTensions(taken->springs, tension[0]);
    EXPECT_TRUE((tension[0] == tension[1]).all()) << "asked for by themselves";
    const StepReport a = patched.advance(1.0 / 60.0), b = whole.advance(1.0 / 60.0);
    EXPECT_EQ(a.springsEvaluated, b.springsEvaluated) << "frame " << frame;
    EXPECT_EQ(a.nodesAwake, b.nodesAwake);
    EXPECT_EQ(patched.solverName(), whole.solverName());
    ASSERT_TRUE(sameBits(patched.state().position, whole.state().position))
      << "seed " << story.seed << ", frame " << frame << ", " << story.solver;
    ASSERT_TRUE(sameBits(patched.state().velocity, whole.state().velocity));
    EXPECT_EQ(patched.energies().total(), whole.energies().total());
    if (!a.good()) return; // torn apart: so are both
  }
}

SpringNet smallNet(std::uint32_t seed)
{
  Dice dice(seed);
  SpringNet net = randomNet(seed, 40, SpringLaw(seed % 4));
  net.fixed[0] = 1;
  for (Index s = 0; s < net.springCount(); ++s) {
    if (dice.oneIn(5)) net.tensionOnly[static_cast<std::size_t>(s)] = 1;
    if (dice.oneIn(3)) net.viscosity[s] = 0.0;
  }
  const Eigen::Matrix3Xd points = net.restPosition;
  const Index held = seed % 3 == 0 ? 4 : net.nodeCount(); // few, or all of them and some twice
  for (Index i = 0; i < held; ++i) addAnchor(net, i, points.col(i), dice.uniform(1.0, 5.0), 0.02);
  for (Index i = 0; i < held; i += 7) addAnchor(net, i, points.col(i) + dice.vector(0.1), 2.0, 0.0);
  if (seed % 2 == 0) net.massDamping = Eigen::ArrayXd::Constant(net.nodeCount(), 0.3);
  return net;
}

SpringNet unevenSheet(Index n, std::uint32_t seed)
{
  SpringNet net = beddedSheet(n);
  Dice dice(seed);
  for (Index s = 0; s < net.springCount(); ++s) net.stiffness[s] *= dice.uniform(0.8, 1.2);
  net.viscosity = 1e-3 * net.stiffness;
  return net;
}

} // namespace

// Random patches on random nets of all laws: the motion that follows has the bits of the one that follows from the
// whole net.
TEST(ParameterPatch, IsWhatTheWholeNetIs)
{
  for (std::uint32_t seed = 0; seed < 24; ++seed)
    for (const char* solver : {"auto", "verlet", "implicit"}) {
      expectSameMotion({smallNet(seed), solver, seed + 100, 10});
      if (testing::Test::HasFailure()) return;
    }
}

// The same where parts of the net sleep, which the patch must wake, and where it is divided for several threads.
TEST(ParameterPatch, IsWhatTheWholeNetIsInLargeNets)
{
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    expectSameMotion({unevenSheet(60, seed), "auto", seed + 200, 8});
    if (testing::Test::HasFailure()) return;
  }
  expectSameMotion({unevenSheet(110, 9), "auto", 301, 6});
  expectSameMotion({beddedSheet(110), "chebyshev", 302, 6}); // alike at first
}

// Counted, not timed: what the engine looks at is the patch, however large the net; only the first one looks at all,
// to know where they are.
TEST(ParameterPatch, CostsWhatItNames)
{
  constexpr Index kBatches = 64;       // one look at each that is touched: may its springs be alike now?
  for (const Index side : {60, 183}) { // 10,561 and 99,736 springs
    const SpringNet net = unevenSheet(side, 4);
    Simulation simulation = simulate(net, {}, settingsOf(1e-2, true));
    ParameterPatch patch;
    for (Index s = 3000; s < 5000; ++s) patch.springs.push_back(numbersOf(net, s));
    for (int move = 0; move < 3; ++move) {
      for (ParameterPatch::Spring& spring : patch.springs) spring.stiffness *= 1.01;
      const auto change = simulation.setParameters(patch);
      ASSERT_TRUE(change);
      EXPECT_EQ(std::ssize(change->springs), 2000);
      EXPECT_LE(change->springsSeen, (move == 0 ? net.springCount() : 0) + 2 * 2000 + kBatches);
    }
  }
}

// What is wrong is refused, and nothing of it taken.
TEST(ParameterPatch, ARefusedOneLeavesAllAsItWas)
{
  const SpringNet net = smallNet(5);
  Simulation simulation = simulate(net, {}, settingsOf(1e-2, true));
  ParameterPatch patch;
  patch.springs = {numbersOf(net, 2), numbersOf(net, 5)};
  patch.springs[0].stiffness = 7.0;
  patch.springs[1].stiffness = -3.0;
  const auto change = simulation.setParameters(patch);
  ASSERT_FALSE(change);
  EXPECT_EQ(change.error().code, ErrorCode::InvalidValue);
  EXPECT_NE(change.error().detail.find("spring 5 (id 5): stiffness is -3 N/m"), std::string::npos)
    << change.error().detail;
  EXPECT_TRUE((simulation.net().stiffness == net.stiffness).all());
}

} // namespace esm::test
