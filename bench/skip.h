// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace esm::bench {

/// What leaving out resting nodes gains and costs, as CSV on stdout. Without words all parts:
///
///     local    an overdamped, softly bedded organ of 100,002 nodes under a slow tool, against the full run
///     struck   an organ of 10,002 nodes is struck, rings, settles, is touched again
///     growth   one poke on nets of 10,000 to 300,000 nodes, and pokes of growing size on one net
///
/// @return exit code.
int runSkip(const std::vector<std::string>& words);

} // namespace esm::bench
