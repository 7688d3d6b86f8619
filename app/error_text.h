// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QString>

namespace esm {

/// What happened, in the window's language: one sentence for the kind of fault.
QString errorLead(ErrorCode code);

/// The lead sentence and below it the detail, which names file, place and way out (English).
QString errorText(const Error& error);

} // namespace esm
