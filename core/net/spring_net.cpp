// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/net/spring_net.h"

#include <algorithm>

namespace esm {

double medianRestLength(const SpringNet& net)
{
  std::vector<double> lengths(net.restLength.begin(), net.restLength.end());
  if (lengths.empty()) return 0.0;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

} // namespace esm
