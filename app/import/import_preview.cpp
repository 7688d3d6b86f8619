// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/import/import_preview.h"

#include "core/support/net_cost.h"
#include "core/tissue/tissue_derivation.h"

namespace esm {

namespace {

// Project, its shared copy, the simulation with its frames, and the picture, all together.
constexpr std::uint64_t kBytesPerNode = 600, kBytesPerSpring = 400, kBytesPerTriangle = 60;
constexpr double kSecondsPerSpring = 5e-9; ///< of an explicit step, on one core

NetPrediction predictMemory(const SpringNet& net)
{
  NetPrediction prediction;
  prediction.bytes = kBytesPerNode * static_cast<std::uint64_t>(net.nodeCount()) +
                     kBytesPerSpring * static_cast<std::uint64_t>(net.springCount()) +
                     kBytesPerTriangle * static_cast<std::uint64_t>(net.triangleCount());
  return prediction;
}

} // namespace

Result<ImportPreview> makePreview(const MeshSource& source, const ImportRecipe& recipe,
                                  const TissueModel& tissue, WorkControl* control)
{
  Result<ImportedNet> made = makeNet(source, recipe, control);
  if (!made) return made.error();
  if (stopWanted(control)) return cancelledError();
  ImportPreview preview;
  Mesh mesh = source.mesh;
  toScene(mesh, recipe.unit, recipe.up, recipe.patientAxes);
  const MeshDefects defects = findDefects(mesh, recipe.repair.tJunctionTolerance, control);
  if (stopWanted(control)) return cancelledError();
  preview.defects = defectPlaces(mesh, defects);
  preview.prediction = predictMemory(made->net);
  // Tissue cannot be applied in the middle of an edit of its rules; then nothing is said of its numbers.
  if (SpringNet net = made->net; applyTissue(tissue, net)) {
    if (Result<QualityReport> quality = judgeNet(net, control)) preview.quality = std::move(quality).value();
    if (stopWanted(control)) return cancelledError();
    const NetCost cost = predictCost(net);
    preview.prediction.step = cost.step;
    if (cost.work > 0.0) preview.prediction.realTime = 1.0 / (kSecondsPerSpring * cost.work);
  }
  preview.made = std::move(made).value();
  return preview;
}

} // namespace esm
