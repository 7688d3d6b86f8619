// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/loads.h"
#include "core/net/spring_net.h"

#include <string>
#include <vector>

namespace esm::bench {

/// A net with its loads and the time that is looked at, sixty frames a second.
struct Scene {
  std::string name;
  SpringNet net;
  Loads loads;
  double duration = 1.0;   ///< [s]
  double finestStep = 0.0; ///< of the reference [s]: far below any stability limit of the scene
};

/// A fallopian tube: 400 nodes, 1,160 springs of 23 to 75 N/m, both ends fixed, bedded softly; a ring in the
/// middle is pulled aside by 20 mm in 0.2 s and let go. Linear.
Scene tube();
/// A uterus: a closed surface of 1,250 nodes and 3,744 springs that stiffen exponentially, bedded softly,
/// pressed with 1 N on a patch of 1 cm.
Scene uterus();
/// A sheet of 625 nodes that hangs from its upper edge and is blown at. Linear.
Scene smallSheet();

std::vector<Scene> allScenes();

} // namespace esm::bench
