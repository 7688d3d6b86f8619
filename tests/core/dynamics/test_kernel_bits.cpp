// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/spring_law.h"
#include "core/net/net_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <random>

namespace esm {
const SpringLawKernel& plainLinearLaw() noexcept;
const SpringLawKernel& plainCubicLaw() noexcept;
const SpringLawKernel& plainExponentialLaw() noexcept;
void plainAddDamping(const SpringBatch& batch, const Lanes* damper, const Lanes* v, Lanes* force) noexcept;

namespace testing {

// Golden hashes must hold on every x86-64: the version that the loader chooses here (AVX2 or AVX-512 where
// the CPU has it) and the plain one give the same bits for forces and heat.
TEST(KernelBits, Avx2AndPlainKernelsAgreeToTheLastBit)
{
  constexpr std::size_t kNodes = 200, kSprings = 800;
  std::mt19937 random(5);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  NodeArray x(kNodes), v(kNodes);
  for (std::size_t i = 0; i < kNodes; ++i) {
    x[i] = Lanes{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), 0.0};
    v[i] = Lanes{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), 0.0};
  }
  SpringBatch batch;
  for (std::size_t s = 0; s < kSprings; ++s) {
    batch.a.push_back(static_cast<Index>(random() % kNodes));
    batch.b.push_back(static_cast<Index>(random() % kNodes)); // now and then the same node: zero length
    batch.restLength.push_back(uniform(0.1, 2.0));
    batch.stiffness.push_back(uniform(1, 1000));
    batch.viscosity.push_back(uniform(0.1, 1));
    batch.parameter.push_back(uniform(0.5, 8));
    batch.spring.push_back(static_cast<Index>(s));
  }
  struct Law {
    SpringLaw law;
    const SpringLawKernel *chosen, *plain;
  };
  const Law laws[] = {{SpringLaw::Linear, &linearLaw(), &plainLinearLaw()},
                      {SpringLaw::Cubic, &cubicLaw(), &plainCubicLaw()},
                      {SpringLaw::Exponential, &exponentialLaw(), &plainExponentialLaw()}};
  for (const auto& [law, chosen, plain] : laws)
    for (const bool damped : {false, true})
      for (const bool tensionOnly : {false, true}) {
        batch.law = law;
        batch.finish();
        batch.damped = damped;
        batch.tensionOnly = tensionOnly;
        NodeArray first(kNodes, Lanes{0, 0, 0, 0}), second = first;
        NodeArray kept(damperSize(batch)), keptPlain = kept;
        const SpringSums a = chosen->addForces(batch, x.data(), v.data(), first.data(), kept.data());
        const SpringSums b = plain->addForces(batch, x.data(), v.data(), second.data(), keptPlain.data());
        EXPECT_TRUE(kept.empty() ||
                    std::memcmp(kept.data(), keptPlain.data(), kept.size() * sizeof(Lanes)) == 0);
        addDamping(batch, kept.data(), v.data(), first.data());
        plainAddDamping(batch, kept.data(), v.data(), second.data());
        EXPECT_EQ(std::memcmp(first.data(), second.data(), kNodes * sizeof(Lanes)), 0);
        EXPECT_EQ(a.heat, b.heat);
        EXPECT_EQ(a.degenerate, b.degenerate);
      }
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
  std::vector<Index> all(static_cast<std::size_t>(net.springCount()));
  std::iota(all.begin(), all.end(), Index{0});
  std::vector<Index> order = conflictFreeOrder(net, all);
  std::vector<std::ptrdiff_t> lastUse(static_cast<std::size_t>(net.nodeCount()), -100);
  int close = 0;
  for (std::ptrdiff_t place = 0; place < std::ssize(order); ++place)
    for (int end = 0; end < 2; ++end) {
      auto& last = lastUse[static_cast<std::size_t>(net.ends(end, order[static_cast<std::size_t>(place)]))];
      close += place - last < 12 ? 1 : 0;
      last = place;
    }
  EXPECT_LT(close, 20);
  std::sort(order.begin(), order.end());
  EXPECT_EQ(order, all);
}

} // namespace testing
} // namespace esm
