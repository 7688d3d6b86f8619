// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <string>

namespace esm {

/// What a stick or wheel gives at 100 %, as the profile in force says [N]: it cannot tell by itself.
Result<double> newtonsAtFull(const std::string& kind);

/// Writes it into the user's own profile; all else in the file stays. Holds from the next connection on.
/// Errors: FileUnreadable, BadFormat (the file is no JSON object), FileUnwritable.
Status setNewtonsAtFull(const std::string& kind, double newtons);

} // namespace esm
