// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

namespace esm {

/// Of a display [s]. Accuracy, cost and rest are judged over stretches of at most this length.
inline constexpr double kFrame = 1.0 / 60.0;

} // namespace esm
