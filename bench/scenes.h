// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/forces/loads.h"
#include "core/net/spring_net.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace esm::bench {

inline constexpr double kFrameRate = 60.0; ///< [1/s]

/// A net with its loads and the time that is looked at, sixty frames a second. All loads start, bend and end
/// on frames.
struct Scene {
  std::string name;
  SpringNet net;
  Loads loads;
  double duration = 1.0;   ///< [s]
  double finestStep = 0.0; ///< of an own reference, where a bench makes one with fixed steps [s]

  long frames() const noexcept;
};

/// What makes a variant of a scene: another draw of its parameters, another number of nodes.
struct SceneOptions {
  unsigned seed = 0;     ///< 0 = the scene's own
  double size = 1.0;     ///< nodes, relative to the scene's own; same organ, finer net
  double duration = 0.0; ///< [s]; 0 = the scene's own
};

/// A fallopian tube: 400 nodes, 1,160 springs of 23 to 75 N/m, both ends fixed, bedded softly; a ring in the
/// middle is pulled aside by 20 mm in 0.2 s and let go. Linear.
Scene tube(const SceneOptions& options = {});
/// A uterus: a closed surface of 1,250 nodes and 3,744 springs that stiffen exponentially, bedded softly,
/// pressed with 1 N on a patch of 1 cm. The net is irregular: its poles join 48 springs.
Scene uterus(const SceneOptions& options = {});
/// The same with linear springs, for the kernel.
Scene uterusLinear();
/// A sheet of 100 x 100 nodes that hangs in a frame and is blown at. Linear.
Scene sheet(const SceneOptions& options = {});
/// The sheet with 25 x 25 nodes.
Scene smallSheet();
/// A tube whose springs span six decades of stiffness, 1 to 1e6 N/m, its nodes four of mass, 1e-6 to 1e-2 kg,
/// its dampers 1e-4 to 5 N s/m. All springs pull with the same force and the bedding balances it, so that it
/// starts at rest and no spring buckles; then it is pushed aside softly.
Scene stiff(const SceneOptions& options = {});
/// A geodesic ellipsoid of 100,002 nodes and 300,000 springs, cubic, bedded softly, poked on a patch of 1 cm.
/// 0.2 s, so that the whole bench stays bearable; "organ100k:time=1" for more.
Scene organ100k(const SceneOptions& options = {});

/// "tube", "uterus:seed=7,size=2", "organ100k:time=1". Errors: InvalidValue for a name or an option that does
/// not exist.
Result<Scene> makeScene(std::string_view text);
std::vector<std::string> sceneNames();

/// Of everything that the motion depends on; names the files of cached references.
std::uint64_t hashOf(const Scene& scene);

} // namespace esm::bench
