// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/load_schedule.h"
#include "core/forces/pressure.h"
#include "core/forces/spring_law.h"
#include "core/forces/spring_matrix.h"
#include "core/net/net_builder.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>

namespace esm {
const SpringLawKernel& plainLinearLaw() noexcept;
const SpringLawKernel& plainCubicLaw() noexcept;
const SpringLawKernel& plainExponentialLaw() noexcept;
const SpringLawKernel& plainTableLaw() noexcept;
void plainAddDamping(const SpringBatch& batch, const Lanes* damper, const Lanes* v, Lanes* force) noexcept;

double plainVolume(const SpringNet& net, const Lanes* x, Lanes* gradient);

namespace testing {
namespace {

/// One of few points, and one of so many that springs look theirs up.
std::vector<ForceTable> twoTables()
{
  std::vector<ForceTable> tables = {{{-0.4, -0.1, 0.0, 0.3, 1.0}, {-0.3, -0.2, 0.01, 0.4, 3.0}}, {}};
  for (int i = 0; i < 40; ++i) {
    tables[1].strain.push_back(0.05 * i - 0.8);
    tables[1].force.push_back(std::sinh(tables[1].strain.back()));
  }
  return tables;
}

/// Of a table from 0 to `strain`: trapezia between its points, the end lines without end.
double integralOf(const ForceTable& table, double strain)
{
  double sum = 0.0;
  const double low = std::min(strain, 0.0), high = std::max(strain, 0.0);
  for (std::size_t j = 0; j + 1 < table.strain.size(); ++j) {
    const double begin = j == 0 ? low : std::clamp(table.strain[j], low, high);
    const double end = j + 2 == table.strain.size() ? high : std::clamp(table.strain[j + 1], low, high);
    const double slope = (table.force[j + 1] - table.force[j]) / (table.strain[j + 1] - table.strain[j]);
    const double middle = table.force[j] + slope * (0.5 * (begin + end) - table.strain[j]);
    sum += middle * (end - begin);
  }
  return strain < 0.0 ? -sum : sum;
}

/// By the integrals of the laws, one spring after the other.
double energyOf(const SpringBatch& batch, const NodeArray& x)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < batch.count; ++i) {
    const Lanes d = x[static_cast<std::size_t>(batch.b[i])] - x[static_cast<std::size_t>(batch.a[i])];
    const double rest = batch.restLength[i], k = batch.stiffness[i], p = batch.parameter[i];
    const double e = std::sqrt(dot(d, d)) - rest;
    if (batch.tensionOnly && e <= 0.0) continue;
    const double s = p * e / rest, inside = std::clamp(s, -100.0, 100.0),
                 out = s - inside; // then its tangent
    if (batch.law == SpringLaw::Table)
      sum += k * rest * rest * integralOf(twoTables()[static_cast<std::size_t>(p)], e / rest);
    else if (batch.law == SpringLaw::Exponential)
      sum += k * std::pow(rest / p, 2) *
             (std::expm1(inside) - inside + std::expm1(inside) * out + 0.5 * std::exp(inside) * out * out);
    else
      sum += 0.5 * k * e * e * (batch.law == SpringLaw::Cubic ? 1.0 + 0.5 * p * std::pow(e / rest, 2) : 1.0);
  }
  return sum;
}

/// One spring after the other.
struct OneByOne {
  std::vector<double> tension; ///< each at its spring's place
  NodeArray force;             ///< with dampers that pull twice, as in Pulled
};

OneByOne oneByOneOf(const SpringLawKernel& law, const SpringBatch& batch, const NodeArray& x,
                    const NodeArray& v)
{
  OneByOne result{std::vector<double>(batch.count, 0.0), NodeArray(x.size(), Lanes{0, 0, 0, 0})};
  for (std::size_t i = 0; i < batch.count; ++i) {
    const auto a = static_cast<std::size_t>(batch.a[i]), b = static_cast<std::size_t>(batch.b[i]);
    const Lanes d = x[b] - x[a];
    const double length = std::sqrt(dot(d, d)), e = length - batch.restLength[i];
    if (a == b || (batch.tensionOnly && e <= 0.0)) continue;
    const double drag = batch.damped ? batch.viscosity[i] * dot(v[b] - v[a], d) / length : 0.0;
    const double tension = law.respond(batch, i, e).tension + drag;
    result.tension[static_cast<std::size_t>(batch.spring[i])] = tension;
    result.force[a] += d * ((tension + drag) / length);
    result.force[b] -= d * ((tension + drag) / length);
  }
  return result;
}

/// What a kernel makes of a batch.
struct Pulled {
  NodeArray force, kept;
  double heat, energy;
  std::vector<double> tension;
  double largestTension;

