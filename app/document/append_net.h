// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/net/spring_net.h"

namespace esm {

/// Adds a second net beside the first: its nodes, springs and triangles come after the former ones and get
/// ids above them; nothing of the first moves. The added net must be fresh from buildNet() (no anchors, no
/// tables).
void appendNet(SpringNet& net, const SpringNet& added);

} // namespace esm
