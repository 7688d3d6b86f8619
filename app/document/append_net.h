// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/net/spring_net.h"

namespace esm {

/// Adds a second net beside the first: its nodes, springs and triangles come after the former ones and get
/// ids above them; nothing of the first moves. The added net must be fresh from an import (no tables, no
/// anchors but bands). Where its material is another one, its springs get sections of their own that make
/// them as stiff.
/// @param thickness of the wall [m], TissueModel::thickness.
void appendNet(SpringNet& net, const SpringNet& added, double thickness);

} // namespace esm