  template <class AddDamping>
  Pulled(const SpringLawKernel& law, const AddDamping& addDampingTo, const SpringBatch& batch,
         const NodeArray& x, const NodeArray& v)
    : force(x.size(), Lanes{0, 0, 0, 0}),
      kept(damperSize(batch)),
      heat(law.addForces(batch, x.data(), v.data(), force.data(), kept.data(), {0.01, 8.0})), // late
      energy(law.energy(batch, x.data())),
      tension(batch.count, 0.0),
      largestTension(law.tensions(batch, x.data(), v.data(), tension.data()))
  {
    addDampingTo(batch, kept.data(), v.data(), force.data());
  }
};

bool haveEqualBits(const NodeArray& a, const NodeArray& b)
{
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Lanes)) == 0);
}

} // namespace

// Golden hashes must hold on every x86-64: the version that the loader chooses here (AVX2 where the CPU
// has it) and the plain one give the same bits for forces, heat and energy; and these are what the
// laws say, whether springs are alike or not. Several times: sums in another order have the same last bit now
// and then.
class KernelBitsOf : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(KernelBitsOf, ChosenAndPlainKernelsAgreeToTheLastBit)
{
  constexpr std::size_t kNodes = 200, kSprings = 803; // neither whole fours nor whole dozens
  std::mt19937 random(GetParam());
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  NodeArray x(kNodes), v(kNodes);
  for (std::size_t i = 0; i < kNodes; ++i) {
    x[i] = Lanes{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), 0.0};
    v[i] = Lanes{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), 0.0};
  }
  SpringBatch springs;
  for (std::size_t s = 0; s < kSprings; ++s) {
    springs.a.push_back(static_cast<Index>(random() % kNodes));
    springs.b.push_back(static_cast<Index>(random() % kNodes)); // now and then the same node: zero length
    springs.restLength.push_back(uniform(0.1, 2.0));
    springs.stiffness.push_back(uniform(1, 1000));
    springs.viscosity.push_back(uniform(0.1, 1));
    springs.parameter.push_back(uniform(0.5, 8));
    springs.spring.push_back(static_cast<Index>(s));
  }
  struct Law {
    SpringLaw law;
    const SpringLawKernel *chosen, *plain;
  };
  const Law laws[] = {{SpringLaw::Linear, &linearLaw(), &plainLinearLaw()},
                      {SpringLaw::Cubic, &cubicLaw(), &plainCubicLaw()},
                      {SpringLaw::Exponential, &exponentialLaw(), &plainExponentialLaw()},
                      {SpringLaw::Table, &tableLaw(), &plainTableLaw()}};
  const std::vector<ForceTable> given = twoTables();
  const auto tables = std::make_shared<std::vector<TableLines>>(given.begin(), given.end());
  SpringBatch alikes = springs;
  std::fill(alikes.stiffness.begin(), alikes.stiffness.end(), springs.stiffness.front());
  std::fill(alikes.viscosity.begin(), alikes.viscosity.end(), springs.viscosity.front());
  for (const auto& [law, chosen, plain] : laws)
    for (int kind = 0; kind < 8; ++kind) {
      const bool alike = (kind & 4) != 0;
      SpringBatch batch = alike ? alikes : springs;
      batch.law = law;
      batch.damped = (kind & 1) != 0;
      batch.tensionOnly = (kind & 2) != 0;
      if (law == SpringLaw::Table) { // one or the other for all, or each spring its own
        batch.tables = tables;
        for (double& parameter : batch.parameter)
          parameter = alike ? (batch.damped ? 1.0 : 0.0) : std::floor(parameter / 5.0);
      }
      batch.finish(kNodes);
      EXPECT_EQ(batch.alike, alike && canBeAlike(law));
      EXPECT_EQ(batch.table != nullptr, alike && law == SpringLaw::Table);
      const Pulled here(*chosen, addDamping, batch, x, v);
      const Pulled other(*plain, plainAddDamping, batch, x, v);
      EXPECT_TRUE(haveEqualBits(here.kept, other.kept));
      EXPECT_TRUE(haveEqualBits(here.force, other.force));
      EXPECT_EQ(here.heat, other.heat);
      EXPECT_EQ(here.energy, other.energy);
      EXPECT_EQ(here.tension, other.tension);
      EXPECT_EQ(here.largestTension, other.largestTension);
      const auto [tension, force] = oneByOneOf(*chosen, batch, x, v);
      double largest = 0.0;
      for (const double each : tension) largest = std::max(largest, std::abs(each));
      EXPECT_NEAR(here.largestTension, largest, 1e-13 * largest); // rounding
      for (std::size_t s = 0; s < tension.size(); ++s)
        EXPECT_NEAR(here.tension[s], tension[s], 1e-13 * largest) << s;
      for (std::size_t i = 0; i < kNodes; ++i)
        for (int lane = 0; lane < 3; ++lane) // sums of some ten springs
          EXPECT_NEAR(here.force[i][lane], force[i][lane], 1e-12 * largest) << i;
      EXPECT_EQ(chosen->tensions(batch, x.data(), v.data(), nullptr), here.largestTension);
      const double oneByOne = energyOf(batch, x);
      EXPECT_NEAR(here.energy, oneByOne, 1e-13 * oneByOne); // rounding of sums of 803
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, KernelBitsOf, ::testing::Range(1u, 9u));

