// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/core/fuzzy/fis/exact_reference.h"

#include <cstdio>

namespace esm::fis {

TEST(ExactAreaSlow, AgreesWithAnIndependentQuadratureOnTenThousandSystems)
{
  const Deviation worst = compare(10000, 100000);
  EXPECT_LE(worst.grazing, (worst.centroids + worst.bisectors) / 500);
  std::printf("%d centroids and %d bisectors, of which %d beyond 1e-12; %d maxima; %d without a reference\n",
              worst.centroids, worst.bisectors, worst.grazing, worst.maxima, worst.noise);
}

} // namespace esm::fis
