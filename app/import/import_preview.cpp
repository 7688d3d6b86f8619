// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/import/import_preview.h"

#include "core/structure/net_cost.h"
#include "core/tissue/tissue_derivation.h"

namespace esm {

namespace {

constexpr double kIntersectionTime = 0.5;  ///< of the search for them in a preview [s]
constexpr double kSecondsPerSpring = 5e-9; ///< of an explicit step, on one core

} // namespace

Result<ImportPreview> makePreview(const MeshSource& source, const ImportRecipe& recipe,
                                  const TissueModel& tissue, WorkControl* control)
{
  Result<TissueModel> wished = tissueOf(recipe.material, tissue);
  if (!wished) return wished.error();
  Result<ImportedNet> made = makeNet(source, recipe, wished->thickness, control);
  if (!made) return made.error();
  if (stopWanted(control)) return cancelledError();
  ImportPreview preview;
  Mesh mesh = source.mesh;
  toScene(mesh, source.frame(recipe));
  const MeshDefects defects = findDefects(mesh, recipe.repair.tJunctionTolerance, control);
  if (stopWanted(control)) return cancelledError();
  const SelfIntersections crossings =
    findSelfIntersections(mesh, kIntersectionTime, kMostDefects + 1, control);
  if (stopWanted(control)) return cancelledError();
  preview.defects = defectPlaces(mesh, defects, crossings);
  preview.prediction.bytes = predictMemory(made->net).window;
  // Tissue cannot be applied in the middle of an edit of its rules; then nothing is said of its numbers.
  if (SpringNet net = made->net; applyTissue(*wished, net)) {
    if (Result<QualityReport> quality = judgeNet(net, control)) preview.quality = std::move(quality).value();
    if (stopWanted(control)) return cancelledError();
    const NetCost cost = predictCost(net);
    preview.prediction.step = cost.step;
    if (cost.work > 0.0) preview.prediction.realTime = 1.0 / (kSecondsPerSpring * cost.work);
  }
  preview.made = std::move(made).value();
  preview.tissue = std::move(wished).value();
  return preview;
}

} // namespace esm
