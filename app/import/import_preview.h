// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/import/defect_places.h"
#include "core/quality/quality.h"
#include "core/tissue/tissue_model.h"
#include "meshimport/net_import.h"

#include <cstdint>
#include <vector>

namespace esm {

/// What a net will cost once it runs.
struct NetPrediction {
  std::uint64_t bytes = 0; ///< of memory, that the window takes with it
  double step = 0.0;       ///< largest stable explicit step [s]; 0: not known
  double realTime = 0.0;   ///< simulated seconds per second, with explicit steps on one core; 0: not known
};

/// A net as an import would make it now, with what is to be shown of it before it is taken.
struct ImportPreview {
  ImportedNet made;
  TissueModel tissue; ///< that was asked for, with the numbers of the recipe's material
  NetPrediction prediction;
  std::vector<DefectGroup> defects; ///< of the files, before any repair
  QualityReport quality; ///< of the net with its tissue; without findings if that cannot be applied
};

/// makeNet() and what follows from it, for a thread of its own.
/// @param tissue with the recipe's material gives the springs the stiffness that the step is predicted from;
/// the net in the preview keeps the numbers of makeNet(). Errors: those of tissueOf() and makeNet().
Result<ImportPreview> makePreview(const MeshSource& source, const ImportRecipe& recipe,
                                  const TissueModel& tissue, WorkControl* control);

} // namespace esm
