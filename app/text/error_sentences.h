// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace esm {

/// What core and readers say in errors that users meet, clause by clause, with %1, %2 ... for the parts that
/// vary; translations are in the context "esm::ErrorDetail".
std::span<const char* const> errorSentences();

} // namespace esm
