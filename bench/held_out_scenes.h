// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "bench/scenes.h"

namespace esm::bench {

/// A scene that no constant of GrowthWatch was chosen by, and what was foretold of it before it was run for
/// the first time. Whoever tunes the watch by these has to write others.
struct HeldOutScene : Scene {
  bool foretold = false; ///< that it multiplies errors by a hundred and more
};

/// Five that should (pendulums, a whip, shallow roofs that snap through, balls that collide in a cage) and
/// seven that should not (a poked organ, a rung one, a block that sags, a hanging hammock, a rope that swings,
/// a pulled tube, the blown sheet of the bench in full).
std::vector<HeldOutScene> heldOutScenes();

} // namespace esm::bench
