// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string>

namespace esm {

/// What the engine says of its choices and troubles (Simulation::why(), English), in the window's language.
/// The sentence is taken apart at its semicolons; a clause that is not known here stays as it is.
QString reasonText(const std::string& reason);

} // namespace esm