// The same for the matrix of springs, against its definition, spring by spring.
TEST(KernelBits, SpringMatrixIsWhatItsBlocksSay)
{
  constexpr std::size_t kNodes = 60;
  std::mt19937 random(6);
  const auto uniform = [&] { return static_cast<double>(random()) / 2147483648.0 - 1.0; };
  NodeArray z(kNodes);
  for (Lanes& node : z) node = Lanes{uniform(), uniform(), uniform(), 0.0};
  SpringNet net;
  resizeNet(net, kNodes, 137);
  net.restPosition.setRandom();
  std::vector<SpringMatrix::Block> blocks;
  for (Index s = 0; s < net.springCount(); ++s) {
    const Index a = static_cast<Index>(random() % kNodes), step = 1 + static_cast<Index>(random() % 5);
    net.ends.col(s) << a, (a + step) % static_cast<Index>(kNodes);
    net.stiffness[s] = net.lawParameter[s] = 1.0;
    // Two batches, of which neither fills its last four.
    net.law[static_cast<std::size_t>(s)] = s < 131 ? SpringLaw::Linear : SpringLaw::Cubic;
    blocks.push_back({Eigen::Vector3d(uniform(), uniform(), uniform()), 100.0 * uniform(), uniform()});
  }
  const ForceModel forces(net, Eigen::Vector3d::Zero());
  const std::vector<SpringBatch>& batches = forces.batches();
  ASSERT_EQ(batches.size(), 2u);
  SpringMatrix matrix;
  matrix.prepare(forces);
  matrix.assign(forces, [&](std::size_t s) { return blocks[s]; });
  NodeArray product(kNodes, Lanes{1, 2, 3, 0}), wanted = product;
  matrix.addProduct(forces, z.data(), product.data());
  std::size_t place = 0;
  for (const SpringBatch& batch : batches)
    for (std::size_t i = 0; i < batch.count; ++i) {
      const SpringMatrix::Block& block = blocks[place++];
      const Lanes d = z[batch.b[i]] - z[batch.a[i]], u = toLanes(block.direction);
      const double along = dot(d, u) * (block.axial - block.lateral);
      const Lanes pull = d * -block.lateral - u * along;
      wanted[batch.a[i]] += pull;
      wanted[batch.b[i]] -= pull;
    }
  EXPECT_TRUE(haveEqualBits(product, wanted));
}

// Nodes of a force are taken together where they follow each other: in whatever order the list has them, each
// gets the force once per mention, and the power is that of all.
TEST(KernelBits, AForceActsOnEveryNodeOfItsList)
{
  constexpr std::size_t kNodes = 40;
  std::mt19937 random(7);
  Loads loads;
  NodalForce& force = loads.forces.emplace_back();
  for (Index node = 3; node < 17; ++node) force.nodes.push_back(node);
  for (int i = 0; i < 30; ++i) force.nodes.push_back(static_cast<Index>(random() % kNodes));
  force.nodes.insert(force.nodes.end(), {20, 21, 22, 22, 21, 20});
  force.force.time = {0.0, 1.0};
  force.force.value = Eigen::Matrix3Xd::Zero(3, 2);
  force.force.value.col(1) << 4.0, -8.0, 12.0;
  LoadSchedule schedule(loads, Eigen::Matrix3Xd::Zero(3, kNodes), std::vector<std::uint8_t>(kNodes, 0));
  schedule.enter(0.0);
  NodeArray v(kNodes), sum(kNodes, Lanes{1, 1, 1, 0}), wanted = sum;
  for (std::size_t i = 0; i < kNodes; ++i)
    v[i] = Lanes{static_cast<double>(i), 1.0, -0.5 * static_cast<double>(i), 0.0};
  double power = 0.0;
  for (const Index node : force.nodes) { // halves and quarters: exact in any order
    wanted[static_cast<std::size_t>(node)] += Lanes{1, -2, 3, 0};
    power += dot(v[static_cast<std::size_t>(node)], Lanes{1, -2, 3, 0});
  }
  EXPECT_EQ(schedule.addForces(0.25, v.data(), sum.data()), power);
  EXPECT_EQ(schedule.power(0.25, v.data()), power);
  EXPECT_TRUE(haveEqualBits(sum, wanted));
}

