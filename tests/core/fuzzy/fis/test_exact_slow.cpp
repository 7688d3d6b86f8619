// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/core/fuzzy/fis/exact_reference.h"

#include <cstdio>

namespace esm::fis {

TEST(ExactAreaSlow, AgreesWithAnIndependentQuadratureOnTenThousandSystems)
{
  const Deviation worst = compare(10000, 100000);
  EXPECT_LE(worst.noise, 10);
  std::printf("%d centroids and %d bisectors; %d maxima; %d without a reference\n", worst.centroids,
              worst.bisectors, worst.maxima, worst.noise);
}

} // namespace esm::fis
