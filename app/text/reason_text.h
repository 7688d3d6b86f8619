// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <span>
#include <string>

namespace esm {

/// A sentence that a library is known to say, as a regular expression whose groups are the places of the
/// text.
struct KnownSentence {
  const char* pattern;
  const char* text; ///< English, marked for translation in the context it is looked up in
};

/// The sentence in the window's language; one that is not known stays as it is.
QString translated(const QString& sentence, std::span<const KnownSentence> known, const char* context);

/// What the engine says of its choices and troubles (Simulation::why(), English), in the window's language.
/// The sentence is taken apart at its semicolons; a clause that is not known here stays as it is.
QString reasonText(const std::string& reason);

} // namespace esm
