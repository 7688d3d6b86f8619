// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/spring_law.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <utility>

namespace esm {
const SpringLawKernel& plainLinearLaw() noexcept;
const SpringLawKernel& plainCubicLaw() noexcept;
const SpringLawKernel& plainExponentialLaw() noexcept;

namespace testing {

// Golden hashes must hold on every x86-64: the version that the loader chooses here (AVX2 where the CPU has
// it) and the plain one give the same bits for forces and heat.
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
  batch.count = kSprings;
  for (std::size_t s = 0; s < kSprings; ++s) {
    batch.a.push_back(static_cast<Index>(random() % kNodes));
    batch.b.push_back(static_cast<Index>(random() % kNodes)); // now and then the same node: zero length
    batch.restLength.push_back(uniform(0.1, 2.0));
    batch.stiffness.push_back(uniform(1, 1000));
    batch.viscosity.push_back(uniform(0.1, 1));
    batch.parameter.push_back(uniform(0.5, 8));
    batch.spring.push_back(static_cast<Index>(s));
  }
  const std::pair<const SpringLawKernel*, const SpringLawKernel*> pairs[] = {
    {&linearLaw(), &plainLinearLaw()},
    {&cubicLaw(), &plainCubicLaw()},
    {&exponentialLaw(), &plainExponentialLaw()}};
  for (const auto& [chosen, plain] : pairs)
    for (const bool damped : {false, true})
      for (const bool tensionOnly : {false, true}) {
        batch.damped = damped;
        batch.tensionOnly = tensionOnly;
        NodeArray first(kNodes, Lanes{0, 0, 0, 0}), second = first;
        const SpringSums a = chosen->addForces(batch, x.data(), v.data(), first.data());
        const SpringSums b = plain->addForces(batch, x.data(), v.data(), second.data());
        EXPECT_EQ(std::memcmp(first.data(), second.data(), kNodes * sizeof(Lanes)), 0);
        EXPECT_EQ(a.heat, b.heat);
        EXPECT_EQ(a.degenerate, b.degenerate);
      }
}

} // namespace testing
} // namespace esm
