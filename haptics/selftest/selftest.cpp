// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/selftest/selftest.h"

#include <iterator>

namespace esm {

std::vector<SelftestRow> runSelftest()
{
  std::vector<SelftestRow> rows;
  for (const auto part :
       {selftestKinematics, selftestWalls, selftestEnergy, selftestTissue, selftestLimits}) {
    std::vector<SelftestRow> more = part();
    rows.insert(rows.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  }
  return rows;
}

} // namespace esm
