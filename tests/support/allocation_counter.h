// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace esm::test {

/// How often this thread has called operator new so far.
std::uint64_t allocationsOfThisThread() noexcept;

} // namespace esm::test
