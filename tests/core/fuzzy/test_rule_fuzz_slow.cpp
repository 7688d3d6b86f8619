// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/core/fuzzy/rule_mutations.h"

namespace esm::fuzzy {

TEST(DamagedRules, AHundredThousandEndInARuleOrAnError)
{
  feedDamagedRules(100000);
}

} // namespace esm::fuzzy
