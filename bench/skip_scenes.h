// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "bench/scenes.h"

namespace esm::bench {

struct SkipScene : Scene {
  Index touched = 0;             ///< a node where the tool is
  std::string reference = "rk4"; ///< the method that makes the reference with fixed steps
};

/// A closed surface of about `nodes` nodes, 0.7 mm apart whatever their number, and three springs to a node:
/// stretched over its content and bedded so softly that a poke dies out within some ten springs, and so
/// viscously that nothing swings. A tool of `radius` springs presses and glides at 2 cm/s.
SkipScene pressedOrgan(Index nodes, double radius, double duration);

/// The same surface, hardly damped, struck for 5 ms: waves go all around, then it settles.
SkipScene struckOrgan(Index nodes, double duration);

} // namespace esm::bench
