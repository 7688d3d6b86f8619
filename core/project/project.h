// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/solver_settings.h"
#include "core/forces/loads.h"
#include "core/net/spring_net.h"
#include "core/project/import_recipe.h"
#include "core/tissue/tissue_model.h"

#include <string>
#include <vector>

namespace esm {

/// Where a picture is taken from. Saved with the project, but not part of undo.
struct ViewSettings {
  Eigen::Vector3d target = Eigen::Vector3d::Zero(); ///< orbit centre [m]
  double distance = 0.0;                            ///< [m]; 0 = fit to the net
  double azimuth = 0.6;                             ///< [rad] about z
  double elevation = 0.4;                           ///< [rad] above the xy plane
  std::string colouring = "stiffness";              ///< none, stiffness, strain or force
  bool showSurface = true, showSprings = true;
  bool showStruts = false; ///< of the support layer: thousands of them cover the organ
};

struct SimulationSettings {
  double duration = 2.0;   ///< [s] of the loads' story
  double frameRate = 60.0; ///< [1/s]
  SolverSettings solver;
};

/// The whole document: what `.esm` holds and undo works on. Plain data. SI units.
struct Project {
  std::string name;
  ImportRecipe source;              ///< how the geometry came in
  SpringNet net;                    ///< with its parameters, so that it runs without inference
  bool parametersFromTissue = true; ///< false: the net brought its own (esm-net-1); tissue is then idle
  TissueModel tissue;
  Loads loads;
  SimulationSettings simulation;
  ViewSettings view;
};

inline constexpr int kSchemaVersion = 1;

} // namespace esm
