// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/core/fuzzy/fis/mutations.h"

#include <cstdio>

namespace esm::fis {

TEST(DamagedFiles, AHundredThousandEndInASystemOrAnError)
{
  const int fed = feedDamagedTexts(100000, std::chrono::seconds(60));
  std::printf("%d damaged texts\n", fed);
  EXPECT_GT(fed, 1000); // slower machines and sanitizers reach fewer within the minute
}

} // namespace esm::fis
