// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/scene_frame.h"

#include <QString>

class QWidget;

namespace esm {

/// The unit in which a body of this extent, as the file writes it, would have a usual size; nothing: none.
std::optional<LengthUnit> likelyUnit(double extent);

/// "With the unit mm it would be 30 mm large." Empty if no unit is likely.
QString likelyText(double extent);

enum class UnitAnswer { Keep, UseLikely, Cancel };

/// Whether a body of `extent` units of the file, `metres` large, may really be so.
UnitAnswer askAboutUnit(double extent, double metres, QWidget* parent);

} // namespace esm
