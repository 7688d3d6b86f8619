// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/reference/method.h"

namespace esm::bench {

const std::vector<MethodEntry>& competitors()
{
  static const std::vector<MethodEntry> table = {
    {"ref-symplectic-euler", false, false, false, 0, &makeSymplecticEuler},
    {"ref-verlet", false, false, false, 0, &makeVelocityVerlet},
    {"ref-rk4", false, false, false, 0, &makeClassicalRungeKutta},
    {"ref-dormand-prince", true, false, false, 0, &makeDormandPrince},
    {"ref-baraff-witkin-pcg", false, true, true, 20'000, &makeBaraffWitkinPcg},
    {"ref-baraff-witkin-cholesky", false, true, true, 20'000, &makeBaraffWitkinCholesky},
    {"ref-fast-mass-springs", false, true, true, 20'000, &makeFastMassSprings},
    {"ref-xpbd", false, true, true, 20'000, &makeXpbd},
#if defined(ESM_BENCH_SUNDIALS)
    {"cvode-bdf-cholesky", true, true, true, 20'000, &makeCvodeCholesky},
    {"arkode-dirk4-cholesky", true, true, true, 20'000, &makeArkodeCholesky},
    {"arkode-dormand-prince", true, false, true, 20'000, &makeArkodeExplicit},
    {"cvode-bdf-klu", true, true, true, 2'000, &makeCvodeKlu},
    {"arkode-dirk4-klu", true, true, true, 2'000, &makeArkodeKlu},
#endif
  };
  return table;
}

} // namespace esm::bench
