// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/project/project.h"

#include <QStringList>

namespace esm {

/// The organs that came with the program, the one to start with first: a project, or a mesh that has none.
/// Looked for in $ESM_RESOURCES, beside the installed program (../share/esm) and above a build folder
/// (resources/).
QStringList sampleFiles();
QString sampleTitle(const QString& file); ///< in the window's language

/// Any file without questions: a project as it is, a mesh in mm, z up, with the default tissue.
Result<Project> projectFromFile(const QString& path);
bool isProjectFile(const QString& path); ///< by its ending: esm, esmb or json

} // namespace esm
