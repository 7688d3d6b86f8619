// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "bench/reference/fast_net.h"

#include <string>
#include <utility>
#include <vector>

namespace esm::bench {

/// What this machine allows a force pass at best: its arithmetic alone on data in registers and L1, its
/// division and square root alone, and the memory stream alone of a net far larger than the caches.
class Limits {
public:
  Limits();
  void registerAll(); ///< as Google Benchmarks, named as in springsPerPass()
  const std::vector<std::pair<std::string, double>>& springsPerPass() const { return m_springs; }

private:
  std::vector<std::pair<std::string, double>> m_springs;
  Nodes m_lanes;                ///< stretch, turn and parameters of 512 springs
  std::vector<double> m_stream; ///< 192 MB
};

} // namespace esm::bench
