// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/core/fuzzy/rule_mutations.h"

namespace esm::fuzzy {

#ifdef ESM_SANITIZED
constexpr int kTexts = 20'000; // as they take twenty times as long
#else
constexpr int kTexts = 100'000;
#endif

TEST(DamagedRules, ThousandsEndInARuleOrAnError)
{
  feedDamagedRules(kTexts);
}

} // namespace esm::fuzzy
