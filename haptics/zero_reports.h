// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

namespace esm {

/// How often zero force is sent wherever force ends: one report may be lost.
inline constexpr int kZeroReports = 3;

} // namespace esm