// The same for the pressure in a surface; and triangle by triangle, by their definition. Their number is no
// multiple of four.
TEST_P(KernelBitsOf, PressureIsWhatItsTrianglesSay)
{
  constexpr Index kNodes = 30, kTriangles = 203;
  std::mt19937 random(GetParam());
  const auto uniform = [&] { return static_cast<double>(random()) / 2147483648.0 - 1.0; };
  SpringNet net;
  resizeNet(net, kNodes, 0);
  NodeArray x(kNodes);
  for (std::size_t i = 0; i < kNodes; ++i) {
    x[i] = Lanes{uniform(), uniform(), uniform(), 0.0};
    net.restPosition.col(static_cast<Index>(i)) << uniform(), uniform(), uniform();
  }
  PressureBody& body = net.pressure.emplace_back();
  body.bulkModulus = 1.0;
  body.triangles.resize(3, kTriangles);
  NodeArray expected(kNodes, Lanes{0, 0, 0, 0});
  double sixVolumes = 0.0;
  for (Index t = 0; t < kTriangles; ++t) {
    for (Index& corner : body.triangles.col(t)) corner = static_cast<Index>(random() % kNodes);
    const auto at = [&](Index k) { return toVector(x[static_cast<std::size_t>(body.triangles(k, t))]); };
    const Eigen::Vector3d a = at(0), b = at(1), c = at(2),
                          from = toVector(x[static_cast<std::size_t>(body.triangles(0, 0))]);
    sixVolumes += (a - from).dot((b - from).cross(c - from));
    for (const Index corner : body.triangles.col(t))
      expected[static_cast<std::size_t>(corner)] += toLanes((b - a).cross(c - a) / 6.0);
  }
  NodeArray here(kNodes, Lanes{0, 0, 0, 0}), plain = here;
  const Pressure pressure(net);
  pressure.addGradient(0, x.data(), here.data());
  EXPECT_EQ(pressure.volume(0, x.data()), plainVolume(net, x.data(), plain.data()));
  EXPECT_TRUE(haveEqualBits(here, plain));
  EXPECT_NEAR(pressure.volume(0, x.data()), sixVolumes / 6.0, 1e-13 * kTriangles); // rounding of such sums
  for (std::size_t i = 0; i < kNodes; ++i)
    EXPECT_LE((toVector(here[i]) - toVector(expected[i])).norm(), 1e-13) << i;
}

// The order that spares the processor its waits is a permutation, and in a net that is not too small two
// springs at one node stand a dozen places apart but for the last few.
TEST(KernelBits, SpringsThatShareANodeStandApart)
{
  constexpr Index kSide = 20;
  SpringNet net;
  resizeNet(net, kSide * kSide, 2 * kSide * (kSide - 1));
  Index s = 0;
  for (Index row = 0; row < kSide; ++row)
    for (Index column = 0; column < kSide; ++column) {
      const Index here = row * kSide + column;
      if (column + 1 < kSide) net.ends.col(s++) << here, here + 1;
      if (row + 1 < kSide) net.ends.col(s++) << here, here + kSide;
    }
  SpringBatch batch;
  for (Index i = 0; i < net.springCount(); ++i) batch.append(net, i);
  batch.finish(static_cast<std::size_t>(net.nodeCount()));
  std::vector<Index> order = batch.spring;
  std::vector<std::ptrdiff_t> lastUse(static_cast<std::size_t>(net.nodeCount()), -100);
  int close = 0;
  for (std::ptrdiff_t place = 0; place < std::ssize(order); ++place)
    for (int end = 0; end < 2; ++end) {
      auto& last = lastUse[static_cast<std::size_t>(net.ends(end, order[static_cast<std::size_t>(place)]))];
      close += place - last < 12 ? 1 : 0;
      last = place;
    }
  EXPECT_LT(close, 20);
  for (std::size_t i = 0; i < order.size(); ++i) {
    EXPECT_EQ(batch.a[i], net.ends(0, order[i]));
    EXPECT_EQ(batch.b[i], net.ends(1, order[i]));
  }
  std::vector<Index> all(order.size());
  std::iota(all.begin(), all.end(), Index{0});
  std::sort(order.begin(), order.end());
  EXPECT_EQ(order, all);
}

} // namespace testing
} // namespace esm
