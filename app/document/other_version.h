// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QString>

namespace esm {

/// A free name beside the project's file (behind links), which no save uses, for the version that somebody else
/// has written: "organ.esm.other.bak", "organ.esm.other2.bak", ...
QString nameForOtherVersion(const QString& project);

/// Gives what stands at `project` this name, too; nothing where nothing stands. Errors: FileUnwritable, also
/// where the name is taken by now; FileUnreadable.
Status keepOtherVersion(const QString& project, const QString& name);

} // namespace esm
