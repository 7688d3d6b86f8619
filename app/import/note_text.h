// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string>

namespace esm {

/// What readers, repair and supports tell of an import (ImportedNet::notes, English, with options of the
/// command line), in the words and the language of the window. One that is not known stays as it is.
QString importNoteText(const std::string& note);

} // namespace esm
