// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "bench/scenes.h"

namespace esm::bench {

/// A scene to judge GrowthWatch by, and what was foretold of it before it was run for the first time. Whoever
/// tunes the watch by these has to write others.
struct HeldOutScene : Scene {
  bool foretold = false; ///< that it multiplies errors by a hundred and more
  bool isFresh = false;  ///< nothing was changed for what it showed
};

/// Seven that should (pendulums, a whip, shallow roofs that snap through, balls that collide in a cage) and
/// eleven that should not (poked organs, rung ones, a block that sags, a hanging hammock, a rope that swings,
/// pulled tubes, blown sheets, the one of the bench in full among them).
std::vector<HeldOutScene> heldOutScenes();

} // namespace esm::bench
